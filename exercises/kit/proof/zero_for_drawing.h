// Which values that may be zero a drawing takes for zero.
#pragma once

#include <cmath>

#include "geometry/numbers/enclosure.h"

namespace epure {

inline bool may_be_zero(const geometry::Enclosure& ends) { return ends.lower <= 0 && ends.upper >= 0; }

// When it is no wider than a fifth of the bits worked with leave it: the root of zero keeps half of them, a root of
// that a fourth. Wider ones need more bits: beside a change point what looks like zero is none.
inline bool is_zero_for_drawing(const geometry::Enclosure& ends, long bits) {
  return may_be_zero(ends) && ends.upper - ends.lower <= std::ldexp(1.0, -static_cast<int>(bits / 5));
}

}  // namespace epure
