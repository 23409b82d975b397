// Exercise N.9 of Sapienza's applied mechanics: the cycloid of a rim point of a wheel that rolls on a line, and the
// involute of a circle; arc travelled, velocity, acceleration and centre of curvature at two instants of each.
//
// The wheel rolls towards +x from the origin, where its tracing point M touches the line. The line rolls off the
// circle about the origin counter-clockwise, M touching it first in (r, 0). Metres, seconds, radians.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/rolling/rolled.h"
#include "geometry/motion/cycloid_by_arc.h"

namespace epure::cycloid_involute {

std::vector<GivenSpec> given_specs();
std::vector<Printed> printed_by_the_source();

struct Problem {
  Rational r;
  Angle omega_1;
  Angle phi;   // first instant of the cycloid: the wheel has turned through φ
  Rational s;  // second: M has travelled s
  Rational r_0;
  Angle omega_2;
  Angle phi_1, phi_2;  // the line has turned through them at both instants of the involute

  explicit Problem(const Givens& givens)
      : r(givens["d"] / 2),
        omega_1(givens.angle("omega_1")),
        phi(givens.angle("phi")),
        s(givens["s"]),
        r_0(givens["d_0"] / 2),
        omega_2(givens.angle("omega_2")),
        phi_1(givens.angle("phi_1")),
        phi_2(givens.angle("phi_2")) {}

  geometry::Rolling wheel() const { return {.how = geometry::Rolls::circle_on_line, .r = r, .d = r}; }
  geometry::Rolling line() const { return {.how = geometry::Rolls::line_on_circle, .R = r_0}; }
  geometry::CycloidArc travelled() const { return {r, s}; }
};

inline const InstantNames at_phi{.before = "cycloid.", .omega = "ω_{1}"},
    at_s{.before = "cycloid.", .after = "_at_s4", .omega = "ω_{1}"},
    at_t1{.before = "involute.", .after = "_t1", .omega = "ω_{2}"},
    at_t2{.before = "involute.", .after = "_t2", .omega = "ω_{2}"};

// The givens that a sheet of one curve leaves to the other.
inline const std::set<std::string> givens_of_involute{"d_0", "omega_2", "t1", "phi_1", "t2", "phi_2"},
    givens_of_cycloid{"d", "omega_1", "phi", "s"};

// Each curve as a student draws it, by twelve divisions, ...
PanelSheet cycloid_sheet(const Solution& solution, Language language);
PanelSheet involute_sheet(const Solution& solution, Language language);
// ... its two instants, ...
PanelSheet cycloid_instants_sheet(const Solution& solution, Language language);
PanelSheet involute_instants_sheet(const Solution& solution, Language language);
// ... and the arc travelled against time, with the speed, which is its slope.
PanelSheet cycloid_travel_sheet(const Solution& solution, Language language);
PanelSheet involute_travel_sheet(const Solution& solution, Language language);

inline const std::vector<std::string> roman{"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X", "XI", "XII"};
inline constexpr int divisions = 12;
struct Division {
  Place on_line, on_body, M;
};

}  // namespace epure::cycloid_involute
