// Where a growing function of a positive number is zero.
#pragma once

#include <functional>

#include "geometry/numbers/deep.h"

namespace epure::geometry {

// The zero x of `function`, proved by its signs on both sides: as `function` grows (the caller's promise), there is
// no other. It is sought between 2^low and 2^high. Throws Undecided when it is not found there, or the function is
// known too badly. `function` is asked at points, with as many bits as are open.
Deep increasing_root(const std::function<Deep(const Deep&)>& function, double low, double high);

}  // namespace epure::geometry
