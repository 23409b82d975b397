// A slotted lever and a rolling disc. The lever turns about O; in its slot runs a pin fixed at the centre B of a disc
// of radius R; the disc rolls without slipping on the guide y = 0, which passes through O and touches the disc in D.
// So B stays on the level y = R. At its other end, beyond O, the lever carries the point A.
//
// Metres, radians, seconds; counter-clockwise positive. B lies ahead of O (towards +x), or above it when OB = R.
#pragma once

#include "geometry/mechanisms/dyad.h"
#include "geometry/motion/euler_savary.h"
#include "geometry/motion/instant_centres.h"

namespace epure::geometry {

struct SlottedLeverLengths {
  Rational R, OB, AO;
};

template <class T>
struct SlottedLever {
  Point<T> O, A, B, D;
  Vector<T> slot;  // unit vector from O to B

  // Where the guide meets the normal to the slot in B. Bodies: 1 frame, 2 lever, 3 disc, 4 pin in the slot. P₂₃ lies
  // on P₁₂P₁₃, which is the guide, and on P₂₄P₃₄, the normal to the slot in B. At infinity when the lever is upright.
  ProjectivePoint<T> relative_pole() const {
    return meet(line(O, Vector<T>{T(1), T(0)}), perpendicular(line(O, B), B));
  }
};

// B by the circle of radius OB about O and the level y = R. Where they touch is decided on the rational lengths.
// Throws Impossible when OB < R.
template <class T>
Point<T> pin_on_level(const SlottedLeverLengths& of) {
  const Point<T> over_O{T(0), from_rational<T>(of.R)};
  if (of.OB == of.R) return over_O;
  return meet(Circle<T>{{T(0), T(0)}, from_rational<T>(of.OB)}, line(over_O, Vector<T>{T(1), T(0)}), Along::ahead);
}

// Errors as pin_on_level.
template <class T>
SlottedLever<T> slotted_lever(const SlottedLeverLengths& of) {
  const Point<T> O{T(0), T(0)}, B = pin_on_level<T>(of);
  const Vector<T> slot = from_rational<T>(1 / of.OB) * (B - O);
  return {O, O + (-from_rational<T>(of.AO)) * slot, B, {B.x, T(0)}, slot};
}

// By the polar diagrams. The pin is a dyad of two slides, on the lever along its slot and on the frame along y = R:
//   v_B = v_B* + v_rel,   a_B = a_B* + a_cor + a_rel,   with B* the lever's point under B.
// The first rates are the sliding speed b' along the slot (outwards positive) and its derivative b''; the second ones
// are the components of v_B and a_B along x.
template <class T>
struct SlottedLeverMotion {
  PlaneMotion<T> lever, disc;
  DyadVelocity<T> velocity;
  DyadAcceleration<T> acceleration;
};

template <class T>
SlottedLeverMotion<T> slotted_lever_motion(const SlottedLever<T>& at, const T& omega, const T& alpha) {
  const PlaneMotion<T> lever = turning_about(at.O, omega, alpha), frame = turning_about(at.O, T(0), T(0));
  const Slide<T> in_slot{lever, at.slot}, on_level{frame, {T(1), T(0)}};
  const DyadVelocity<T> v = dyad_velocity(in_slot, on_level, at.B);
  const DyadAcceleration<T> a = dyad_acceleration(in_slot, on_level, at.B, v);
  // D is the disc's pole, and stays under B: a_B has no part towards it.
  const Vector<T> v_B = v.second.closing, a_B = a.second.closing, DB = at.B - at.D;
  const T omega_disc = RotationAboutPole<T>(projective(at.D), at.B, v_B).omega();
  const T alpha_disc = quotient(cross(DB, a_B), length_squared(DB));
  return {lever, {at.B, v_B, a_B, omega_disc, alpha_disc}, v, a};
}

// The disc's angular velocity by the method of poles: P₂₃ has one velocity as a point of the lever and of the disc.
template <class T>
T disc_speed_by_poles(const SlottedLever<T>& at, const T& omega) {
  const Ratio<T> lever_to_disc = angular_velocities(projective(at.O), projective(at.D), at.relative_pole());
  return omega * quotient(lever_to_disc.second, lever_to_disc.first);
}

}  // namespace epure::geometry
