#include "geometry/analytic/pendulum_by_theta.h"

#include <array>

#include "geometry/analytic/integral.h"
#include "geometry/numbers/ball.h"

namespace epure::geometry::analytic {
namespace {

// The integral of dφ/√(cos² φ + c² sin² φ), c = cos or sin of half the greatest angle.
Deep energy_integral(const Deep& c, const Deep& from, const Deep& to) {
  const Deep c_squared = square(c);
  return integral(
      [&](acb_ptr result, const acb_t phi, bool must_be_analytic, long bits) {
        ComplexBall sine, cosine;
        acb_sin_cos(sine.value, cosine.value, phi, bits);
        acb_mul(sine.value, sine.value, sine.value, bits);
        acb_mul(cosine.value, cosine.value, cosine.value, bits);
        acb_mul_arb(sine.value, sine.value, c_squared.ball(), bits);
        acb_add(sine.value, sine.value, cosine.value, bits);
        acb_rsqrt_analytic(result, sine.value, must_be_analytic, bits);
      },
      from, to);
}

Deep right_angle() { return pi<Deep>() / Deep(2); }

// θ1 to θ4.
using Thetas = std::array<Deep, 4>;
Thetas thetas(const Deep& z, const Deep& ratio_of_periods) {
  ComplexBall argument(z), tau(ratio_of_periods);
  acb_mul_onei(tau.value, tau.value);
  std::array<ComplexBall, 4> of;
  acb_modular_theta(of[0].value, of[1].value, of[2].value, of[3].value, argument.value, tau.value,
                    Arithmetic<Deep>::bits());
  return {of[0].real(), of[1].real(), of[2].real(), of[3].real()};
}

}  // namespace

PendulumByTheta::PendulumByTheta(const Angle& theta_0, const Rational& g, const Rational& length)
    : theta_0_(Rational(sign_of(theta_0), 2) * theta_0), side_(sign_of(theta_0)) {
  Omega_ = root(from_rational<Deep>(g / length));
  K_ = energy_integral(cosine<Deep>(theta_0_), Deep(0), right_angle());
  K_prime_ = energy_integral(sine<Deep>(theta_0_), Deep(0), right_angle());
}

PendulumByTheta::State PendulumByTheta::at(const Rational& t) const {
  const Deep ratio = K_prime_ / K_;
  const auto [nothing, two, three, four] = thetas(Deep(0), ratio);
  const auto [first, second, third, fourth] = thetas(Omega_ * from_rational<Deep>(t) / (Deep(2) * K_), ratio);
  const Deep unit = three * third, side(side_);
  return {side * two * second / unit, four * fourth / unit,
          Deep(-2) * side * Omega_ * two * four * first / (three * unit)};
}

Deep PendulumByTheta::time_until(const Deep& amplitude) const {
  return energy_integral(cosine<Deep>(theta_0_), amplitude, right_angle()) / Omega_;
}

}  // namespace epure::geometry::analytic
