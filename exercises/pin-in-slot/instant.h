// The givens of the exercise, and when they are impossible.
#pragma once

#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/slotted_lever_formulas.h"
#include "geometry/statics/slotted_lever_forces.h"

namespace epure::pin_in_slot {

// M1, M2 in kg, J2 in kg m², R, OB, AO in metres, omega in rad/s and omega_dot in rad/s², both clockwise, g in m/s².
std::vector<GivenSpec> stated_givens();

struct Instant {
  geometry::SlottedLeverLengths lengths;
  geometry::SlottedLeverMasses masses;
  Angle omega, omega_dot;  // of the lever, clockwise

  template <class T>
  geometry::SlottedLever<T> position() const {
    return geometry::slotted_lever<T>(lengths);
  }
  template <class T>
  geometry::SlottedLeverMotion<T> motion(const geometry::SlottedLever<T>& at) const {
    return geometry::slotted_lever_motion(at, geometry::radians<T>(-omega), geometry::radians<T>(-omega_dot));
  }
  geometry::analytic::SlottedLever analytic() const {
    return {lengths.R, lengths.OB, lengths.AO, masses.M1, masses.M2, masses.J2, masses.g};
  }
};

// Throws BadGivens, in one sentence with the values, when OB is shorter than R: the pin cannot come down to its
// level.
Instant instant(const Givens& givens);

}  // namespace epure::pin_in_slot
