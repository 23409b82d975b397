// N.10 of the Sapienza sheets: the four-bar linkage by its closure equations, checked by the polar diagrams and by
// poles; curvature of the path of the coupler's midpoint; the rocker's angular velocity over a full turn of the
// crank; and the path of any coupler point.
#pragma once

#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure::four_bar_analytic {

struct Problem {
  FourBarInstant instant;
  Rational AP_along, AP_across;  // P in the coupler's frame: along A -> B and to the left of it
};
inline FourBarInstant on_other_branch(const FourBarInstant& at) {
  FourBarInstant other = at;
  other.side = geometry::opposite(at.side);
  return other;
}

template <class T>
geometry::Point<T> coupler_point(const Problem& of, const geometry::FourBar<T>& at) {
  const geometry::Vector<T> AB = at.B - at.A;
  const T along = geometry::from_rational<T>(of.AP_along / of.instant.lengths.AB);
  const T across = geometry::from_rational<T>(of.AP_across / of.instant.lengths.AB);
  return at.A + (along * AB + across * quarter_turn(AB));
}

std::vector<GivenSpec> givens();
Problem problem(const Givens& givens);

std::vector<Printed> printed_by_the_source();
std::vector<RouteValue> solve(const Givens& givens, Rung rung);

// The linkage with points of its links, and how it is written: "G2". Among many positions there is no room for the
// arrow that tells the crank's sense.
Mechanism linkage(const Solution& solution, const std::vector<std::string>& points, bool with_sense = true);

// The sheets that have panels of their own.
PanelSheet configurations_sheet(const Solution& solution, Language language);
PanelSheet curvature_sheet(const Solution& solution, Language language);
PanelSheet omega_4_sheet(const Solution& solution, Language language);
PanelSheet coupler_curve_sheet(const Solution& solution, Language language);

}  // namespace epure::four_bar_analytic
