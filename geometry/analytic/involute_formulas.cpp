#include "geometry/analytic/involute_formulas.h"

#include "geometry/numbers/ball.h"

#include <algorithm>
#include <cmath>

namespace epure::geometry::analytic {
namespace {

// Has the sign of tan α - α - involute.
Deep side_of(const Deep& angle, const Deep& involute) {
  return sine_of_angle(angle) - (angle + involute) * cosine_of_angle(angle);
}

Deep power_of_two(long exponent) {
  Deep result;
  Ball ball;
  arb_one(ball.value);
  arb_mul_2exp_si(ball.value, ball.value, exponent);
  return Deep::from_ball(ball.value);
}

// Newton's method on tan α - α, which is convex: from the right of the root it comes down to it.
//   tan α - α >= α³/3   and   tan α = involute + α <= involute + π/2
Deep near_root(const Deep& involute, double about, long bits) {
  Deep angle = Deep::from_double(std::min(std::cbrt(3 * about) * (1 + 1e-15), std::atan(about + 1.5707963267948967)));
  // At worst it begins with steps of a third; each step from within a third of the root doubles the digits.
  for (long step = 0; step < 12 + bits / 40; ++step) {
    const Deep s = sine_of_angle(angle), c = cosine_of_angle(angle);
    const Deep slope = quotient(square(s), square(c));
    angle = midpoint(angle - quotient(quotient(s, c) - angle - involute, slope));
  }
  return angle;
}

}  // namespace

Deep angle_of_involute(const Deep& involute) {
  if (sign(involute) == Sign::zero) return involute;
  if (sign(involute) != Sign::positive)
    throw Undecided("whether an involute function is zero", "se una funzione involuta sia zero");
  const long bits = Arithmetic<Deep>::bits();
  const Deep middle = midpoint(involute);
  const double about = enclosure(middle).value;
  // sin α - α cos α is of the third order in α: two orders of magnitude are lost in the subtraction.
  const long order = static_cast<long>(std::log2(std::cbrt(about))) - 1;
  const Arithmetic<Deep> more(bits + 3 * std::max(0L, -order) + 32);
  const Deep root = near_root(middle, about, bits);
  for (long wider = -bits - 4; wider < 0; wider += 4) {
    const Deep width = root * power_of_two(wider);
    if (sign(side_of(root - width, involute)) == Sign::negative &&
        sign(side_of(root + width, involute)) == Sign::positive)
      return widened(root, width);
  }
  throw Undecided("an involute function too wide to be inverted",
                  "una funzione involuta troppo incerta per essere invertita");
}

Bounded angle_of_involute(const Bounded& involute) {
  const Arithmetic<Deep> scope(128);
  return to_bounded(angle_of_involute(Deep::from_bounded(involute)));
}

Fast angle_of_involute(Fast involute) {
  const Arithmetic<Deep> scope(64);
  return enclosure(angle_of_involute(Deep::from_double(involute))).value;
}

}  // namespace epure::geometry::analytic
