// The instantaneous state of a moving plane up to the second order, and what follows from it: pole, inflection
// circle, stationarity (Bresse) circle, acceleration pole, centres of curvature.
//
// Nothing divides by ω: a pole at infinity is a direction, and circles are cycles that become lines.
// With ρ = X - A, ω and α counter-clockwise and k x ρ the quarter turn of ρ:
//   v(X) = v_A + ω k x ρ,   a(X) = a_A + α k x ρ - ω² ρ.
#pragma once

#include "geometry/constructions/cycle.h"

namespace epure::geometry {

template <class T>
struct PlaneMotion {
  Point<T> A;
  Vector<T> v_A, a_A;
  T omega, alpha;

  Vector<T> velocity(const Point<T>& X) const { return v_A + omega * quarter_turn(X - A); }
  Vector<T> acceleration(const Point<T>& X) const {
    const Vector<T> rho = X - A;
    return a_A + (alpha * quarter_turn(rho) - square(omega) * rho);
  }

  // The point of velocity zero: A + (k x v_A)/ω. When ω = 0, the direction square to the translation.
  ProjectivePoint<T> pole() const {
    const Vector<T> n = quarter_turn(v_A);
    return {omega * A.x + n.x, omega * A.y + n.y, omega};
  }

  // The point of acceleration zero. At infinity only when ω and α both vanish.
  ProjectivePoint<T> acceleration_pole() const {
    const T omega2 = square(omega), w = square(omega2) + square(alpha);
    const Vector<T> n = omega2 * a_A + alpha * quarter_turn(a_A);
    return {w * A.x + n.x, w * A.y + n.y, w};
  }

  // Where v and a are parallel (v x a = 0): points that pass an inflection of their path.
  Cycle<T> inflection_circle() const {
    const Vector<T> linear = alpha * v_A - omega * a_A - square(omega) * quarter_turn(v_A);
    return cycle_about(A, omega * square(omega), linear, cross(v_A, a_A));
  }

  // Where v and a are square (v . a = 0): points whose speed is stationary.
  Cycle<T> stationarity_circle() const {
    const Vector<T> linear = -(alpha * quarter_turn(v_A)) - square(omega) * v_A - omega * quarter_turn(a_A);
    return cycle_about(A, omega * alpha, linear, dot(v_A, a_A));
  }

  // The point of the inflection circle opposite the pole. At infinity when ω = 0.
  ProjectivePoint<T> inflection_pole() const {
    const T w = omega * square(omega);
    const Vector<T> n = omega * a_A - alpha * v_A;
    return {w * A.x + n.x, w * A.y + n.y, w};
  }

  // X': where the ray from the pole through X meets the inflection circle again (Euler-Savary).
  // When ω = 0 the point goes to infinity with the pole, unless the path of X is straight there too.
  // Undefined (0, 0, 0) when X is the pole.
  ProjectivePoint<T> on_inflection_circle(const Point<T>& X) const {
    const Vector<T> v = velocity(X);
    const T w = square(omega) * length_squared(v), turn = cross(v, acceleration(X));
    const Vector<T> n = turn * quarter_turn(v);
    return {w * X.x + n.x, w * X.y + n.y, w};
  }

  // Centre of curvature of the path of X. At infinity when X lies on the inflection circle; undefined (0, 0, 0) when
  // X is the pole, where the path has a cusp.
  // Euler-Savary: (distance X to pole)² = (X to centre) (X to X'), all on one ray and directed from X.
  ProjectivePoint<T> centre_of_curvature(const Point<T>& X) const {
    const Vector<T> v = velocity(X);
    const T w = cross(v, acceleration(X));
    const Vector<T> n = length_squared(v) * quarter_turn(v);
    return {w * X.x + n.x, w * X.y + n.y, w};
  }
};

}  // namespace epure::geometry
