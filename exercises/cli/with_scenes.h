// Mechanisms from files, named on the command line like exercises: epure check quick-return.yaml
#pragma once

#include "exercises/cli/options.h"
#include "exercises/kit/proof/exercise.h"

namespace epure {

// Whether any name is that of a scene file.
bool names_scenes(const Options& options);

// The exercises of the files, and the same options with their ids for names. Throws BadScene; WrongUsage for names of
// other exercises beside them, and for two files of one id.
struct Scenes {
  Catalogue exercises;
  Options options;
};
Scenes read_scenes(const Options& options);

}  // namespace epure
