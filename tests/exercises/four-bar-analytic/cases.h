// The exercise as its tests try it.
#pragma once

#include "tests/exercises/four_bar_on_x_cases.h"

namespace epure::tests {

inline const std::string id = "four-bar-analytic";

}  // namespace epure::tests
