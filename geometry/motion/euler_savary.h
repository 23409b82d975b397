// The method of poles, carried to the second order with the equation of Euler and Savary.
#pragma once

#include "geometry/motion/plane_motion.h"

namespace epure::geometry {

// Rotation about a pole that may be at infinity, known by the velocity v_A of one point A that is not the pole.
template <class T>
struct RotationAboutPole {
  ProjectivePoint<T> P0;
  T share;  // ω / w

  RotationAboutPole(const ProjectivePoint<T>& pole, const Point<T>& A, const Vector<T>& v_A)
      : P0(pole), share(quotient(cross(from_pole(A), v_A), length_squared(from_pole(A)))) {}

  T omega() const { return share * P0.w; }
  Vector<T> velocity(const Point<T>& X) const { return share * quarter_turn(from_pole(X)); }

 private:
  // w times the vector from the pole to X.
  Vector<T> from_pole(const Point<T>& X) const { return {X.x * P0.w - P0.x, X.y * P0.w - P0.y}; }
};

// P₀X² = (X to centre) (X to X'): X' on the ray from P0 through X, for a path with centre of curvature `centre`. When
// X is the pole, so is X'.
template <class T>
Point<T> euler_savary_point(const Point<T>& P0, const Point<T>& X, const Point<T>& centre) {
  const Vector<T> to_centre = centre - X;
  return X + quotient(length_squared(P0 - X), length_squared(to_centre)) * to_centre;
}

// The inflection pole J is seen from every X' of the inflection circle square to the ray P₀X. A ray is given by the
// normal of the path of X, which passes through P₀, so that X may be the pole itself. At infinity when the two rays
// are parallel.
template <class T>
ProjectivePoint<T> inflection_pole_by_poles(const Line<T>& ray, const Point<T>& X_prime, const Line<T>& other_ray,
                                            const Point<T>& Y_prime) {
  return meet(perpendicular(ray, X_prime), perpendicular(other_ray, Y_prime));
}

// The motion of a plane from its pole P₀, its inflection pole J and one point A that is not the pole. The plane's
// point at the pole is accelerated towards J: a_P0 = ω² P₀J; what is left of a_A turns it: α.
template <class T>
PlaneMotion<T> motion_by_poles(const Point<T>& P0, const Point<T>& J, const Point<T>& A, const Vector<T>& v_A,
                               const Vector<T>& a_A) {
  const T omega = RotationAboutPole<T>(projective(P0), A, v_A).omega();
  const Vector<T> P0A = A - P0, a_P0 = square(omega) * (J - P0);
  const T alpha = quotient(dot(a_A - a_P0, quarter_turn(P0A)), length_squared(P0A));
  return {A, v_A, a_A, omega, alpha};
}

}  // namespace epure::geometry
