#include "geometry/analytic/torsion_series.h"

namespace epure::geometry::analytic {
namespace {

// Σ 1/m^s over odd m >= first.
Deep odd_powers_from(long first, int s) {
  const long bits = Arithmetic<Deep>::bits();
  Ball exponent, start, sum;
  arb_set_si(exponent.value, s);
  arb_set_si(start.value, first);
  arb_mul_2exp_si(start.value, start.value, -1);
  arb_hurwitz_zeta(sum.value, exponent.value, start.value, bits);
  arb_mul_2exp_si(sum.value, sum.value, -s);
  return Deep::from_ball(sum.value);
}

Deep decay(const Deep& y) {
  Ball result;
  arb_exp(result.value, y.ball(), Arithmetic<Deep>::bits());
  return Deep(1) / square(Deep::from_ball(result.value));
}

}  // namespace

// From the first m with e^{-2ym} below the last bit on, tanh(ym) is 1 less at most 2e^{-2ym}: the rest is that of the
// two sums without it, and what that leaves out is less than 2e^{-2ym}/y Σ 1/m⁵.
Deep torsion_series(const Rational& a, const Rational& b) {
  const long bits = Arithmetic<Deep>::bits();
  const Deep y = pi<Deep>() * from_rational<Deep>(b / (2 * a));
  const Deep step = square(decay(y));
  Ball last;
  arb_one(last.value);
  arb_mul_2exp_si(last.value, last.value, -bits);
  Deep sum(0), e = decay(y);
  long m = 1;
  for (; arb_lt(e.ball(), last.value) == 0; m += 2, e *= step) {
    const Deep ym = y * Deep(static_cast<int>(m));
    sum += (Deep(1) - (Deep(1) - e) / ((Deep(1) + e) * ym)) / square(square(Deep(static_cast<int>(m))));
  }
  const Deep fifths = odd_powers_from(m, 5) / y;
  sum += odd_powers_from(m, 4) - fifths + widened(Deep(0), Deep(2) * e * fifths);
  return Deep(32) / square(square(pi<Deep>())) * from_rational<Deep>(a * a * a * b) * sum;
}

}  // namespace epure::geometry::analytic
