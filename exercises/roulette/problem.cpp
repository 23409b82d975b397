// What is given and what is asked.
#include <fmt/format.h>

#include "exercises/roulette/exercise.h"
#include "geometry/numbers/given.h"

namespace epure::roulette {

std::vector<GivenSpec> given_specs() {
  return {
      {.symbol = "how",
       .meaning = {"what rolls on what", "che cosa rotola su che cosa"},
       .unit = "1",
       .stated = "circle_outside_circle",
       .range = Range::any,
       .choices = {{"circle_on_line", {"circle on a line", "cerchio su una retta"}},
                   {"circle_outside_circle", {"circle outside a circle", "cerchio esterno a un cerchio"}},
                   {"circle_inside_circle", {"circle inside a circle", "cerchio interno a un cerchio"}},
                   {"line_on_circle", {"line on a circle", "retta su un cerchio"}}}},
      {"r", {"radius of the rolling circle", "raggio del cerchio che rotola"}, "m", "0.15", Range::positive, "$r$"},
      {"R", {"radius of the fixed circle", "raggio del cerchio fisso"}, "m", "0.45", Range::positive, "$R$"},
      {"d",
       {"distance of M from the centre of the rolling circle; of a line, from the line, positive inwards",
        "distanza di M dal centro del cerchio che rotola; di una retta, dalla retta, positiva verso il centro"},
       "m",
       "0.15",
       Range::any,
       "$d$"},
      {"phi",
       {"angle the rolling body has turned through, in its sense", "angolo di cui è ruotato il corpo, nel suo verso"},
       "deg",
       "160",
       Range::any,
       "$φ$"},
      {.symbol = "phi_rad",
       .meaning = {"more of that angle, in radians", "altra parte di quell'angolo, in radianti"},
       .unit = "rad",
       .stated = "0",
       .range = Range::any,
       .letters = "$φ$ +",
       .beyond_source = true},
      {"omega",
       {"angular velocity of the rolling body, in its sense", "velocità angolare del corpo, nel suo verso"},
       "rad/s",
       "2",
       Range::any,
       "$ω$"},
      {"alpha",
       {"angular acceleration of the rolling body, in its sense", "accelerazione angolare del corpo, nel suo verso"},
       "rad/s^2",
       "0",
       Range::any,
       "$α$"}};
}

std::vector<Quantity> quantity_specs() {
  return {
      {"M_x", "$x_{M}$", "m", {"abscissa of M", "ascissa di M"}},
      {"M_y", "$y_{M}$", "m", {"ordinate of M", "ordinata di M"}},
      {"P0_x", "$x_{P0}$", "m", {"abscissa of the contact, the pole", "ascissa del contatto, il polo"}},
      {"P0_y", "$y_{P0}$", "m", {"ordinate of the contact, the pole", "ordinata del contatto, il polo"}},
      {"P0M", "$P_{0}M$", "m", {"distance of M from the pole", "distanza di M dal polo"}},
      {"s", "$s$", "m", {"arc M has travelled since φ = 0", "arco percorso da M da φ = 0"}},
      {"v_M_x", "$v_{Mx}$", "m/s", {"velocity of M, along x", "velocità di M, lungo x"}},
      {"v_M_y", "$v_{My}$", "m/s", {"velocity of M, along y", "velocità di M, lungo y"}},
      {"v_M", "$v_{M}$", "m/s", {"speed of M", "velocità di M"}},
      {"a_M_x", "$a_{Mx}$", "m/s^2", {"acceleration of M, along x", "accelerazione di M, lungo x"}},
      {"a_M_y", "$a_{My}$", "m/s^2", {"acceleration of M, along y", "accelerazione di M, lungo y"}},
      {"a_M", "$a_{M}$", "m/s^2", {"acceleration of M", "accelerazione di M"}},
      {"a_M_n", "$a^{n}_{M}$", "m/s^2", {"normal part of the acceleration", "parte normale dell'accelerazione"}},
      {"a_M_t_before",
       "$a^{t-}_{M}$",
       "m/s^2",
       {"tangential part, just before the instant", "parte tangenziale, subito prima dell'istante"}},
      {"a_M_t_after",
       "$a^{t+}_{M}$",
       "m/s^2",
       {"tangential part, just after: another at a cusp only",
        "parte tangenziale, subito dopo: altra solo in una cuspide"}},
      {"inflection_diameter", "$δ$", "m", {"diameter of the inflection circle", "diametro del cerchio dei flessi"}},
      {"inflection_pole_x", "$x_{J}$", "m", {"abscissa of the inflection pole", "ascissa del polo dei flessi"}},
      {"inflection_pole_y", "$y_{J}$", "m", {"ordinate of the inflection pole", "ordinata del polo dei flessi"}},
      {"Mprime_M",
       "$M'M$",
       "m",
       {"from M to the inflection circle, on the ray from the pole",
        "da M al cerchio dei flessi, sul raggio dal polo"}},
      {"rho_M", "$ρ_{M}$", "m", {"radius of curvature of the path", "raggio di curvatura della traiettoria"}},
      {"curvature_centre_M_x",
       "$x_{Ω}$",
       "m",
       {"abscissa of the centre of curvature", "ascissa del centro di curvatura"}},
      {"curvature_centre_M_y",
       "$y_{Ω}$",
       "m",
       {"ordinate of the centre of curvature", "ordinata del centro di curvatura"}}};
}

geometry::analytic::Roulette Problem::closed_form() const {
  using geometry::analytic::RouletteKind;
  const auto kind = [&] {
    switch (rolling.how) {
      case Rolls::circle_on_line:
        return RouletteKind::cycloid;
      case Rolls::circle_outside_circle:
        return RouletteKind::epicycloid;
      case Rolls::circle_inside_circle:
        return RouletteKind::hypocycloid;
      default:
        return RouletteKind::involute;
    }
  };
  return {kind(), rolling.r, rolling.R, rolling.d};
}

Problem problem_of(const Givens& givens) {
  const auto how = static_cast<Rolls>(static_cast<int>(givens["how"].to_double()));  // the choices are in its order
  const Problem problem{{how, givens["r"], givens["R"], givens["d"]},
                        givens.angle("phi") + givens.angle("phi_rad"),
                        givens.angle("omega"),
                        givens.angle("alpha")};
  if (!problem.is_line() && problem.rolling.d < 0)
    throw BadGivens(format_words("d = {} m: the distance of M from the centre of the circle must not be negative",
                                 "d = {} m: la distanza di M dal centro della circonferenza non dev'essere negativa",
                                 geometry::to_text(problem.rolling.d)));
  if (how == Rolls::circle_inside_circle && problem.rolling.r >= problem.rolling.R)
    throw BadGivens(
        format_words("r = {} m, R = {} m: a circle that rolls inside another must be smaller, r < R",
                     "r = {} m, R = {} m: una circonferenza che rotola dentro un'altra dev'essere più piccola, r < R",
                     geometry::to_text(problem.rolling.r), geometry::to_text(problem.rolling.R)));
  return problem;
}

Words name_of_path(const Problem& problem) {
  const geometry::Rolling& g = problem.rolling;
  if (geometry::runs_straight(g)) return {"diameter of the fixed circle", "diametro del cerchio fisso"};
  if (problem.is_line()) {
    if (g.d == 0) return {"involute", "evolvente"};
    if (g.d == g.R) return {"spiral of Archimedes", "spirale di Archimede"};
    return g.d > 0 ? Words{"curtate involute", "evolvente accorciata"}
                   : Words{"prolate involute", "evolvente allungata"};
  }
  if (g.d == 0) return problem.rolls_on_line() ? Words{"straight line", "retta"} : Words{"circle", "circonferenza"};
  if (g.how == Rolls::circle_inside_circle && g.R == Rational(2) * g.r) return {"ellipse", "ellisse"};
  const Words kind = problem.rolls_on_line()                 ? Words{"cycloid", "cicloide"}
                     : g.how == Rolls::circle_outside_circle ? Words{"epicycloid", "epicicloide"}
                                                             : Words{"hypocycloid", "ipocicloide"};
  if (g.d == g.r) return kind;
  return g.d < g.r ? Words{"curtate " + kind.english, kind.italian + " accorciata"}
                   : Words{"prolate " + kind.english, kind.italian + " allungata"};
}

}  // namespace epure::roulette
