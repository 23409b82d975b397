// What is given of the damped oscillator and of the compound pendulum, in SI units, and when it is impossible.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/vibration/free_oscillation.h"
#include "geometry/vibration/recursion.h"

namespace epure::oscillator_pendulum {

std::vector<GivenSpec> given_specs();
// What a sheet of the other one leaves out.
inline const std::set<std::string> givens_of_pendulum{"m_p", "I_G", "r", "g", "theta_0", "dt_p"},
    givens_of_oscillator{"zeta", "m", "omega_n", "v_0", "dt"};

// x(0) = 0, x'(0) = v_0.
struct Oscillator {
  Rational zeta, m, v_0, dt;
  Angle omega;

  geometry::Damping damping() const { return geometry::damping_of(zeta); }
};

// Let go at θ_0.
struct Pendulum {
  Rational m, I_G, r, g, dt;
  Angle theta_0;

  Rational I_A0() const { return I_G + m * r * r; }
  Rational Omega_squared() const { return m * g * r / I_A0(); }
  Rational equivalent_length() const { return I_A0() / (m * r); }
  geometry::PendulumTable table() const { return {theta_0, I_G, m, r, g, dt}; }
  // |θ_0| against so many degrees: -1, 0, 1.
  int against(int degrees) const;
};

struct Problem {
  Oscillator oscillator;
  Pendulum pendulum;
  // Throws BadGivens, in one sentence with the value and what it violates.
  explicit Problem(const Givens& givens);
};

}  // namespace epure::oscillator_pendulum
