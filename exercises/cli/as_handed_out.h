// What the sheets of a class show, which may be drawn at another scale than the exercise's own.
#pragma once

#include <map>
#include <string>

#include "exercises/kit/proof/checked.h"

namespace epure {

// What these sheets show at these scales of lengths (1/5 for 1 : 5), in place of what they would at the largest one
// that fits. A sheet that cannot be drawn so is left as it is.
void measure_as_handed_out(CheckedExercise& checked, const Exercise& exercise,
                           const std::map<std::string, Rational>& scales);

}  // namespace epure
