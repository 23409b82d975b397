#include "geometry/gears/involute.h"

#include "geometry/numbers/ball.h"

#include <algorithm>
#include <cmath>

namespace epure::geometry {
namespace {

// Below this tangent the series is summed: t - arctan t would lose more than 6 bits.
constexpr double series_below = 0.25;
// t² <= 1/16, so 14 terms leave less than 16⁻¹⁴/31 of t³, which is 2⁻⁵⁹ of the sum.
constexpr int terms = 14;

// 1/3 - t²/5 + ... , the terms named above, and the size of the next, which bounds what is left out: the series
// alternates and its terms decrease.
template <class T>
struct Series {
  T sum, next;
};
template <class T>
Series<T> over_cube(const T& t) {
  const T square_t = square(t);
  T sum(0), power(1);
  for (int k = terms - 1; k >= 0; --k) {
    sum = quotient(T(1), T(2 * k + 3)) - square_t * sum;
    power = power * square_t;
  }
  return {sum, quotient(power, T(2 * terms + 3))};
}

// At one double, as an interval.
Bounded involute_at(double t) {
  const Bounded at(t);
  if (t >= series_below) return at - arc_tangent(at, Bounded(1));
  const auto [sum, next] = over_cube(at);
  return at * square(at) * (sum + Bounded(0, next.sup()));  // terms is even: what is left out begins with a plus
}

double slope_at(double t) { return 1 / (1 + 1 / (t * t)); }

// A double near the tangent. From above 1 the start t = inv + π/2 lies right of the root, as inv = t - arctan t; the
// function is convex, so Newton's steps come down from there. Below, the first step from t³ = 3 inv goes to the
// right of the root.
double near_tangent(double involute_value) {
  double t = involute_value > 1 ? involute_value + 1.5707963267948966 : std::cbrt(3 * involute_value);
  // Quadratic from a start that is within a third of the root.
  for (int step = 0; step < 8; ++step) t -= (involute(t) - involute_value) / slope_at(t);
  return t;
}

// The tangent around a point `near` it, by Newton's method with intervals: where the step from `near`, divided by all
// slopes of the neighbourhood, stays in the neighbourhood, the only root of it lies at the step's end.
template <class T>
T proved(const T& near, const T& involute_value, const T& neighbourhood) {
  const T around = widened(near, neighbourhood);
  if (sign(around) != Sign::positive)
    throw Undecided("an involute function so wide that its angle may be zero",
                    "una funzione involuta tanto incerta che il suo angolo può essere zero");
  const T one_over_slope = T(1) + quotient(T(1), square(around));
  const T step = (involute(near) - involute_value) * one_over_slope;
  for (const T& room : {neighbourhood - step, neighbourhood + step})
    if (const Sign stays = sign(room); stays == Sign::negative || stays == Sign::undecided)
      throw Undecided("an involute function too wide to be inverted",
                      "una funzione involuta troppo incerta per essere invertita");
  return near - step;
}

// A length that no point of the first Newton step exceeds, doubled.
double twice_step(const Bounded& difference, double slope) {
  const Bounded step = Bounded(2) * CGAL::abs(difference) / Bounded(slope);
  return step.sup();
}

void require_positive(Sign of_involute) {
  if (of_involute != Sign::positive)
    throw Undecided("whether an involute function is zero", "se una funzione involuta sia zero");
}

// At one point t > 0, with twice the bits that the subtraction eats up, t³/3 of t being left.
void involute_at(arb_t result, const arf_t t) {
  const long lost = 2 * std::max(0L, -ARF_EXP(t)) + 8, bits = Arithmetic<Deep>::bits() + lost;
  Ball at;
  arb_set_arf(at.value, t);
  arb_atan(result, at.value, bits);
  arb_sub(result, at.value, result, bits);
}

}  // namespace

Fast involute(Fast tangent) {
  if (tangent >= series_below) return tangent - std::atan(tangent);
  return tangent * tangent * tangent * over_cube(tangent).sum;
}

// It grows with the tangent: the ends of the one are the ends of the other.
Bounded involute(const Bounded& tangent) {
  return {involute_at(std::max(tangent.inf(), 0.0)).inf(), involute_at(tangent.sup()).sup()};
}

Deep involute(const Deep& tangent) {
  if (sign(tangent) == Sign::zero) return tangent;
  if (tangent.is_in_doubles()) return tangent - arc_tangent(tangent, Deep(1));
  const long bits = Arithmetic<Deep>::bits();
  Float lower, upper;
  arb_get_lbound_arf(lower.value, tangent.ball(), 2 * bits);
  arb_get_ubound_arf(upper.value, tangent.ball(), 2 * bits);
  Ball least, most;
  if (arf_sgn(lower.value) > 0) involute_at(least.value, lower.value);
  involute_at(most.value, upper.value);
  arb_union(most.value, least.value, most.value, bits);
  return Deep::from_ball(most.value);
}

Exact involute(const Exact& tangent) {
  if (tangent.is_zero()) return tangent;
  throw LeavesTheTower("an involute function", "una funzione involuta");
}

Generic involute(const Generic& tangent) {
  if (sign(tangent) == Sign::zero) return tangent;
  throw Undecided("an involute function is not algebraic", "una funzione involuta non è algebrica");
}

Calcium involute(const Calcium& tangent) {
  if (sign(tangent) == Sign::zero) return tangent;
  throw Undecided("an involute function is not algebraic", "una funzione involuta non è algebrica");
}

Fast tangent_of_involute(Fast involute_value) { return involute_value > 0 ? near_tangent(involute_value) : 0; }

Bounded tangent_of_involute(const Bounded& involute_value) {
  if (sign(involute_value) == Sign::zero) return 0;
  require_positive(sign(involute_value));
  const double near = near_tangent(midpoint(involute_value).inf());
  return proved(Bounded(near), involute_value,
                Bounded(twice_step(involute(Bounded(near)) - involute_value, slope_at(near))));
}

Deep tangent_of_involute(const Deep& involute_value) {
  if (sign(involute_value) == Sign::zero) return involute_value;
  require_positive(sign(involute_value));
  const Deep middle = midpoint(involute_value);
  Deep near = Deep::from_double(near_tangent(enclosure(middle).value));
  const auto step = [](const Deep& from, const Deep& value) {
    return (involute(from) - value) * (Deep(1) + quotient(Deep(1), square(from)));
  };
  // Every step doubles the digits, of which a double has some 50.
  if (!Arithmetic<Deep>::is_in_doubles())
    for (long bits = 40; bits < Arithmetic<Deep>::bits(); bits *= 2) near = midpoint(near - step(near, middle));
  const Bounded last = loose_bounds(step(near, involute_value));
  const double most = std::max(-last.inf(), last.sup());
  return proved(near, involute_value, Deep(2) * Deep::from_double(most));
}

Exact tangent_of_involute(const Exact& involute_value) { return involute(involute_value); }
Generic tangent_of_involute(const Generic& involute_value) { return involute(involute_value); }
Calcium tangent_of_involute(const Calcium& involute_value) { return involute(involute_value); }

}  // namespace epure::geometry
