// The closed form. With T = tan(st)/s, s = √(AB); tanh(st)/s, s = √(-AB); or t:
//   v = (v_0 - A T)/(1 + B v_0 T),    ∫v dt = (ln(1 + B v_0 T) + ln cos st)/B    (cosh for B < 0),
// and from v' = -(A + B v²) the integrals of v², of v³ and, once more integrated, of v².
#include <algorithm>
#include <cmath>

#include "geometry/analytic/spin_up.h"
#include "geometry/numbers/ball.h"
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/increasing_root.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {
namespace {

using ArbFunction = void (*)(arb_t result, const arb_t x, slong bits);
Deep value(ArbFunction function, const Deep& x) {
  Ball result;
  function(result.value, x.ball(), Arithmetic<Deep>::bits());
  return Deep::from_ball(result.value);
}
Deep number(const Rational& q) { return from_rational<Deep>(q); }

struct Braked {
  Deep v, path, squares, squares_twice, cubes;
};

Braked uniformly(const Deep& A, const Deep& v_0, const Deep& t) {
  const Deep t2 = t * t, v = v_0 - A * t;
  return {v, v_0 * t - A * t2 / Deep(2), v_0 * v_0 * t - v_0 * A * t2 + A * A * t2 * t / Deep(3),
          v_0 * v_0 * t2 / Deep(2) - v_0 * A * t2 * t / Deep(3) + A * A * t2 * t2 / Deep(12),
          (square(square(v_0)) - square(square(v))) / (Deep(4) * A)};
}

Braked braked(const SpinUp& of, const Deep& t) {
  const Deep A = number(of.A), v_0 = number(of.v_0);
  if (of.B == 0) return uniformly(A, v_0, t);
  const Deep B = number(of.B), s = root(number(CGAL::abs(of.A * of.B)));
  const bool is_circular = of.B > 0;
  const Deep st = s * t, T = value(is_circular ? arb_tan : arb_tanh, st) / s, grown = B * v_0 * T;
  const Deep sine_squared = square(value(is_circular ? arb_sin : arb_sinh, st));
  const Deep twice_log = value(arb_log1p, is_circular ? -sine_squared : sine_squared);
  Braked now;
  now.v = (v_0 - A * T) / (Deep(1) + grown);
  now.path = (value(arb_log1p, grown) + twice_log / Deep(2)) / B;
  now.squares = (v_0 - now.v - A * t) / B;
  now.squares_twice = (v_0 * t - now.path - A * t * t / Deep(2)) / B;
  now.cubes = ((v_0 * v_0 - now.v * now.v) / Deep(2) - A * now.path) / B;
  return now;
}

double log2_of(const Deep& x) { return std::log2(enclosure(x).value); }

// When v = 0.
Deep stop(const SpinUp& of) {
  const Deep A = number(of.A), v_0 = number(of.v_0);
  if (of.B == 0) return v_0 / A;
  const Deep x = v_0 * root(number(CGAL::abs(of.B / of.A)));
  return value(of.B > 0 ? arb_atan : arb_atanh, x) / root(number(CGAL::abs(of.A * of.B)));
}

}  // namespace

SpinState spun_up(const SpinUp& of, const Deep& t) {
  const Braked now = braked(of, t);
  const Deep C = number(of.C), D = number(of.D), omega_0 = number(of.omega_0);
  const bool with_squares = of.D != 0;
  SpinState state;
  state.t = t;
  state.v = now.v;
  state.omega = omega_0 + C * t + (with_squares ? D * now.squares : Deep(0));
  state.path = now.path;
  state.angle = omega_0 * t + C * t * t / Deep(2) + (with_squares ? D * now.squares_twice : Deep(0));
  state.cubes = now.cubes;
  state.of_wheel = (square(state.omega) - square(omega_0)) / Deep(2);
  state.of_load = C * now.path + (with_squares ? D * now.cubes : Deep(0));
  return state;
}

SpinState end_of_slip(const SpinUp& of) {
  const Deep R = number(of.R);
  // |d(v - R ω)/dt| lies between its values at v_0 and at 0.
  const Rational slip = of.v_0 - of.R * of.omega_0, at_0 = of.A + of.R * of.C,
                 at_v_0 = at_0 + (of.B + of.R * of.D) * of.v_0 * of.v_0;
  constexpr double around = 0.01, beside = 1e-12;
  const double low = log2_of(number(slip / std::max(at_0, at_v_0))) - around;
  // Not beyond where the load stands still: there the closed form begins anew.
  const double high = std::min(log2_of(number(slip / std::min(at_0, at_v_0))) + around, log2_of(stop(of)) - beside);
  const auto behind = [&](const Deep& t) {
    const SpinState now = spun_up(of, t);
    return R * now.omega - now.v;
  };
  return spun_up(of, increasing_root(behind, low, high));
}

}  // namespace epure::geometry::analytic
