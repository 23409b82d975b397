// How thick a tooth is anywhere, along the arc of a circle about the wheel's centre.
//
// On the reference circle the generating rack leaves m (π/2 + 2 x tan α), in a ring m (π/2 - 2 x tan α). From there
// each flank follows its involute: at the radius ρ, where the involute's pressure angle is α_ρ, it has turned towards
// the middle of the tooth by inv α_ρ - inv α; in a ring, whose teeth are the spaces of such a wheel, away from it.
// The backlash takes j/2 on the working pitch circle, which is an angle, the same at every radius.
#pragma once

#include "geometry/gears/gear_pair.h"

namespace epure::geometry {

// Negative beyond the point where the flanks cross. `wheel` is 1 or 2, and not a rack; `at` the involute's pressure
// angle at the radius.
template <class T>
T tooth_thickness(const GearPair<T>& pair, int wheel, const T& radius, const PressureAngle<T>& at) {
  const WheelData data = wheel == 1 ? first_wheel(pair.given) : second_wheel(pair.given);
  const WheelCircles<T>& circles = wheel == 1 ? pair.wheel1 : *pair.wheel2;
  // What both flanks turn towards the middle on a wheel, seen from the reference circle outwards.
  const T twice_towards = T(2) * (involute(at.tangent) - involute(pair.alpha.tangent)) -
                          from_rational<T>(4 * data.x / Rational(data.z)) * pair.alpha.tangent;
  const T half_pitch = quotient(pi<T>(), from_rational<T>(Rational(data.z)));
  const T play = quotient(from_rational<T>(pair.given.j / 2), circles.r_w);
  return radius * (half_pitch - play + (data.ring ? twice_towards : -twice_towards));
}

// The same at any radius. Throws Impossible for one inside the base circle, and Undecided for the base circle itself,
// which has its own function.
template <class T>
T tooth_thickness(const GearPair<T>& pair, int wheel, const T& radius) {
  const WheelCircles<T>& circles = wheel == 1 ? pair.wheel1 : *pair.wheel2;
  return tooth_thickness(pair, wheel, radius, pressure_angle_at(radius, circles.r_b));
}
template <class T>
T base_thickness(const GearPair<T>& pair, int wheel) {
  return tooth_thickness(pair, wheel, wheel == 1 ? pair.wheel1.r_b : pair.wheel2->r_b,
                         PressureAngle<T>{T(0), T(1), T(0)});
}

// Of a rack's tooth along a line `height` above its reference line, towards the tip.
template <class T>
T rack_tooth_thickness(const GearPair<T>& pair, const T& height) {
  const Rational half = Rational(1, 2);
  return from_rational<T>(half * pair.given.m) * pi<T>() - T(2) * height * pair.alpha.tangent -
         from_rational<T>(half * pair.given.j);
}

// Of wheel 1 or 2, or of the rack, on its tip circle or line.
template <class T>
T tip_thickness(const GearPair<T>& pair, int wheel) {
  const PairData& of = pair.given;
  if (wheel == 2 && of.kind == PairKind::rack)
    return rack_tooth_thickness(pair, from_rational<T>(of.m * (of.ha - of.k)));
  return tooth_thickness(pair, wheel, wheel == 1 ? pair.wheel1.r_tip : pair.wheel2->r_tip);
}

}  // namespace epure::geometry
