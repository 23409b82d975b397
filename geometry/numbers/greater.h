// The greater and the lesser of two balls: enclosed also where it cannot be told which that is.
#pragma once

#include "geometry/numbers/ball.h"

namespace epure::geometry {

inline Deep greater(const Deep& a, const Deep& b) {
  Ball result;
  arb_max(result.value, a.ball(), b.ball(), Arithmetic<Deep>::bits());
  return Deep::from_ball(result.value);
}
inline Deep lesser(const Deep& a, const Deep& b) { return -greater(-a, -b); }
inline Deep absolute(const Deep& x) {
  Ball result;
  arb_abs(result.value, x.ball());
  return Deep::from_ball(result.value);
}
// x, or the end of the interval that it is beyond.
inline Deep within(const Deep& low, const Deep& x, const Deep& high) { return lesser(greater(low, x), high); }

}  // namespace epure::geometry
