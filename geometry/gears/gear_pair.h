// A pair of involute gears in its frame, constructed: circles met with the line of action.
//
// The pitch point P0 is the origin, the line of centres the y axis: O1 = (0, -r_w1); O2 = (0, r_w2), of a ring
// (0, -r_w2). A rack lies above, its pitch line is the x axis. Wheel 1 drives, counter-clockwise: at P0 all moves
// towards -x. The line of action touches base circle 1 in T1 and base circle 2 in T2; contact travels on it from A,
// where wheel 2's tip circle meets it, past P0 to E, where wheel 1's does. A position on it is its signed distance ξ
// from P0, positive in the direction of travel: recess.
//
// Metres, radians.
#pragma once

#include "geometry/constructions/circle.h"
#include "geometry/gears/pair_data.h"
#include "geometry/gears/pressure_angle.h"

#include <optional>

namespace epure::geometry {

// The circles of a wheel. A ring's tip circle is the smaller one.
template <class T>
struct WheelCircles {
  T r, r_b, r_w, r_tip, r_root;  // reference, base, working pitch, tip, root
};

template <class T>
struct GearPair {
  PairData given;
  PressureAngle<T> alpha, alpha_w;  // of the generating rack; working
  WheelCircles<T> wheel1;
  std::optional<WheelCircles<T>> wheel2;  // none of a rack
  T centre_distance;                      // O1O2; to a rack's pitch line
  Point<T> P0, O1;
  std::optional<Point<T>> O2;  // none of a rack
  Line<T> line_of_action;      // directed as contact travels, its direction is a unit vector
  Point<T> T1;
  std::optional<Point<T>> T2;  // none of a rack

  // Where contact begins and ends. Throw Impossible when the tips do not reach the line of action, Undecided when
  // that cannot be told. They may lie beyond T1 and T2 (interference), or E before A (no contact).
  Point<T> A() const;
  Point<T> E() const;

  Point<T> at(const T& xi) const { return P0 + xi * line_of_action.direction(); }
  T position(const Point<T>& on_the_line) const { return dot(on_the_line - P0, line_of_action.direction()); }
};

// z1 >= 1, z2 >= 1 and for a ring z2 > z1, m > 0, 0 < alpha < 1/4 turn: the caller's promise. Throws Impossible when
// no working pressure angle exists: the wheels are shifted together so far that base circle would overlap base
// circle.
template <class T>
GearPair<T> gear_pair(const PairData& of);

// ---------------------------------------------------------------------------------------------------------------------

template <class T>
WheelCircles<T> wheel_circles(const WheelData& wheel, const PressureAngle<T>& alpha, const PressureAngle<T>& alpha_w,
                              const PairData& of) {
  const T r = from_rational<T>(wheel.r), r_b = r * alpha.cosine;
  const T r_w = shift_per_tooth(of) == 0 ? r : quotient(r_b, alpha_w.cosine);
  return {r, r_b, r_w, from_rational<T>(wheel.r_tip), from_rational<T>(wheel.r_root)};
}

template <class T>
GearPair<T> gear_pair(const PairData& of) {
  const PressureAngle<T> alpha = pressure_angle<T>(of.alpha),
                         alpha_w = working_pressure_angle(alpha, shift_per_tooth(of));
  const T zero(0);
  const Point<T> P0{zero, zero};
  const WheelCircles<T> wheel1 = wheel_circles(first_wheel(of), alpha, alpha_w, of);
  const Point<T> O1{zero, -wheel1.r_w};
  const Line<T> action = line(P0, Vector<T>{-alpha_w.cosine, alpha_w.sine});
  GearPair<T> pair{of, alpha, alpha_w, wheel1, {}, wheel1.r_w, P0, O1, {}, action, foot(O1, action), {}};
  if (of.kind == PairKind::rack) return pair;
  pair.wheel2 = wheel_circles(second_wheel(of), alpha, alpha_w, of);
  pair.O2 = Point<T>{zero, of.kind == PairKind::internal ? -pair.wheel2->r_w : pair.wheel2->r_w};
  pair.T2 = foot(*pair.O2, action);
  pair.centre_distance =
      of.kind == PairKind::internal ? pair.wheel2->r_w - wheel1.r_w : pair.wheel2->r_w + wheel1.r_w;
  return pair;
}

// Where the tip circle about O meets the line of action, ahead of or behind the foot T of O on it.
template <class T>
Point<T> meet_of_tips(const Point<T>& O, const WheelCircles<T>& wheel, const Line<T>& action, Along which) {
  if (sign(wheel.r_tip - wheel.r_b) == Sign::negative)
    throw Impossible("the tip circle lies inside the base circle and does not reach the line of action",
                     "la circonferenza di testa sta dentro quella di base e non raggiunge la retta d'azione");
  return meet(Circle<T>{O, wheel.r_tip}, action, which);
}

template <class T>
Point<T> GearPair<T>::A() const {
  if (given.kind != PairKind::rack)
    return meet_of_tips(*O2, *wheel2, line_of_action,
                        given.kind == PairKind::internal ? Along::ahead : Along::behind);
  const Line<T> tips = line(Point<T>{T(0), from_rational<T>(rack_lines(given).tip)}, Vector<T>{T(-1), T(0)});
  return finite(meet(tips, line_of_action));
}

template <class T>
Point<T> GearPair<T>::E() const {
  return meet_of_tips(O1, wheel1, line_of_action, Along::ahead);
}

}  // namespace epure::geometry
