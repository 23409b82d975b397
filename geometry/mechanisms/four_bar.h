// The four-bar linkage: crank A₀A turning about the origin, coupler AB, rocker B₀B turning about B₀, and a plate
// carried by the coupler.
//
// Metres, radians, seconds; counter-clockwise positive. The two ways to close the linkage are told apart by the side
// of A -> B₀ on which B lies. The linkage stays on that side while the crank turns, unless B passes the line AB₀: at
// a limit position of the crank.
#pragma once

#include "geometry/mechanisms/dyad.h"
#include "geometry/motion/euler_savary.h"

namespace epure::geometry {

struct FourBarLengths {
  Rational A0A, AB, B0B;
  Rational x_B0, y_B0;  // B₀; the frame A₀B₀ need not have a rational length
};

template <class T>
struct FourBar {
  Point<T> A0, A, B, B0;

  Line<T> crank() const { return line(A0, A); }
  Line<T> rocker() const { return line(B0, B); }
  // P₀: on the crank's line and on the rocker's. At infinity when these are parallel; (0, 0, 0) when they coincide.
  ProjectivePoint<T> pole() const { return meet(crank(), rocker()); }
};

template <class T>
Point<T> rocker_hinge(const FourBarLengths& of) {
  return {from_rational<T>(of.x_B0), from_rational<T>(of.y_B0)};
}

// The lengths as numbers, read once for many positions.
template <class T>
struct FourBarBars {
  T A0A, AB, B0B;
  Point<T> B0;
  // Decided on the lengths: coupler and rocker are as long as crank and frame, or as frame and crank. A rhombus is
  // both.
  bool is_kite, is_parallelogram;

  explicit FourBarBars(const FourBarLengths& of)
      : A0A(from_rational<T>(of.A0A)),
        AB(from_rational<T>(of.AB)),
        B0B(from_rational<T>(of.B0B)),
        B0(rocker_hinge<T>(of)),
        is_kite(of.AB == of.A0A && of.B0B * of.B0B == of.x_B0 * of.x_B0 + of.y_B0 * of.y_B0),
        is_parallelogram(of.B0B == of.A0A && of.AB * of.AB == of.x_B0 * of.x_B0 + of.y_B0 * of.y_B0) {}
};

// B of a kite or parallelogram. The circles that find it meet in A₀, or in the fourth corner of the parallelogram on
// A, A₀, B₀; and where that is mirrored in the line A B₀. So no root is taken, which for a crank at, say, 5/13 of a
// turn would be the root of a square that no exact number could undo. Errors as four_bar.
template <class T>
Point<T> joint_known_beforehand(const FourBarBars<T>& of, const Point<T>& A0, const Point<T>& A, Side side) {
  const Sign apart = sign(length_squared(of.B0 - A));
  if (apart == Sign::zero) throw Impossible("the circles are concentric", "le circonferenze sono concentriche");
  if (apart == Sign::undecided) throw Undecided("whether A lies on B0", "se A stia su B0");
  const Line<T> AB0 = line(A, of.B0);
  const Point<T> fourth = A + (of.B0 - A0), known = of.is_parallelogram ? fourth : A0;
  const Sign lies = geometry::side(known, AB0);
  if (lies == Sign::undecided)
    throw Undecided("on which side of AB0 a meeting point of circles lies",
                    "da quale parte di AB0 stia un'intersezione di circonferenze");
  if (lies == Sign::zero || (lies == Sign::positive) == (side == Side::left)) return known;
  if (of.is_kite && of.is_parallelogram) return A0;
  return known + T(2) * (foot(known, AB0) - known);
}

// The linkage with its crank along the unit vector `crank`. Throws Impossible when it does not close (B₀ on A₀ with
// equal bars closes anyhow and is Impossible too: B is not determined), Undecided when that cannot be told.
template <class T>
FourBar<T> four_bar(const FourBarBars<T>& of, const Vector<T>& crank, Side side) {
  const Point<T> A0{T(0), T(0)}, A = A0 + of.A0A * crank;
  if (of.is_kite || of.is_parallelogram) return {A0, A, joint_known_beforehand(of, A0, A, side), of.B0};
  return {A0, A, joint_of_bars(A, of.AB, of.B0, of.B0B, side), of.B0};
}
template <class T>
FourBar<T> four_bar(const FourBarLengths& of, const Vector<T>& crank, Side side) {
  return four_bar(FourBarBars<T>(of), crank, side);
}

// Velocities and accelerations by the polar diagrams. Coupler and rocker are the dyad's two bars; its joint is B.
template <class T>
struct FourBarMotion {
  PlaneMotion<T> crank, coupler, rocker;
  DyadVelocity<T> velocity;          // v_A + v_BA = v_B
  DyadAcceleration<T> acceleration;  // a_A + a_BA^n + a_BA^t = a_B^n + a_B^t
};

// Throws Impossible when coupler and rocker are in line (a limit position of the crank), Undecided as ever.
template <class T>
FourBarMotion<T> four_bar_motion(const FourBar<T>& at, const T& omega_2, const T& alpha_2) {
  const PlaneMotion<T> crank = turning_about(at.A0, omega_2, alpha_2);
  const Bar<T> coupler{pin_on(crank, at.A)}, rocker{fixed_pin(at.B0)};
  const DyadVelocity<T> v = dyad_velocity(coupler, rocker, at.B);
  const DyadAcceleration<T> a = dyad_acceleration(coupler, rocker, at.B, v);
  return {crank, coupler.motion(v.first_rate, a.first_rate), rocker.motion(v.second_rate, a.second_rate), v, a};
}

// The coupler's inflection pole by Euler-Savary, for a finite pole: A' and B' on the rays A₀A and B₀B.
template <class T>
ProjectivePoint<T> inflection_pole_by_poles(const FourBar<T>& at, const Point<T>& P0) {
  return inflection_pole_by_poles(at.crank(), euler_savary_point(P0, at.A, at.A0), at.rocker(),
                                  euler_savary_point(P0, at.B, at.B0));
}

// The corner C of a plate on the hypotenuse AB with its right angle at C, on the named side of A -> B; AC <= AB.
// By Thales: C lies over the foot that AC²/AB cuts off. Throws Impossible when AC > AB.
template <class T>
Point<T> right_angled_corner(const Point<T>& A, const Point<T>& B, const Rational& AB, const Rational& AC,
                             Side side) {
  if (AC > AB)
    throw Impossible("the plate's side AC is longer than its hypotenuse AB",
                     "il lato AC della piastra è più lungo della sua ipotenusa AB");
  const Rational along = AC * AC / (AB * AB);
  const T across = from_rational<T>(AC / AB) * root(from_rational<T>(1 - along));
  const Vector<T> AB_vector = B - A;
  return A +
         (from_rational<T>(along) * AB_vector + (side == Side::left ? across : -across) * quarter_turn(AB_vector));
}

}  // namespace epure::geometry
