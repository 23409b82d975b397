// Enclosures in doubles, for reporting.
#pragma once

#include "geometry/numbers/deep.h"
#include "geometry/numbers/number.h"

#include <optional>

namespace epure::geometry {

// lower <= true value <= upper, and lower <= value <= upper. An end may be infinite, none is NaN.
struct Enclosure {
  double lower = 0;
  double value = 0;
  double upper = 0;
};

// The interval itself; the value is its midpoint, not necessarily the double nearest to the true value. An interval
// without bounds on both sides has the value 0.
Enclosure enclosure(const Bounded& x);

// The ball rounded outwards to doubles. The value is certain_double where there is one, else the double nearest to
// the midpoint of the ball.
Enclosure enclosure(const Deep& x);

// The double nearest to the true value, when both ends of the ball round to the same finite double (to nearest, ties
// to even). Never the negative zero.
std::optional<double> certain_double(const Deep& x);

// The interval of doubles around the ball.
Bounded to_bounded(const Deep& x);

// Doubles around it that depend on how it was found: for proofs that end alike with any.
Bounded loose_bounds(const Deep& x);

// A point inside the enclosure, which must be bounded: a place to expand a function about.
Bounded midpoint(const Bounded& x);
Deep midpoint(const Deep& x);

// x and everything that is no farther from it than `by` >= 0 (its upper end counts).
Bounded widened(const Bounded& x, const Bounded& by);
Deep widened(const Deep& x, const Deep& by);

}  // namespace epure::geometry
