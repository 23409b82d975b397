#include "geometry/numbers/fast.h"

#include "geometry/numbers/round_to_nearest.h"
#include "geometry/numbers/small_fraction.h"
#include "geometry/numbers/turn.h"

#include <mpfr.h>

namespace epure::geometry {

namespace {

// cos(2πq) for q in [0, 1/8], where no cancellation can occur.
Fast cosine_in_octant(const Rational& q) { return std::cos(2 * pi<Fast>() * from_rational<Fast>(q)); }
Fast sine_in_octant(const Rational& q) { return std::sin(2 * pi<Fast>() * from_rational<Fast>(q)); }

// cos(2πq) for q in [0, 1/4].
Fast cosine_in_quadrant(const Rational& q) {
  return q <= Rational(1, 8) ? cosine_in_octant(q) : sine_in_octant(Rational(1, 4) - q);
}

}  // namespace

template <>
Fast from_rational<Fast>(const Rational& value) {
  if (const auto small = small_fraction(value)) {
    const RoundToNearest rounding;
    return small->numerator / small->denominator;
  }
  // MPFR does the one rounding of a 53-bit result; mpq_get_d would truncate.
  mpfr_t nearest;
  mpfr_init2(nearest, 53);
  const mpfr_exp_t emin = mpfr_get_emin();
  mpfr_set_emin(-1073);  // so that subnormal doubles are rounded once, not twice
  const int inexact = mpfr_set_q(nearest, value.mpq(), MPFR_RNDN);
  mpfr_subnormalize(nearest, inexact, MPFR_RNDN);
  const double result = mpfr_get_d(nearest, MPFR_RNDN);
  mpfr_set_emin(emin);
  mpfr_clear(nearest);
  return result;
}

template <>
Fast cosine<Fast>(const Turn& turn) {
  if (const auto known = rational_cosine(turn)) return from_rational<Fast>(*known);
  Rational q = within_one_turn(turn).fraction;
  if (q > Rational(1, 2)) q = Rational(1) - q;
  return q <= Rational(1, 4) ? cosine_in_quadrant(q) : -cosine_in_quadrant(Rational(1, 2) - q);
}

template <>
Fast sine<Fast>(const Turn& turn) {
  return cosine<Fast>(turn_for_sine(turn));
}

}  // namespace epure::geometry
