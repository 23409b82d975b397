// The compound pendulum let go at the angle θ0, 0 < |θ0| < π, by Gauss' arithmetic-geometric mean: θ'' = -Ω² sin θ.
//   k = sin |θ0|/2     K = π/(2 agm(1, k'))     sin θ/2 = k sin φ, φ = am(K - Ω t)     θ' = -2 k Ω cos φ
// The amplitude by descent: φ_N = 2^N a_N u at the end of the means, and φ_{n-1} = (φ_n + arcsin((c_n/a_n) sin
// φ_n))/2. There dn lies between k'_N and 1, so |am w - w| <= (1 - k'_N) w <= 2 (1 - b_N/a_N) w, which is enclosed.
#pragma once

#include <vector>

#include "geometry/numbers/angle.h"
#include "geometry/numbers/numbers.h"
#include "geometry/vibration/swing_state.h"

namespace epure::geometry {

class PendulumSwing {
 public:
  PendulumSwing(const Angle& theta_0, const Rational& Omega_squared);

  const Deep& modulus() const { return k_; }
  const Deep& K() const { return K_; }
  const Deep& Omega() const { return Omega_; }
  SwingState at(const Rational& t) const;
  // When the amplitude is φ for the first time, given k sin φ >= 0 and k cos φ >= 0: by Carlson's form of the
  // integral.
  Deep time_until(const Deep& k_sine, const Deep& k_cosine) const;

 private:
  Deep amplitude(const Deep& u) const;

  Deep k_, Omega_, K_;
  int side_;
  struct Means {
    Deep a, c;  // a_n, c_n = (a_{n-1} - b_{n-1})/2
  };
  std::vector<Means> means_;
  Deep last_gap_;  // (a_N - b_N)/a_N
};

}  // namespace epure::geometry
