// The pendulum of vibration/pendulum.h by other formulas: the energy's integral by quadrature, and the motion as
// quotients of Jacobi's theta series, Fourier series in t:  with q = e^{-π K'/K}, z = Ω t/(2 K),
//   sin θ/2 = θ2 θ2(z)/(θ3 θ3(z))     cos θ/2 = θ4 θ4(z)/(θ3 θ3(z))     θ' = -2 Ω θ2 θ4 θ1(z)/(θ3² θ3(z))
#pragma once

#include "geometry/numbers/angle.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

class PendulumByTheta {
 public:
  struct State {
    Deep sine_of_half, cosine_of_half, rate;  // of θ/2; θ'
  };

  // Ω is known by its equivalent length: Ω² = g/l.
  PendulumByTheta(const Angle& theta_0, const Rational& g, const Rational& length);

  const Deep& K() const { return K_; }
  const Deep& Omega() const { return Omega_; }
  State at(const Rational& t) const;
  // When the amplitude φ, sin θ/2 = k sin φ, is this for the first time: the integral from there to π/2.
  Deep time_until(const Deep& amplitude) const;

 private:
  Angle theta_0_;
  int side_;
  Deep Omega_, K_, K_prime_;
};

}  // namespace epure::geometry::analytic
