#include "geometry/numbers/increasing_root.h"

#include <cmath>

#include "geometry/numbers/ball.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry {
namespace {

Deep power_of_two(long exponent) {
  Ball ball;
  arb_one(ball.value);
  arb_mul_2exp_si(ball.value, ball.value, exponent);
  return Deep::from_ball(ball.value);
}

// 2^exponent, or a number beside it: a point.
Deep near_power(double exponent) {
  const double whole = std::floor(exponent);
  return Deep::from_double(std::exp2(exponent - whole)) * power_of_two(static_cast<long>(whole));
}

// From two points not farther than a fiftieth from it, or one that is not near: then it is not found.
Deep by_secants(const std::function<Deep(const Deep&)>& function, Deep x, Deep y) {
  constexpr int enough = 60;
  const Deep smallest_step = power_of_two(-Arithmetic<Deep>::bits());
  Deep at_x = midpoint(function(x)), last_moved;
  for (int step = 0; step < enough; ++step) {
    const Deep at_y = midpoint(function(y)), rise = midpoint(at_y - at_x);
    if (sign(rise) == Sign::zero) return y;
    const Deep next = midpoint(y - at_y * (y - x) / rise);
    if (sign(next) != Sign::positive) break;
    const Deep moved = next - y;
    x = y, at_x = at_y, y = next;
    if (sign(square(moved) - square(smallest_step * y)) != Sign::positive) return y;
    // Steps shrink until they are the function's own errors.
    if (step > 1 && sign(square(moved) - square(last_moved)) != Sign::negative) return y;
    last_moved = moved;
  }
  return y;
}

}  // namespace

Deep increasing_root(const std::function<Deep(const Deep&)>& function, double low, double high) {
  constexpr double near = 0.03;
  while (high - low > near) {
    const double middle = low + (high - low) / 2;
    (sign(midpoint(function(near_power(middle)))) == Sign::negative ? low : high) = middle;
  }
  const long bits = Arithmetic<Deep>::bits();
  const Deep root = by_secants(function, near_power(low), near_power(high));
  for (long wider = 6 - bits; wider < 0; wider += 6) {
    const Deep width = root * power_of_two(wider), below = midpoint(root - width), above = midpoint(root + width);
    if (sign(function(below)) == Sign::negative && sign(function(above)) == Sign::positive)
      return widened(root, Deep(2) * width);
  }
  throw Undecided("a function known too badly to tell its zero", "una funzione troppo incerta per dirne lo zero");
}

}  // namespace epure::geometry
