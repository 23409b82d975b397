#include "geometry/analytic/cancelling_functions.h"

#include <cmath>

#include "geometry/numbers/ball.h"
#include "geometry/numbers/growing.h"

namespace epure::geometry::analytic {

namespace {

// tan x - x.
void involute(arb_t result, const arb_t x, long bits) {
  arb_tan(result, x, bits);
  arb_sub(result, result, x, bits);
}

// (x + 1) ln x - 2 (x - 1).
void logarithms(arb_t result, const arb_t x, long bits) {
  Ball beyond, twice;
  arb_sub_si(twice.value, x, 1, bits);
  arb_log1p(result, twice.value, bits);
  arb_add_si(beyond.value, x, 1, bits);
  arb_mul(result, result, beyond.value, bits);
  arb_mul_2exp_si(twice.value, twice.value, 1);
  arb_sub(result, result, twice.value, bits);
}

// sinh(x)/x for x > 0. Arb's sinh is relatively accurate near 0; here nothing cancels.
void hyperbolic_sine_share(arb_t result, const arb_t x, long bits) {
  arb_sinh(result, x, bits);
  arb_div(result, result, x, bits);
}

}  // namespace

Fast tangent_less_angle(Fast alpha) { return std::tan(alpha) - alpha; }
Deep tangent_less_angle(const Deep& alpha) {
  const Deep right_angle = from_rational<Deep>(Rational(1, 2)) * pi<Deep>();
  if (sign(right_angle - alpha) != Sign::positive || sign(right_angle + alpha) != Sign::positive)
    throw Undecided("whether an angle is less than a right one", "se un angolo sia minore di un angolo retto");
  return growing(involute, alpha, 0, 0);
}
Bounded tangent_less_angle(const Bounded& alpha) {
  return in_doubles([&] { return tangent_less_angle(ball(alpha)); });
}

Fast logarithms_near_one(Fast n) { return (n + 1) * std::log(n) - 2 * (n - 1); }
Deep logarithms_near_one(const Deep& n) {
  if (sign(n) != Sign::positive)
    throw Undecided("whether a number that has a logarithm is positive",
                    "se un numero di cui si prende il logaritmo sia positivo");
  return growing(logarithms, n, 1, 0);
}
Bounded logarithms_near_one(const Bounded& n) {
  return in_doubles([&] { return logarithms_near_one(ball(n)); });
}

Fast exponentials_over_twice(Fast beta, Fast t) {
  return quotient(std::exp(beta * t) - std::exp(-beta * t), 2 * beta);
}
// t sinh(βt)/(βt): even in βt, and growing with its size.
Deep exponentials_over_twice(const Deep& beta, const Deep& t) {
  Ball size;
  arb_abs(size.value, (beta * t).ball());
  arb_nonnegative_part(size.value, size.value);
  return t * growing(hyperbolic_sine_share, Deep::from_ball(size.value), 0, 1);
}
Bounded exponentials_over_twice(const Bounded& beta, const Bounded& t) {
  return in_doubles([&] { return exponentials_over_twice(ball(beta), ball(t)); });
}

}  // namespace epure::geometry::analytic
