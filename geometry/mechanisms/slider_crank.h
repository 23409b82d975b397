// The slider-crank: crank A₀A turning about the origin, coupler AB, slider B on a straight guide, a point C carried
// by the coupler on the left of A -> B, and M in the middle of AB.
//
// The guide is directed. It passes A₀ at the distance e, positive when it lies on the left of A₀ seen along its
// direction. B is the closure that lies ahead (along the guide) of the foot of A. Centred: e = 0; B then passes the
// outer dead centre at r + l.
//
// Metres, radians, seconds; counter-clockwise positive.
#pragma once

#include <optional>

#include "geometry/mechanisms/dyad.h"
#include "geometry/motion/euler_savary.h"

namespace epure::geometry {

struct SliderCrankLengths {
  Rational r, l, AC, BC;  // A₀A, AB, AC, BC
  Rational e{0};          // of the guide from A₀
};

// ψ is the angle of the crank from the guide's direction. A lies r sin ψ - e to the left of the guide, so the coupler
// reaches it where  lowest <= sin ψ <= highest. A limit that the crank never meets, because the sine would pass ±1,
// is empty; at one that it meets the coupler stands square to the guide. Two limits: the crank swings about the
// guide's direction or about the opposite one. One: about the square to the guide. None: it turns fully.
struct CrankRange {
  bool is_empty = false;  // the linkage closes nowhere: |e| > r + l
  std::optional<Rational> lowest = {}, highest = {};

  bool is_full_turn() const { return !is_empty && !lowest && !highest; }
};

// Decided on the rational lengths. r + |e| = l counts as a full turn: the limit is met, but not passed.
inline CrankRange crank_range(const SliderCrankLengths& of) {
  const Rational lowest = (of.e - of.l) / of.r, highest = (of.e + of.l) / of.r;
  CrankRange range{.is_empty = lowest > 1 || highest < -1};
  if (lowest > -1) range.lowest = lowest;
  if (highest < 1) range.highest = highest;
  return range;
}

// Whether the coupler can turn fully instead (relative to the guide): r >= l + |e|.
inline bool coupler_turns_fully(const SliderCrankLengths& of) { return of.r >= of.l + CGAL::abs(of.e); }

template <class T>
struct SliderCrank {
  Point<T> A0, A, B, C, M;
  Line<T> guide;

  Line<T> crank() const { return line(A0, A); }
  // Square to the guide through B: the normal to the path of B.
  Line<T> normal_at_B() const { return perpendicular(guide, B); }
  // P₀: on the crank's line and on the normal at B. At infinity when these are parallel.
  ProjectivePoint<T> pole() const { return meet(crank(), normal_at_B()); }
};

// The guide in the direction of the unit vector `along`, at the distance e from the origin.
template <class T>
Line<T> guide_of_slider_crank(const T& e, const Vector<T>& along) {
  return {-along.y, along.x, -e};
}

// C by two arcs, radius AC about A and BC about B, on the left of A -> B. Where the longest of AB, AC and BC is the
// sum of the others, which is decided on the rational lengths, the arcs touch on the line AB. Errors as `meet` of two
// circles.
template <class T>
Point<T> plate_corner(const Point<T>& A, const Point<T>& B, const SliderCrankLengths& lengths) {
  const auto& [r, l, AC, BC, e] = lengths;
  const bool ahead = AC + BC == l || l + BC == AC, behind = l + AC == BC;
  if (ahead || behind) return A + from_rational<T>((ahead ? AC : -AC) / l) * (B - A);
  return meet(Circle<T>{A, from_rational<T>(AC)}, Circle<T>{B, from_rational<T>(BC)}, Side::left);
}

// The lengths as numbers, read once for many positions.
template <class T>
struct SliderCrankBars {
  T r, l, e;
  bool is_isosceles;  // decided on the lengths: equal links and a centred guide

  explicit SliderCrankBars(const SliderCrankLengths& of)
      : r(from_rational<T>(of.r)),
        l(from_rational<T>(of.l)),
        e(from_rational<T>(of.e)),
        is_isosceles(of.r == of.l && of.e == 0) {}
};

// B, ahead of the foot of A on the guide. With equal links and a centred guide A is as far from B as from A₀: B is on
// A₀, or twice as far along the guide as A. No root is taken then, which for a crank at, say, 6/13 of a turn no exact
// number could undo. Errors as slider_crank.
template <class T>
Point<T> slider_pin(const SliderCrankBars<T>& of, const Point<T>& A0, const Point<T>& A, const Line<T>& guide) {
  if (!of.is_isosceles) return joint_on_guide(A, of.l, guide, Along::ahead);
  const T ahead = dot(A - A0, guide.direction());
  const Sign decided = sign(ahead);
  if (decided == Sign::undecided)
    throw Undecided("whether the crank points ahead", "se la manovella sia rivolta in avanti");
  return decided == Sign::positive ? A0 + (T(2) * ahead) * guide.direction() : A0;
}

// The mechanism with its crank along the unit vector `crank` and its guide along the unit vector `along`. Throws
// Impossible when the linkage does not close, Undecided when that cannot be told.
template <class T>
SliderCrank<T> slider_crank(const SliderCrankLengths& lengths, const Vector<T>& crank,
                            const Vector<T>& along = {T(1), T(0)}) {
  const SliderCrankBars<T> bars(lengths);
  const Point<T> A0{T(0), T(0)}, A = A0 + bars.r * crank;
  const Line<T> guide = guide_of_slider_crank(bars.e, along);
  const Point<T> B = slider_pin(bars, A0, A, guide);
  return {A0, A, B, plate_corner(A, B, lengths), midpoint(A, B), guide};
}

// Velocities and accelerations by the polar diagrams. The coupler is the dyad's bar, the guide its slide; the joint
// is B.
template <class T>
struct SliderCrankMotion {
  PlaneMotion<T> crank, coupler;
  DyadVelocity<T> velocity;          // v_A + v_BA = v_B; its rates ω₃ and the velocity of sliding
  DyadAcceleration<T> acceleration;  // a_A + a_BA^n + a_BA^t = a_B; α₃ and the acceleration of sliding

  // v_XA and a_XA of a point X of the coupler: AX turned and scaled like AB in the diagram.
  Vector<T> relative_velocity(const Vector<T>& AX) const { return coupler.omega * quarter_turn(AX); }
  Vector<T> relative_acceleration(const Vector<T>& AX) const {
    return coupler.alpha * quarter_turn(AX) - square(coupler.omega) * AX;
  }
  // As the guide's side of the polygons says: along the guide, not by cancellation.
  const Vector<T>& v_B() const { return velocity.second.closing; }
  const Vector<T>& a_B() const { return acceleration.second.closing; }
};

// Throws Impossible when the coupler is square to the guide (a limit position: the crank cannot drive the slider),
// Undecided as ever.
template <class T>
SliderCrankMotion<T> slider_crank_motion(const SliderCrank<T>& at, const T& omega_2, const T& alpha_2) {
  const PlaneMotion<T> crank = turning_about(at.A0, omega_2, alpha_2);
  const Bar<T> coupler{pin_on(crank, at.A)};
  const Slide<T> guide{turning_about(at.A0, T(0), T(0)), at.guide.direction()};
  const DyadVelocity<T> v = dyad_velocity(coupler, guide, at.B);
  const DyadAcceleration<T> a = dyad_acceleration(coupler, guide, at.B, v);
  return {crank, coupler.motion(v.first_rate, a.first_rate), v, a};
}

// The coupler's inflection pole by Euler-Savary, for a finite pole: A' on the ray A₀A, and B itself, whose path is
// straight. It lies on the guide.
template <class T>
ProjectivePoint<T> inflection_pole_by_poles(const SliderCrank<T>& at, const Point<T>& P0) {
  return inflection_pole_by_poles(at.crank(), euler_savary_point(P0, at.A, at.A0), at.normal_at_B(), at.B);
}

// The coupler's motion by the method of poles, for a finite pole (a dead centre, where the pole is B, included).
// Throws Undecided when the pole is at infinity or may be.
template <class T>
PlaneMotion<T> motion_by_poles(const SliderCrank<T>& at, const T& omega_2, const T& alpha_2) {
  const Point<T> P0 = finite(at.pole());
  const Pin<T> A = pin_on(turning_about(at.A0, omega_2, alpha_2), at.A);
  return motion_by_poles(P0, finite(inflection_pole_by_poles(at, P0)), A.at, A.v, A.a);
}

}  // namespace epure::geometry
