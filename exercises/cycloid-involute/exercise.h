// Exercise N.9 of Sapienza's applied mechanics: the cycloid of a rim point of a wheel that rolls on a line, and the
// involute of a circle; arc travelled, velocity, acceleration and centre of curvature at two instants of each.
//
// The wheel rolls towards +x from the origin, where its tracing point M touches the line. The line rolls off the
// circle about the origin counter-clockwise, M touching it first in (r, 0). Metres, seconds, radians.
#pragma once

#include "exercises/kit/panels/plot.h"
#include "exercises/kit/proof/exercise.h"
#include "geometry/curves/roulettes.h"
#include "geometry/motion/cycloid_by_arc.h"

namespace epure::cycloid_involute {

using geometry::Angle;

std::vector<GivenSpec> given_specs();
std::vector<Quantity> quantity_specs();
std::vector<Printed> printed_by_the_source();

// |dM/dφ| / r of the involute's equations as the source prints them, x = r (cos φ - φ sin φ). That of an involute is
// φ, from which the source has its speeds.
double printed_equation_speed(double phi);

struct Problem {
  Rational r;
  Angle omega_1;
  Angle phi;   // first instant of the cycloid: the wheel has turned through φ
  Rational s;  // second: M has travelled s
  Rational r_0;
  Angle omega_2;
  Angle phi_1, phi_2;  // the line has turned through them at both instants of the involute

  geometry::Rolling wheel() const { return {.how = geometry::Rolls::circle_on_line, .r = r, .d = r}; }
  geometry::Rolling line() const { return {.how = geometry::Rolls::line_on_circle, .R = r_0}; }
  geometry::CycloidArc travelled() const { return {r, s}; }
};
Problem problem_of(const Givens& givens);

// Names of quantities at an instant: "cycloid." before, "_at_s4", "_t1" after.
struct InstantNames {
  std::string before, after = {};
  std::string operator()(const std::string& quantity) const { return before + quantity + after; }
};
inline const InstantNames at_phi{"cycloid."}, at_s{"cycloid.", "_at_s4"}, at_t1{"involute.", "_t1"},
    at_t2{"involute.", "_t2"};

std::vector<RouteValue> solved(const Problem& problem, Rung rung);

// An instant in the doubles a drawing takes. The cycloid's is moved back by whole arches, into the first.
struct DrawnInstant {
  InstantNames names;
  Place P0{0, 0}, M{0, 0}, J{0, 0}, M_prime{0, 0}, centre{0, 0};  // centre of curvature: always finite here
  Arrow2 v{0, 0}, a{0, 0}, a_n{0, 0}, a_t{0, 0};
  double along_before = 0, along_after = 0;  // tangential component of a; they differ at a cusp
  double rho = 0;
  bool is_at_cusp = false;
  bool is_first_arch = true;     // so that P0, M and the others are where they are drawn
  double phi = 0, t = 0, s = 0;  // angle turned through, time, arc travelled since the start
};
DrawnInstant drawn_at_phi(const Problem& problem);
DrawnInstant drawn_at_s(const Problem& problem);
DrawnInstant drawn_on_involute(const Problem& problem, const Angle& phi, const InstantNames& names);

// One sheet each; they add to an empty sheet.
void draw_cycloid(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);
void draw_cycloid_instants(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);
void draw_cycloid_travel(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);
void draw_involute(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);
void draw_involute_instants(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);
void draw_involute_travel(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);

}  // namespace epure::cycloid_involute
