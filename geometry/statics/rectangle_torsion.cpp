#include "geometry/statics/rectangle_torsion.h"

namespace epure::geometry {
namespace {

Deep exponential(const Deep& x) {
  Ball result;
  arb_exp(result.value, x.ball(), Arithmetic<Deep>::bits());
  return Deep::from_ball(result.value);
}

// ζ(5) less its even terms.
Deep odd_fifth_powers() {
  Ball zeta;
  arb_zeta_ui(zeta.value, 5, Arithmetic<Deep>::bits());
  return from_rational<Deep>(Rational(31, 32)) * Deep::from_ball(zeta.value);
}

Deep fifth_power(const Deep& k) { return square(square(k)) * k; }

// Smaller than the last bit worked with.
bool is_spent(const Deep& bound) {
  Ball last;
  arb_one(last.value);
  arb_mul_2exp_si(last.value, last.value, -Arithmetic<Deep>::bits() - 2);
  return arb_lt(bound.ball(), last.value) != 0;
}

// Σ tanh(k x)/k⁵ over odd k, as tanh(k x) = 1 - 2/(e^{2kx} + 1). With q = e^{-2x} what follows k = n is positive and
//   Σ_{k >= n} q^k/(k⁵ (1 + q^k)) < q^n/(n⁵ (1 - q²)).
Deep sum_of_tanh(const Deep& x) {
  const Deep q = exponential(-(x + x)), q_squared = square(q), rest = Deep(1) - q_squared;
  Deep sum(0), power = q;
  for (int k = 1;; k += 2) {
    const Deep term = power / fifth_power(Deep(k));
    const Deep bound = term / rest;
    if (is_spent(bound)) return odd_fifth_powers() - Deep(2) * widened(sum, bound);
    sum += term / (Deep(1) + power);
    power *= q_squared;
  }
}

}  // namespace

Deep rectangle_torsion(const Rational& width, const Rational& thickness) {
  const Deep slenderness = from_rational<Deep>(width / thickness), x = pi<Deep>() * slenderness / Deep(2);
  const Deep end_effect = Deep(64) / (fifth_power(pi<Deep>()) * slenderness) * sum_of_tanh(x);
  return from_rational<Deep>(width * thickness * thickness * thickness) *
         (from_rational<Deep>(Rational(1, 3)) - end_effect);
}

}  // namespace epure::geometry
