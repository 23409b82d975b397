// What --over and --vary ask for.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/variation.h"
#include "exercises/kit/proof/exercise.h"

namespace epure {

// One for each text such as "phi=0..360/361": of a given by its name, its letters or another name of it. `option` is
// how the user wrote it, "--over"; `assignments` are values that givens have already, as --set takes them. Throws
// WrongUsage: what is no given, varies twice or has a value already, itself or as the instant of an angle; what
// Variation cannot read.
std::vector<Variation> read_variations(const Exercise& exercise, const std::string& option,
                                       const std::vector<std::string>& typed,
                                       const std::vector<std::string>& assignments);

}  // namespace epure
