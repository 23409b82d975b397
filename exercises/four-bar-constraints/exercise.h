// N.11 of the Sapienza sheets: the four-bar linkage of N.10 by the method of constraint equations: Newton-Raphson on
// the closure, from a start given, and its derivatives; checked by both earlier methods.
#pragma once

#include "exercises/kit/linkages/four_bar_figure.h"
#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/linkages/four_bar_on_x.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/proof/exercise.h"
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

std::vector<Quantity> quantities();
std::vector<Printed> printed_by_the_source();
std::vector<RouteValue> solve(const Problem& of, Rung rung);

// One quantity as each method gives it, in doubles.
struct Compared {
  std::string symbol, unit;
  double by_constraints = 0, by_analysis = 0, by_polar_diagram = 0;
};

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  Problem of;
  FourBarFigure figure;
  MidpointMotion<double> motion;
  std::vector<Compared> compared = {};

  const std::vector<geometry::analytic::NewtonIterate>& iterates() const { return of.run.iterates; }
  // The open linkage of an iterate: the coupler's end, and the rocker's.
  Place coupler_end(std::size_t iterate) const;
  Place rocker_end(std::size_t iterate) const;
};
Drawn drawn(const Problem& of);

// One sheet each; they add to an empty sheet.
void draw_iterations(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_convergence(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_velocities(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_accelerations(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

}  // namespace epure::four_bar_constraints
