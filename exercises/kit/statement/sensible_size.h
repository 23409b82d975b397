// How large and how small a number may be that is stated: of a given in its unit, of a length in a scene in metres.
#pragma once

#include "geometry/numbers/given.h"

namespace epure {

// What stays inside is far from where doubles overflow: a fourth power of 1e12 times a million is still below 1e60.
inline const char* const smallest_size = "1e-12";
inline const char* const largest_size = "1e12";

// Zero, or between the two without its sign.
inline bool has_sensible_size(const Rational& value) {
  static const Rational smallest = geometry::parse_given(smallest_size, "1"),
                        largest = geometry::parse_given(largest_size, "1");
  const Rational size = CGAL::abs(value);
  return size == 0 || (size >= smallest && size <= largest);
}

}  // namespace epure
