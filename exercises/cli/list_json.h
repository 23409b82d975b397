// What exercises there are, for programs.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/proof/exercise.h"

namespace epure {

// Schema epure.list/1: of each exercise its sheets, givens and quantities. Its words are English.
std::string json_list(const std::vector<const Exercise*>& exercises);

}  // namespace epure
