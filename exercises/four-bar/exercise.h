// N.3 of the Sapienza sheets: the four-bar linkage. Velocities and accelerations by poles and by polar diagrams,
// inflection and stationarity circles, curvature of C's path; the dead centres of the rocker; adjacent links
// parallel; and a slider-crank whose circles have become lines.
#pragma once

#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "geometry/mechanisms/four_bar_positions.h"

namespace epure::four_bar {

struct Problem {
  FourBarInstant instant;
  Rational AC;
  geometry::Side C_side = geometry::Side::right;  // of A -> B
  Rational lambda;                                // coupler over crank of the slider-crank
};
std::vector<GivenSpec> givens();
Problem problem(const Givens& givens);

// A case of the exercise, by the prefix of its names, and the words that tell it in the meaning of its quantities.
struct Case {
  std::string prefix;
  Words words;
};
Case dead_centre(geometry::Reach reach);
Case parallel_links(geometry::Sense sense, bool of_this_branch);

std::vector<Printed> printed_by_the_source();
std::vector<RouteValue> solve(const Problem& of, Rung rung);

PanelSheet dead_centres_sheet(const Solution& solution, Language language);
PanelSheet parallel_links_sheet(const Solution& solution, Language language, geometry::Sense sense);
PanelSheet slider_crank_sheet(const Solution& solution, Language language);
// In place of a sheet on a dead centre that the rocker has not.
PanelSheet no_dead_centre(const Solution& solution, Language language);

}  // namespace epure::four_bar
