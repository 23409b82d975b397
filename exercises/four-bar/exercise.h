// N.3 of the Sapienza sheets: the four-bar linkage. Velocities and accelerations by poles and by polar diagrams,
// inflection and stationarity circles, curvature of C's path; the dead centres of the rocker; adjacent links
// parallel; and a slider-crank whose circles have become lines.
#pragma once

#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/proof/exercise.h"

namespace epure::four_bar {

struct Problem {
  FourBarInstant instant;
  Rational AC;
  geometry::Side C_side = geometry::Side::right;  // of A -> B
  Rational lambda;                                // coupler over crank of the slider-crank
};
std::vector<GivenSpec> givens();
Problem problem(const Givens& givens);

std::vector<Quantity> quantities();
std::vector<Printed> printed_by_the_source();
std::vector<RouteValue> solve(const Problem& of, Rung rung);

}  // namespace epure::four_bar
