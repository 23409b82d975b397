// N.10 of the Sapienza sheets: the four-bar linkage by its closure equations, checked by the polar diagrams and by
// poles; curvature of the path of the coupler's midpoint; the rocker's angular velocity over a full turn of the
// crank; and the path of any coupler point.
#pragma once

#include "exercises/kit/linkages/four_bar_figure.h"
#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/proof/exercise.h"

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

std::vector<Quantity> quantities();
std::vector<Printed> printed_by_the_source();
std::vector<RouteValue> solve(const Problem& of, Rung rung);

// ω₄ over a full turn of the crank at the speed given and held.
struct RockerSpeed {
  struct Extreme {
    geometry::Vector<double> crank;
    double omega_4;
  };
  std::vector<Extreme> extremes = {};
  std::vector<geometry::Vector<double>> zeros = {};  // directions of the crank
  Words why_no_extremes = {};                        // empty when there are some
};
RockerSpeed rocker_speed(const FourBarInstant& at);

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  Problem of;
  FourBarFigure figure, other;  // the configuration chosen, and the other one
  Place P;
  double omega_2 = 0, omega_3 = 0, omega_4 = 0, alpha_3 = 0, alpha_4 = 0;
  double omega_3_other = 0, omega_4_other = 0, alpha_3_other = 0, alpha_4_other = 0;
  Arrow2 v_G3 = {}, a_G3 = {};
  VectorPolygon velocity = {}, acceleration = {};
  std::optional<Place> P0 = {}, J = {}, K = {};           // none when at infinity
  std::optional<Place> A_prime = {}, B_prime = {};        // on the inflection circle
  std::optional<Place> G3_prime = {}, centre_of_G3 = {};  // on it, and the centre of curvature
  DrawnCycle inflection = {};

  Place G2() const { return figure.points.at(0).at; }
  Place G3() const { return figure.points.at(1).at; }
  Place G4() const { return figure.points.at(2).at; }
};
Drawn drawn(const Problem& of);

// One sheet each; they add to an empty sheet.
void draw_configurations(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_velocities(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_accelerations(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_curvature(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_omega_4(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_coupler_curve(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

}  // namespace epure::four_bar_analytic
