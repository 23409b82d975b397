// What is given, and what it makes of the path.
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
      {"R", {"radius of the fixed circle", "raggio del cerchio fisso"}, "m", "0.45", Range::positive, "$\\it{R}$"},
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

RollingGivens rolling_of(const Givens& givens) {
  const auto how =
      static_cast<geometry::Rolls>(static_cast<int>(givens["how"].to_double()));  // the choices are in its order
  const RollingGivens given{{how, givens["r"], givens["R"], givens["d"]},
                            givens.angle("phi") + givens.angle("phi_rad"),
                            givens.angle("omega"),
                            givens.angle("alpha")};
  if (!given.is_line() && given.rolling.d < 0)
    throw BadGivens(format_words("d = {} m: the distance of M from the centre of the circle must not be negative",
                                 "d = {} m: la distanza di M dal centro della circonferenza non dev'essere negativa",
                                 geometry::to_text(given.rolling.d)));
  if (how == geometry::Rolls::circle_inside_circle && given.rolling.r >= given.rolling.R)
    throw BadGivens(
        format_words("r = {} m, R = {} m: a circle that rolls inside another must be smaller, r < R",
                     "r = {} m, R = {} m: una circonferenza che rotola dentro un'altra dev'essere più piccola, r < R",
                     geometry::to_text(given.rolling.r), geometry::to_text(given.rolling.R)));
  return given;
}

Words name_of_path(const RollingGivens& given) {
  const geometry::Rolling& g = given.rolling;
  if (geometry::runs_straight(g)) return {"diameter of the fixed circle", "diametro del cerchio fisso"};
  if (given.is_line()) {
    if (g.d == 0) return {"involute", "evolvente"};
    if (g.d == g.R) return {"spiral of Archimedes", "spirale di Archimede"};
    return g.d > 0 ? Words{"curtate involute", "evolvente accorciata"}
                   : Words{"prolate involute", "evolvente allungata"};
  }
  if (g.d == 0) return given.rolls_on_line() ? Words{"straight line", "retta"} : Words{"circle", "circonferenza"};
  if (g.how == geometry::Rolls::circle_inside_circle && g.R == Rational(2) * g.r) return {"ellipse", "ellisse"};
  const Words kind = given.rolls_on_line()                             ? Words{"cycloid", "cicloide"}
                     : g.how == geometry::Rolls::circle_outside_circle ? Words{"epicycloid", "epicicloide"}
                                                                       : Words{"hypocycloid", "ipocicloide"};
  if (g.d == g.r) return kind;
  return g.d < g.r ? Words{"curtate " + kind.english, kind.italian + " accorciata"}
                   : Words{"prolate " + kind.english, kind.italian + " allungata"};
}

}  // namespace epure::roulette
