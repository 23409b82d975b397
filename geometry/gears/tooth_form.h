// The tooth of a wheel or ring by the few numbers its outline follows from.
//
// A form may be set back: it is then the tooth less all points that are nearer than `back` to its surface. Such a
// tooth is what a cutter leaves whose own surface lies farther out by as much, so it obeys the same formulas: a flank
// of the same base circle, another tip radius, a larger rounding about the same centre.
//
// Metres, radians; in the frame of right_flank.h.
#pragma once

#include "geometry/gears/right_flank.h"
#include "geometry/gears/root_curve.h"

#include <variant>

namespace epure::geometry {

// Below the flank of a wheel.
template <class T>
struct GeneratedRoot {
  RootCurve<T> curve;
  T end;  // from p = 1 to here, where it runs into the flank with the same tangent or, undercut, crosses it
};

// Below the flank of a ring: a circle about a centre at the angle `direction` from +y, from there by `angle` towards
// the flank.
template <class T>
struct RoundedRoot {
  Point<T> centre;
  T radius, direction, angle;
};

template <class T>
struct ToothForm {
  RightFlank<T> flank;
  T t_form, t_tip;   // where it begins, at the root, and ends, at the tip
  T r_tip, r_root;   // of the tip circle, and of the root circle
  T tip_half_angle;  // zero of a pointed tooth, which ends where its flanks meet
  T half_pitch;      // half the angle from tooth to tooth
  std::variant<GeneratedRoot<T>, RoundedRoot<T>> root;
};

// The involute alone, of wheel 1 or 2, which is not a rack. Throws as gear_pair.
RightFlank<Deep> right_flank(const GearPair<Deep>& pair, int wheel);

// Of wheel 1 or 2, which is not a rack. A ring's tooth begins at the base circle when its tip would lie inside it.
// Throws Impossible when no outline exists: the cutter is pointed, the tip lies inside the base circle or inside the
// flank's beginning; Undecided when the number at hand cannot tell.
ToothForm<Deep> tooth_form(const PairData& of, int wheel, const Rational& back);

// The radius at which the flank begins, where the root curve meets it.
Deep form_radius(const ToothForm<Deep>& form);

}  // namespace epure::geometry
