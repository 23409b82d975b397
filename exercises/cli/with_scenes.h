// Mechanisms from files, named on the command line like exercises: epure check my.yaml, epure check watt-six-bar;
// "scenes" stands for all that are shipped.
#pragma once

#include <memory>
#include <vector>

#include "exercises/cli/options.h"
#include "exercises/kit/proof/exercise.h"
#include "exercises/scenes/scene.h"

namespace epure {

// Whether any name is that of a scene file.
bool names_scenes(const Options& options);

// The exercises of the files, and the same options with their ids for names. Throws BadScene; WrongUsage for names of
// other exercises beside them, and for two files of one id.
struct Scenes {
  Catalogue exercises;
  Options options;
  std::vector<std::shared_ptr<const scenes::Scene>> files = {};  // none where it is a truss
};
Scenes read_scenes(const Options& options);

// What looks wrong in the files at these givens, though nothing forbids it.
std::vector<Words> remarks(const Scenes& read);

}  // namespace epure
