// An eccentric disc with a translating roller follower: the disc's centre A turns about A₀, the roller's centre B
// moves along a straight guide, and where disc and roller touch lies on AB, whose length is the sum of their radii.
// So the follower moves like the slider of a crank A₀A with a coupler AB: the equivalent mechanism.
//
// The guide is directed; it passes A₀ at the distance e, on the left when e > 0, as that of a slider-crank.
// Metres, radians, seconds; counter-clockwise positive.
#pragma once

#include "geometry/mechanisms/dyad.h"
#include "geometry/mechanisms/slider_crank.h"

namespace epure::geometry {

struct RollerCamLengths {
  Rational eccentricity, disc, roller;  // A₀A, radii
  Rational e{0};                        // of the guide from A₀

  Rational reach() const { return disc + roller; }  // AB
  // The follower goes with every position of the cam, and never comes to stand across its guide.
  bool turns_fully() const { return eccentricity + CGAL::abs(e) < reach(); }
};

template <class T>
struct RollerCam {
  Point<T> A0, A, B;
  Line<T> guide;

  Vector<T> AB() const { return B - A; }
  // Of the disc's rim and the roller.
  Point<T> contact(const RollerCamLengths& of) const { return A + from_rational<T>(of.disc / of.reach()) * AB(); }
  // P₂₃: on the common normal AB, and on the line of the other two poles of bodies 1, 2, 3, A₀ and the guide's
  // normal.
  ProjectivePoint<T> relative_pole() const { return meet(line(A, B), perpendicular(guide, A0)); }
  // The same motion with a crank and a coupler.
  SliderCrank<T> equivalent() const { return {A0, A, B, B, midpoint(A, B), guide}; }
};

// With A in the direction of the unit vector `towards_A` and the guide along the unit vector `along`.
template <class T>
RollerCam<T> roller_cam(const RollerCamLengths& of, const Vector<T>& towards_A, const Vector<T>& along) {
  const Point<T> A0{T(0), T(0)}, A = A0 + from_rational<T>(of.eccentricity) * towards_A;
  const Line<T> guide = guide_of_slider_crank(from_rational<T>(of.e), along);
  return {A0, A, joint_on_guide(A, from_rational<T>(of.reach()), guide, Along::ahead), guide};
}

// Where A lies between A₀ and B (the follower is farthest), or A₀ between A and B (it is nearest).
enum class DeadCentre { farthest, nearest };
template <class T>
RollerCam<T> roller_cam_at(DeadCentre which, const RollerCamLengths& of, const Vector<T>& along) {
  const bool is_farthest = which == DeadCentre::farthest;
  const Rational r = is_farthest ? of.eccentricity : Rational(-of.eccentricity), A0B = of.reach() + r;
  const Point<T> A0{T(0), T(0)};
  const Line<T> guide = guide_of_slider_crank(from_rational<T>(of.e), along);
  const Point<T> B = joint_on_guide(A0, from_rational<T>(A0B), guide, Along::ahead);
  return {A0, A0 + from_rational<T>(r / A0B) * (B - A0), B, guide};
}

// By the theorem of relative motions, with the cam as the moving frame: B goes round A on it, on a circle. The cam
// turns uniformly.
//   v_B3 = v_B2 + v_B32                        v_B3 along the guide, v_B32 across AB
//   a_B3 = a_B2 + a_B32^n + a_B32^t + a_c      a_B3 along the guide, a_B32^t across AB
template <class T>
struct RollerCamMotion {
  Vector<T> v_A, v_B2, v_B32, v_B3;
  Vector<T> a_A, a_B2, normal, tangential, coriolis, a_B3;
};

template <class T>
RollerCamMotion<T> relative_motion(const RollerCam<T>& at, const T& omega) {
  const PlaneMotion<T> cam = turning_about(at.A0, omega, T(0));
  const Vector<T> AB = at.AB(), across = quarter_turn(AB), along = at.guide.direction();
  RollerCamMotion<T> m;
  m.v_A = cam.velocity(at.A), m.a_A = cam.acceleration(at.A);
  m.v_B2 = cam.velocity(at.B), m.a_B2 = cam.acceleration(at.B);
  const auto [turning, speed] = close_polygon(m.v_B2, across, along);
  m.v_B32 = turning * across, m.v_B3 = speed * along;
  m.normal = -(square(turning) * AB);
  m.coriolis = (T(2) * omega) * quarter_turn(m.v_B32);
  const auto [growth, acceleration] = close_polygon(m.a_B2 + m.normal + m.coriolis, across, along);
  m.tangential = growth * across, m.a_B3 = acceleration * along;
  return m;
}

// The same by the equivalent mechanism: the coupler's motion less the cam's is the relative one.
template <class T>
RollerCamMotion<T> motion_by_equivalent(const RollerCam<T>& at, const T& omega) {
  const SliderCrankMotion<T> of = slider_crank_motion(at.equivalent(), omega, T(0));
  const Vector<T> AB = at.AB();
  const T relative = of.coupler.omega - omega;
  RollerCamMotion<T> m;
  m.v_A = of.crank.velocity(at.A), m.a_A = of.crank.acceleration(at.A);
  m.v_B2 = of.crank.velocity(at.B), m.a_B2 = of.crank.acceleration(at.B);
  m.v_B3 = of.v_B(), m.a_B3 = of.a_B();
  m.v_B32 = relative * quarter_turn(AB);
  m.normal = -(square(relative) * AB);
  m.tangential = of.coupler.alpha * quarter_turn(AB);
  m.coriolis = (T(2) * omega * relative) * -AB;
  return m;
}

}  // namespace epure::geometry
