// The involute function and its inverse in terms of the angle, for the second route.
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

// The angle α in [0, π/2) with tan α - α = involute >= 0 (the caller's promise), proved by the signs of
//   sin α - (α + involute) cos α
// on both sides of it. Throws Undecided when the enclosure of the involute is too wide for that. On Fast the double
// next to it.
Deep angle_of_involute(const Deep& involute);
Bounded angle_of_involute(const Bounded& involute);
Fast angle_of_involute(Fast involute);

// tan α - α for α in [0, π/2).
template <class T>
T involute_of_angle(const T& angle) {
  return quotient(sine_of_angle(angle), cosine_of_angle(angle)) - angle;
}

}  // namespace epure::geometry::analytic
