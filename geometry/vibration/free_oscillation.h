// The damped oscillator set off from its place of rest, in closed form:  x'' + 2 ζ ω x' + ω² x = 0, x(0) = 0,
// x'(0) = v0. With τ = ω t and s the law for v0 = ω = 1,
//   x = (v0/ω) s(τ)     x' = v0 s'(τ)     x'' = v0 ω s''(τ)
//   ζ > 1   s = e^{λ1 τ} D,  s' = e^{λ1 τ} (1 + λ2 D),  s'' = e^{λ1 τ} (λ1 + λ2 + λ2² D),  D = (1 - e^{-2bτ})/(2b),
//           b = √(ζ² - 1), λ2 = -(ζ + b), λ1 = 1/λ2: nothing cancels, however near ζ is to 1
//   ζ = 1   the same with D = τ
//   ζ < 1   s = e^{-ζτ} sin(bτ)/b,  b = √(1 - ζ²)
// Which of the three is decided on the rational ζ.
#pragma once

#include "geometry/numbers/angle.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry {

enum class Damping { under, critical, over };

// ζ >= 0.
Damping damping_of(const Rational& zeta);

class FreeOscillation {
 public:
  FreeOscillation(Rational zeta, Angle omega, Rational v_0)
      : zeta_(std::move(zeta)), omega_(std::move(omega)), v_0_(std::move(v_0)) {}

  Deep position(const Rational& t) const;
  Deep velocity(const Rational& t) const;
  Deep acceleration(const Rational& t) const;

  // The first instant after the start with x' = 0, with x'' = 0; what x and x' are then.
  Deep time_of_extreme() const;
  Deep time_of_inflection() const;
  Deep extreme() const;
  Deep position_of_inflection() const;
  Deep velocity_of_inflection() const;

  Deep omega() const { return radians<Deep>(omega_); }
  Deep root_of_discriminant() const;  // |ζ² - 1|^(1/2)

 private:
  // ω t with what is taken from it, exactly where both are rational.
  struct Instant {
    Deep tau, less_one, less_two;
  };
  struct Law {
    Deep s, first, second;  // s(τ) and its derivatives
  };
  Instant at(const Rational& t) const;
  static Instant at_tau(const Deep& tau) { return {tau, tau - Deep(1), tau - Deep(2)}; }
  Law law(const Instant& at) const;
  Deep tau_of_extreme() const;
  Deep tau_of_inflection() const;
  Deep zeta() const { return from_rational<Deep>(zeta_); }
  Deep v_0() const { return from_rational<Deep>(v_0_); }

  Rational zeta_;
  Angle omega_;
  Rational v_0_;
};

}  // namespace epure::geometry
