// The givens of the exercise, and when they are impossible.
#pragma once

#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/roller_cam_formulas.h"
#include "geometry/mechanisms/roller_cam.h"

namespace epure::cam_dynamics {

std::vector<GivenSpec> stated_givens();

// In SI units. A₀ is the origin, the guide upright at x = offset, the follower above the cam.
struct Cam {
  geometry::RollerCamLengths lengths;
  Rational offset, m_2, m_3, P, g;
  Angle angle;        // of A₀A
  Angle omega, fast;  // ω₂ in the drawn position, and at the higher speed

  geometry::analytic::RollerCam formulas() const { return {lengths.eccentricity, lengths.reach(), offset}; }
};

// Throws BadGivens, in one sentence with the values, when the follower would leave the cam.
Cam cam(const Givens& givens);

}  // namespace epure::cam_dynamics
