// A point M carried by a circle or a line that rolls without slipping: its path, and at one instant its velocity, its
// acceleration and the centre of curvature of the path, from the inflection circle. No book's exercise: every given
// is the user's. Metres, seconds, radians; axes and senses as in geometry/motion/rolling.h.
#pragma once

#include <utility>

#include "exercises/kit/panels/plot.h"
#include "exercises/kit/proof/exercise.h"
#include "geometry/analytic/roulette_formulas.h"
#include "geometry/curves/roulettes.h"

namespace epure::roulette {

using geometry::Angle;
using geometry::Rolls;

std::vector<GivenSpec> given_specs();
std::vector<Quantity> quantity_specs();

struct Problem {
  geometry::Rolling rolling;
  Angle phi;           // turned through by the rolling body, in its own sense
  Angle omega, alpha;  // dφ/dt and its derivative

  bool rolls_on_line() const { return rolling.how == Rolls::circle_on_line; }
  bool is_line() const { return rolling.how == Rolls::line_on_circle; }
  geometry::analytic::Roulette closed_form() const;
};
// Throws BadGivens for a circle that does not fit into the other, or a distance that is negative.
Problem problem_of(const Givens& givens);

// "curtate epicycloid": what M traces.
Words name_of_path(const Problem& problem);

std::vector<RouteValue> solved(const Problem& problem, Rung rung);

// The instant in the doubles a drawing takes. Places are from P0, which is always near: the origin of the fixed plane
// need not be.
struct Drawn {
  Problem problem;
  geometry::RouletteSince<double> path;
  double r, R, d, phi, psi, beta;  // ψ: the arc rolled off, as an angle of the rolling circle; β: of the fixed one
  double arches, in_arch;          // ψ: whole turns, and the rest
  Place M, O, J, M_prime;
  Place M_in_plane;                  // in the fixed plane
  std::optional<Place> C = {};       // centre of the rolling circle; a line has none
  std::optional<Place> centre = {};  // of curvature; none at infinity
  Arrow2 n, v, a, a_n, a_t;
  std::optional<double> along_before = {}, along_after = {};  // tangential component; none when ω = 0
  double diameter, s;
  bool is_at_cusp, runs_straight;

  static constexpr Place P0 = {0, 0};
  double P0M() const;
};
Drawn drawn(const Problem& problem);

// The way that is drawn, in radians that the body turns: from so much after the instant (before it when negative) to
// so much after it.
struct Way {
  double from, to;
  int arches;   // begun; 0 for a line, whose path has none
  bool closed;  // the whole curve
};
// `overhang`: what of an arch is drawn beyond both ends of a path that does not close.
Way way_of(const Drawn& f, double overhang);

inline constexpr double letters = 9;  // mm around a point

// Bodies and path, on a picture of the fixed plane.
void draw_ground(Plot& plot, const Drawn& f, const drawings::Box& room);
void draw_body(Plot& plot, const Drawn& f);
std::pair<Place, Place> ends_of_line(const Drawn& f);  // as far as a rolling line is drawn: behind the contact, ahead
void draw_path(Plot& plot, const Drawn& f, const Way& way);

// One sheet each; they add to an empty sheet.
void draw_path_sheet(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);
void draw_instant_sheet(DrawnSheet& onto, const Problem& problem, const SheetRequest& request);

}  // namespace epure::roulette
