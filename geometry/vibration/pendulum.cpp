#include "geometry/vibration/pendulum.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry {
namespace {

Deep arc_sine(const Deep& x) {
  Ball result;
  arb_asin(result.value, x.ball(), Arithmetic<Deep>::bits());
  return Deep::from_ball(result.value);
}

// Less than 2^-bits?
bool is_negligible(const Deep& x) {
  return arb_is_zero(x.ball()) || arf_cmpabs_2exp_si(arb_midref(x.ball()), -Arithmetic<Deep>::bits()) < 0;
}

}  // namespace

PendulumSwing::PendulumSwing(const Angle& theta_0, const Rational& Omega_squared) : side_(sign_of(theta_0)) {
  const Angle half = Rational(side_, 2) * theta_0;
  k_ = sine<Deep>(half);
  Omega_ = root(from_rational<Deep>(Omega_squared));
  Deep a(1), b = cosine<Deep>(half);
  constexpr int enough = 64;  // the gap is squared at each step
  for (int n = 0; n < enough && !is_negligible(a - b); ++n) {
    const Deep mean = (a + b) / Deep(2), c = (a - b) / Deep(2);
    b = root(a * b), a = mean;
    means_.push_back({a, c});
  }
  last_gap_ = (a - b) / a;
  K_ = pi<Deep>() / (Deep(2) * widened(a, a - b));
}

Deep PendulumSwing::amplitude(const Deep& u) const {
  Deep w = means_.empty() ? u : means_.back().a * u;
  for (std::size_t n = 0; n < means_.size(); ++n) w = Deep(2) * w;
  Deep phi = widened(w, Deep(2) * last_gap_ * w);
  for (auto mean = means_.rbegin(); mean != means_.rend(); ++mean)
    phi = (phi + arc_sine(mean->c / mean->a * sine_of_angle(phi))) / Deep(2);
  return phi;
}

SwingState PendulumSwing::at(const Rational& t) const {
  const Deep phi = amplitude(K_ - Omega_ * from_rational<Deep>(t)), sine = k_ * sine_of_angle(phi),
             along = k_ * cosine_of_angle(phi), complement = Deep(1) - square(k_);
  return {Deep(side_) * sine, root(complement + square(along)), Deep(-2 * side_) * Omega_ * along};
}

Deep PendulumSwing::time_until(const Deep& k_sine, const Deep& k_cosine) const {
  const ComplexBall phi(arc_tangent(k_sine, k_cosine)), m(square(k_));
  ComplexBall F;
  acb_elliptic_f(F.value, phi.value, m.value, 0, Arithmetic<Deep>::bits());
  return (K_ - F.real()) / Omega_;
}

}  // namespace epure::geometry
