// Euler's explicit scheme, exactly as it stands: both speeds advanced with the accelerations of the old instant.
#pragma once

#include "geometry/analytic/spin_up.h"

namespace epure::aircraft_landing {

using geometry::Deep;
using geometry::Rational;
using geometry::analytic::SpinUp;

// Step after step, as a sheet of numbers has it; or the speed as an iterate of y ← y² + c, and the angular velocity
// by the impulse of all steps.
enum class Arrangement { stepwise, as_map };

struct EulerState {
  Deep v, omega;
};

// After k >= 1 steps. Throws Impossible when slip ends at an earlier one.
EulerState after_steps(const SpinUp& of, const Rational& step, int k, Arrangement how);

struct EulerEnd {
  int steps;  // number of the first after which R ω >= v
  Deep t_s;   // v - R ω = 0 on the straight line of that step
};
EulerEnd end_of_slip(const SpinUp& of, const Rational& step, Arrangement how);

// v after the first step is exactly zero.
bool stops_at_once(const SpinUp& of, const Rational& step);

}  // namespace epure::aircraft_landing
