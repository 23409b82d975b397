// N.11 of the Sapienza sheets: the four-bar linkage of N.10 by the method of constraint equations: Newton-Raphson on
// the closure, from a start given, and its derivatives; checked by both earlier methods.
#pragma once

#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "geometry/analytic/constraints.h"

namespace epure::four_bar_constraints {

struct Problem {
  FourBarInstant instant;  // on the branch the iteration found
  geometry::analytic::NewtonRun run;
};
std::vector<GivenSpec> givens();
// Throws BadGivens also when the iteration does not converge, because the Jacobian became singular or for want of
// steps.
Problem problem(const Givens& givens);

// In the solution, of iterate k: its angles, how far they are from the solution's, |ψ|, the ends of the open linkage.
Quantity residual();
Quantity error_of(const Quantity& angle);
Quantity iterate(const Quantity& quantity, std::size_t k);
std::string end_of_coupler(std::size_t k);
std::string end_of_rocker(std::size_t k);
std::size_t iterates(const Solution& solution);

// The two sheets of the iteration.
PanelSheet iterations_sheet(const Solution& solution, Language language);
PanelSheet convergence_sheet(const Solution& solution, Language language);

std::shared_ptr<const Mechanism> linkage(const Solution& solution);

}  // namespace epure::four_bar_constraints
