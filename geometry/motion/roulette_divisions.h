// Cycloid and involute point by point, as they are drawn: circle and line divided into parts of the same length.
#pragma once

#include "geometry/constructions/circle.h"
#include "geometry/numbers/angle.h"

namespace epure::geometry {

// The wheel of radius r stands on the origin P₀ and will roll towards +x. When its point `on_wheel` has come to
// `on_line`, P₀ has come to M.
template <class T>
struct CycloidDivision {
  Point<T> on_line, on_wheel, M;
};

// By two arcs: about P₀ with the distance of `on_wheel` from `on_line`, and about `on_line` with the chord from P₀ to
// `on_wheel`, for these four are the corners of a trapezium with equal legs. `rolled` lies between nothing and one
// turn, neither included: at both ends the arcs touch, and M is `on_line` itself.
template <class T>
CycloidDivision<T> cycloid_division(const Rational& r, const Turn& rolled) {
  const Point<T> P0{T(0), T(0)}, C{T(0), from_rational<T>(r)};
  const Point<T> on_line{from_rational<T>(r) * radians<T>(Angle{rolled.fraction}), T(0)};
  const Point<T> on_wheel = turned(P0, C, Angle{rolled.fraction});
  const Circle<T> about_P0{P0, distance(on_line, on_wheel)}, about_line{on_line, distance(P0, on_wheel)};
  return {on_line, on_wheel, meet(about_P0, about_line, Side::left)};
}

// The line stands against the circle of radius R about the origin in P₀ = (R, 0) and will unwind counter-clockwise.
// When its point `on_line` has come to `on_circle`, P₀ has come to M.
template <class T>
struct InvoluteDivision {
  Point<T> on_line, on_circle, M;
};

// On the tangent in `on_circle`, backwards, the length that has been unrolled: P₀ `on_line`.
template <class T>
InvoluteDivision<T> involute_division(const Rational& R, const Turn& rolled) {
  const Point<T> C{T(0), T(0)}, P0{from_rational<T>(R), T(0)};
  const Point<T> on_line{P0.x, from_rational<T>(R) * radians<T>(Angle{rolled.fraction})};
  const Point<T> on_circle = turned(P0, C, Angle{rolled.fraction});
  const Vector<T> backwards = -quarter_turn(on_circle - C);
  const T share = quotient(distance(P0, on_line), distance(C, on_circle));
  return {on_line, on_circle, on_circle + share * backwards};
}

}  // namespace epure::geometry
