// Whether an enclosure has a point in common with a reference that is known up to an error.
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

#include <cmath>

namespace epure::tests {

inline bool overlaps(const geometry::Enclosure& x, const geometry::Rational& reference,
                     const geometry::Rational& error) {
  using geometry::Rational;
  const bool above = std::isinf(x.lower) || Rational(x.lower) <= reference + error;
  return above && (std::isinf(x.upper) || Rational(x.upper) >= reference - error);
}

// With the whole ball, not its doubles.
inline bool overlaps(const geometry::Deep& x, const geometry::Rational& reference, const geometry::Rational& error) {
  using namespace geometry;
  const Deep difference = x - from_rational<Deep>(reference), off = from_rational<Deep>(error);
  return sign(difference + off) != Sign::negative && sign(difference - off) != Sign::positive;
}

}  // namespace epure::tests
