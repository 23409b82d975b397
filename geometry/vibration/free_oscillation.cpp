#include "geometry/vibration/free_oscillation.h"

#include "geometry/numbers/ball.h"

namespace epure::geometry {
namespace {

using Function = void (*)(arb_t, const arb_t, slong);

Deep of(Function function, const Deep& x) {
  Ball result;
  function(result.value, x.ball(), Arithmetic<Deep>::bits());
  return Deep::from_ball(result.value);
}

}  // namespace

Damping damping_of(const Rational& zeta) {
  if (zeta == 1) return Damping::critical;
  return zeta < 1 ? Damping::under : Damping::over;
}

Deep FreeOscillation::root_of_discriminant() const {
  const Rational discriminant = zeta_ * zeta_ - 1;
  return root(from_rational<Deep>(discriminant < 0 ? Rational(-discriminant) : discriminant));
}

FreeOscillation::Instant FreeOscillation::at(const Rational& t) const {
  const Angle tau = t * omega_;
  const auto less = [&](int by) { return radians<Deep>(tau - Angle{0, by}); };
  return {less(0), less(1), less(2)};
}

FreeOscillation::Law FreeOscillation::law(const Instant& at) const {
  const Deep& tau = at.tau;
  if (zeta_ == 1) {
    const Deep decay = of(arb_exp, -tau);
    return {decay * tau, -decay * at.less_one, decay * at.less_two};
  }
  const Deep b = root_of_discriminant();
  if (zeta_ < 1) {
    const Deep decay = of(arb_exp, -zeta() * tau), sine = sine_of_angle(b * tau) / b,
               cosine = cosine_of_angle(b * tau);
    const Rational twice = Rational(2) * zeta_;
    return {decay * sine, decay * (cosine - zeta() * sine),
            decay * (from_rational<Deep>(twice * zeta_ - 1) * sine - from_rational<Deep>(twice) * cosine)};
  }
  const Deep fast = -(zeta() + b), slow = Deep(1) / fast, decay = of(arb_exp, slow * tau),
             D = -of(arb_expm1, Deep(-2) * b * tau) / (Deep(2) * b);
  return {decay * D, decay * (Deep(1) + fast * D), decay * (slow + fast + square(fast) * D)};
}

Deep FreeOscillation::position(const Rational& t) const { return v_0() / omega() * law(at(t)).s; }
Deep FreeOscillation::velocity(const Rational& t) const { return v_0() * law(at(t)).first; }
Deep FreeOscillation::acceleration(const Rational& t) const { return v_0() * omega() * law(at(t)).second; }

// Where 1 + λ2 D, or cos - ζ sin/b, is zero.
Deep FreeOscillation::tau_of_extreme() const {
  if (zeta_ == 1) return Deep(1);
  const Deep b = root_of_discriminant();
  if (zeta_ < 1) return arc_tangent(b, zeta()) / b;
  return -of(arb_log1p, Deep(-2) * b / (zeta() + b)) / (Deep(2) * b);
}
Deep FreeOscillation::tau_of_inflection() const {
  if (zeta_ == 1) return Deep(2);
  const Deep b = root_of_discriminant();
  if (zeta_ < 1) return arc_tangent(Deep(2) * zeta() * b, from_rational<Deep>(Rational(2) * zeta_ * zeta_ - 1)) / b;
  return -of(arb_log1p, Deep(-4) * zeta() * b / square(zeta() + b)) / (Deep(2) * b);
}

Deep FreeOscillation::time_of_extreme() const { return tau_of_extreme() / omega(); }
Deep FreeOscillation::time_of_inflection() const { return tau_of_inflection() / omega(); }
Deep FreeOscillation::extreme() const { return v_0() / omega() * law(at_tau(tau_of_extreme())).s; }
Deep FreeOscillation::position_of_inflection() const { return v_0() / omega() * law(at_tau(tau_of_inflection())).s; }
Deep FreeOscillation::velocity_of_inflection() const { return v_0() * law(at_tau(tau_of_inflection())).first; }

}  // namespace epure::geometry
