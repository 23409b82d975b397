// The givens, and when they are impossible.
#include <fmt/format.h>

#include "exercises/four-bar/exercise.h"

namespace epure::four_bar {

std::vector<GivenSpec> givens() {
  return {{"A0A", {"crank A₀A", "manovella A₀A"}, "m", "0.15", Range::positive, "$A_{0}A$"},
          {"AB", {"coupler AB", "biella AB"}, "m", "0.37", Range::positive, "$AB$"},
          {"B0B", {"rocker B₀B", "bilanciere B₀B"}, "m", "0.45", Range::positive, "$B_{0}B$"},
          {"x_B0",
           {"abscissa of the rocker's hinge", "ascissa della cerniera del bilanciere"},
           "m",
           "-0.18",
           Range::any,
           "$x_{B0}$"},
          {"y_B0",
           {"ordinate of the rocker's hinge", "ordinata della cerniera del bilanciere"},
           "m",
           "-0.16",
           Range::any,
           "$y_{B0}$"},
          side_given("branch", {"side of A → B₀ on which B lies", "lato di A → B₀ dal quale sta B"}, "right", "$B$",
                     "$AB_{0}$"),
          {"AC",
           {"side AC of the coupler plate, square to BC", "lato AC della piastra di biella, normale a BC"},
           "m",
           "0.33",
           Range::positive,
           "$AC$"},
          side_given("C_side", {"side of A → B on which C lies", "lato di A → B dal quale sta C"}, "right", "$C$",
                     "$AB$"),
          {"n",
           {"crank speed, counter-clockwise", "velocità della manovella, antioraria"},
           "rpm",
           "50",
           Range::any,
           "$n_{2}$"},
          instant_given("0.1", Range::any),
          crank_angle_given(),
          {"alpha_2",
           {"angular acceleration of the crank", "accelerazione angolare della manovella"},
           "rad/s^2",
           "0",
           Range::any,
           "$α_{2}$"},
          {"lambda",
           {"coupler over crank of the slider-crank (sub-exercise 2)",
            "biella su manovella del manovellismo (esercizio 2)"},
           "1",
           "3",
           Range::positive,
           "$λ$"}};
}

Problem problem(const Givens& givens) {
  Problem of{.instant = {.lengths = {givens["A0A"], givens["AB"], givens["B0B"], givens["x_B0"], givens["y_B0"]},
                         .side = side_chosen(givens, "branch"),
                         .n = givens.angle("n"),
                         .crank = givens.angle("phi"),
                         .alpha_2 = givens.angle("alpha_2")},
             .AC = givens["AC"],
             .C_side = side_chosen(givens, "C_side"),
             .lambda = givens["lambda"]};
  if (of.AC > of.instant.lengths.AB)
    throw BadGivens(
        format_words("the plate has no right angle at C: AC = {} m is longer than the hypotenuse AB = {} m",
                     "la piastra non ha angolo retto in C: AC = {} m è più lungo dell'ipotenusa AB = {} m",
                     decimal(CGAL::to_double(of.AC), 6), decimal(CGAL::to_double(of.instant.lengths.AB), 6)));
  if (of.lambda <= 1)
    throw BadGivens(
        format_words("lambda = {}: with its crank square to the guide the slider-crank closes only if the coupler is "
                     "longer than the crank, lambda > 1",
                     "lambda = {}: con la manovella perpendicolare alla guida il manovellismo si chiude solo se la "
                     "biella è più lunga della manovella, lambda > 1",
                     decimal(CGAL::to_double(of.lambda), 6)));
  require_drivable(of.instant);
  return of;
}

}  // namespace epure::four_bar
