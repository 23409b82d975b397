// The centred slider-crank: crank A₀A turning about the origin, coupler AB, slider B on the guide y = 0, a point C
// carried by the coupler on the left of A -> B, and M in the middle of AB.
//
// Metres, radians, seconds; counter-clockwise positive. B is the closure that lies ahead (towards +x) of the foot of
// A on the guide: the one that passes the outer dead centre B = r + l.
#pragma once

#include "geometry/constructions/circle.h"
#include "geometry/constructions/polygon.h"
#include "geometry/motion/plane_motion.h"

namespace epure::geometry {

struct SliderCrankLengths {
  Rational r, l, AC, BC;  // A₀A, AB, AC, BC
};

template <class T>
struct SliderCrank {
  Point<T> A0, A, B, C, M;
  Line<T> guide;  // directed towards +x

  // P₀: on the crank's line, and on the perpendicular to the guide through B. At infinity when these are parallel.
  ProjectivePoint<T> pole() const { return meet(line(A0, A), perpendicular(guide, B)); }
};

template <class T>
Line<T> guide_of_slider_crank() {
  return line(Point<T>{T(0), T(0)}, Vector<T>{T(1), T(0)});
}

// B for a crank pin at A. Throws Impossible when the linkage does not close, Undecided when that cannot be told.
template <class T>
Point<T> slider_pin(const Point<T>& A, const T& l) {
  return meet(Circle<T>{A, l}, guide_of_slider_crank<T>(), Along::ahead);
}

// C by two arcs, radius AC about A and BC about B, on the left of A -> B. Where the longest of AB, AC and BC is the
// sum of the others, which is decided on the rational lengths, the arcs touch on the line AB. Errors as `meet` of two
// circles.
template <class T>
Point<T> plate_corner(const Point<T>& A, const Point<T>& B, const SliderCrankLengths& lengths) {
  const auto& [r, l, AC, BC] = lengths;
  const bool ahead = AC + BC == l || l + BC == AC, behind = l + AC == BC;
  if (ahead || behind) return A + from_rational<T>((ahead ? AC : -AC) / l) * (B - A);
  return meet(Circle<T>{A, from_rational<T>(AC)}, Circle<T>{B, from_rational<T>(BC)}, Side::left);
}

// The mechanism with its crank along the unit vector `crank`.
template <class T>
SliderCrank<T> slider_crank(const SliderCrankLengths& lengths, const Vector<T>& crank) {
  const Point<T> A0{T(0), T(0)};
  const Point<T> A = A0 + from_rational<T>(lengths.r) * crank;
  const Point<T> B = slider_pin(A, from_rational<T>(lengths.l));
  return {A0, A, B, plate_corner(A, B, lengths), midpoint(A, B), guide_of_slider_crank<T>()};
}

// The polar diagram of velocity: v_B = v_A + v_BA with the two directions known; ω₃ from v_BA = ω₃ k x AB.
// Throws Impossible when the coupler is square to the guide (the crank cannot drive the slider), Undecided as ever.
template <class T>
struct VelocityDiagram {
  Vector<T> v_A, v_B, v_BA;
  T omega_3;
  Vector<T> relative(const Vector<T>& AX) const { return omega_3 * quarter_turn(AX); }  // v_XA
};
template <class T>
VelocityDiagram<T> velocity_diagram(const SliderCrank<T>& at, const T& omega_2) {
  const Vector<T> v_A = omega_2 * quarter_turn(at.A - at.A0);
  const Vector<T> square_to_AB = quarter_turn(at.B - at.A), along_guide = at.guide.direction();
  const auto [omega_3, v_B] = close_polygon(v_A, square_to_AB, along_guide);
  return {v_A, v_B * along_guide, omega_3 * square_to_AB, omega_3};
}

// The polar diagram of acceleration: a_B = a_A + a_BA^n + a_BA^t; α₃ from a_BA^t = α₃ k x AB.
template <class T>
struct AccelerationDiagram {
  Vector<T> a_A_n, a_A_t, a_A, a_BA_n, a_BA_t, a_B;
  T omega_3, alpha_3;
  // a_XA: AX turned and scaled like AB in the diagram.
  Vector<T> relative(const Vector<T>& AX) const { return alpha_3 * quarter_turn(AX) - square(omega_3) * AX; }
};
template <class T>
AccelerationDiagram<T> acceleration_diagram(const SliderCrank<T>& at, const T& omega_2, const T& alpha_2,
                                            const T& omega_3) {
  const Vector<T> crank = at.A - at.A0, AB = at.B - at.A;
  const Vector<T> a_A_n = -(square(omega_2) * crank), a_A_t = alpha_2 * quarter_turn(crank);
  const Vector<T> a_A = a_A_n + a_A_t, a_BA_n = -(square(omega_3) * AB);
  const Vector<T> along_guide = at.guide.direction();
  const auto [alpha_3, a_B] = close_polygon(a_A + a_BA_n, quarter_turn(AB), along_guide);
  return {a_A_n, a_A_t, a_A, a_BA_n, alpha_3 * quarter_turn(AB), a_B * along_guide, omega_3, alpha_3};
}

// Rotation about a pole that may be at infinity, known by the velocity v_A of one point A that is not the pole.
template <class T>
struct RotationAboutPole {
  ProjectivePoint<T> P0;
  T share;  // ω₃ / w

  RotationAboutPole(const ProjectivePoint<T>& pole, const Point<T>& A, const Vector<T>& v_A)
      : P0(pole), share(quotient(cross(from_pole(A), v_A), length_squared(from_pole(A)))) {}

  T omega() const { return share * P0.w; }
  Vector<T> velocity(const Point<T>& X) const { return share * quarter_turn(from_pole(X)); }

 private:
  // w times the vector from the pole to X.
  Vector<T> from_pole(const Point<T>& X) const { return {X.x * P0.w - P0.x, X.y * P0.w - P0.y}; }
};

// The method of poles carried to the second order, for a finite pole P0: the inflection circle through P0, the slider
// B (its path is straight) and A' (Euler-Savary: P₀A² = A₀A . A'A on the ray P₀A), and the state it determines.
template <class T>
PlaneMotion<T> motion_by_poles(const SliderCrank<T>& at, const T& omega_2, const T& alpha_2);

// P₀X² = (X to centre) (X to X'): X' on the ray from P0 through X, for a path with centre of curvature `centre`.
template <class T>
Point<T> euler_savary_point(const Point<T>& P0, const Point<T>& X, const Point<T>& centre) {
  const Vector<T> to_centre = centre - X;
  return X + quotient(length_squared(P0 - X), length_squared(to_centre)) * to_centre;
}

// J, opposite P0 on the inflection circle: P0J is seen at right angles from B, so J lies on the guide, and from A'.
// Its ordinate is zero by construction, not by cancellation.
template <class T>
ProjectivePoint<T> inflection_pole_by_poles(const SliderCrank<T>& at) {
  const Point<T> P0 = finite(at.pole()), A_prime = euler_savary_point(P0, at.A, at.A0);
  return meet(at.guide, perpendicular(line(P0, A_prime), A_prime));
}

template <class T>
PlaneMotion<T> motion_by_poles(const SliderCrank<T>& at, const T& omega_2, const T& alpha_2) {
  const Point<T> P0 = finite(at.pole());
  const Vector<T> crank = at.A - at.A0, P0A = at.A - P0, v_A = omega_2 * quarter_turn(crank);
  const Vector<T> a_A = alpha_2 * quarter_turn(crank) - square(omega_2) * crank;
  const T omega_3 = RotationAboutPole<T>(at.pole(), at.A, v_A).omega();
  const Cycle<T> inflection = cycle_through(P0, euler_savary_point(P0, at.A, at.A0), at.B);
  // The pole itself is accelerated towards the inflection pole J: a_P0 = ω₃² P₀J, with P₀J a diameter.
  const Vector<T> a_P0 = (T(2) * square(omega_3)) * (finite(inflection.centre()) - P0);
  const T alpha_3 = quotient(dot(a_A - a_P0, quarter_turn(P0A)), length_squared(P0A));
  return {at.A, v_A, a_A, omega_3, alpha_3};
}

}  // namespace epure::geometry
