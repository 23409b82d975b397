#include "exercises/michell-bearing/problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/given_number.h"
#include "geometry/numbers/climb.h"

namespace epure::michell_bearing {
namespace {

constexpr long most_strips = 400;

GivenSpec given(const std::string& symbol, const Words& meaning, const std::string& unit, const std::string& stated,
                const std::string& letters) {
  return {.symbol = symbol, .meaning = meaning, .unit = unit, .stated = stated, .letters = letters};
}

// However near to a whole number.
Words told_strips(const Rational& strips) {
  const double near = nearest(strips);
  const bool looks_whole = strips.denominator() != 1 && near == std::floor(near);
  return (looks_whole ? Words{"nearly ", "quasi "} : Words{}) + all_digits(near);
}

void demand_film(const Film& film) {
  if (film.h_1 <= film.h_2)
    throw BadGivens(
        format_words("h_1 = {} m must be greater than h_2 = {} m: n = h_1/h_2 = {}, and a film that does not narrow "
                     "carries no load",
                     "h_1 = {} m dev'essere maggiore di h_2 = {} m: n = h_1/h_2 = {}, e un meato che non si "
                     "restringe non porta carico",
                     told_value(film.h_1), told_value(film.h_2), told_value(film.n())));
  if (const Rational strips = film.l / film.dx;
      strips.denominator() != 1 || strips < Rational(2) || strips > Rational(most_strips))
    throw BadGivens(
        format_words("dx = {} m must divide l = {} m into a whole number of strips, 2 to {}: it makes {}",
                     "dx = {} m deve dividere l = {} m in un numero intero di strisce, da 2 a {}: ne fa {}",
                     told_value(film.dx), told_value(film.l), std::to_string(most_strips), told_strips(strips)));
  for (const auto& [name, x] : {std::pair("x_1", film.x_1), std::pair("x_3", film.x_3)})
    if (x > film.l)
      throw BadGivens(format_words("{} = {} m must not be greater than l = {} m: the film ends there",
                                   "{} = {} m non può essere maggiore di l = {} m: lì il meato finisce",
                                   std::string(name), told_value(x), told_value(film.l)));
}

void demand_pad(const Pad& pad) {
  if (pad.pads.denominator() != 1 || pad.pads < Rational(1))
    throw BadGivens(format_words("pads = {}: must be a whole number", "pads = {}: deve essere un numero intero",
                                 told_value(pad.pads)));
  const Rational c = pad.centre();
  if (c <= Rational(1, 2) || c > Rational(95, 100))
    throw BadGivens(
        format_words("x_N = {} m is {} of l_pad = {} m, and must be more than 0.5 and at most 0.95 of it: the load "
                     "of a flat pad acts in its middle where its walls are parallel, and nearer to the outlet the "
                     "more they narrow (at 0.95, h_1/h_2 is beyond 10^5)",
                     "x_N = {} m è {} di l_pad = {} m, e deve essere più di 0,5 e al più 0,95 di esso: il carico di "
                     "un pattino piano agisce nel mezzo quando le pareti sono parallele, e tanto più verso l'uscita "
                     "quanto più si stringono (a 0,95, h_1/h_2 supera 10^5)",
                     told_value(pad.x_N), told_value(c), told_value(pad.l)));
  if (pad.b >= Rational(2) * pad.r_m)
    throw BadGivens(format_words("b = {} m must be less than 2 r_m = {} m: the pads have an inner radius",
                                 "b = {} m deve essere minore di 2 r_m = {} m: i pattini hanno un raggio interno",
                                 told_value(pad.b), told_value(Rational(2) * pad.r_m)));
  const auto gaps = [&]<class T>() {
    const Rational circles = Rational(2) * pad.r_m, covered = pad.pads * pad.l;
    return T(geometry::from_rational<T>(circles) * geometry::pi<T>() - geometry::from_rational<T>(covered));
  };
  if (geometry::decide(gaps).sign == geometry::Sign::positive) return;
  const Rational covered = pad.pads * pad.l;
  const double circle = 2 * std::numbers::pi * nearest(pad.r_m);
  const int figures = figures_that_tell_apart(nearest(covered), circle).value_or(12);
  throw BadGivens(
      format_words("{} pads of l_pad = {} m overlap on the mean circle of r_m = {} m: together they are {} m long, "
                   "and the circle only {} m",
                   "{} pattini con l_pad = {} m si sovrappongono sulla circonferenza media con r_m = {} m: insieme "
                   "sono lunghi {} m, e la circonferenza solo {} m",
                   told_value(pad.pads), told_value(pad.l), told_value(pad.r_m),
                   told_value(covered, std::max(12, figures)), decimal(circle, figures)));
}

}  // namespace

std::vector<GivenSpec> given_specs() {
  return {
      given("l", {"length of the slider (inverse problem)", "lunghezza della slitta (problema inverso)"}, "m", "0.40",
            "$l$"),
      given("V", {"speed of the moving wall", "velocità di trascinamento"}, "m/s", "2.4", "$\\it{V}$"),
      given("h_1", {"film at the inlet", "spessore del meato all'imbocco"}, "mm", "0.40", "$h_{1}$"),
      given("h_2", {"film at the outlet", "spessore del meato all'uscita"}, "mm", "0.16", "$h_{2}$"),
      given("mu", {"viscosity (inverse problem)", "viscosità (problema inverso)"}, "Pa s", "0.040", "$μ$"),
      given("dx", {"step of the grid", "passo della griglia"}, "m", "0.01", "Δ$x$"),
      given("x_1", {"first section", "prima sezione"}, "m", "0.15", "$x_{1}$"),
      given("x_3", {"third section", "terza sezione"}, "m", "0.35", "$x_{3}$"),
      given("P", {"thrust (direct problem)", "spinta (problema diretto)"}, "N", "80000", "$\\it{P}$"),
      given("speed", {"speed of the shaft", "velocità dell'albero"}, "rpm", "800", "$n_{a}$"),
      given("pads", {"number of pads", "numero dei pattini"}, "1", "8", "$z$"),
      given("r_m", {"mean radius", "raggio medio"}, "m", "0.100", "$r_{m}$"),
      given("l_pad", {"length of a pad on the mean circle", "lunghezza del pattino sulla circonferenza media"}, "m",
            "0.0735", "$l_{p}$"),
      given("b", {"width of a pad", "larghezza del pattino"}, "m", "0.060", "$b$"),
      given("x_N", {"pivot, from the inlet", "cerniera, dall'imbocco"}, "m", "0.045", "$x_{N}$"),
      given("mu_pad", {"viscosity (direct problem)", "viscosità (problema diretto)"}, "Pa s", "0.035", "$μ_{p}$"),
      given("h_ref", {"least film allowed", "spessore minimo di riferimento"}, "um", "30", "$h_{0}$"),
  };
}

Problem::Problem(const Givens& givens)
    : film{.l = givens["l"],
           .V = givens["V"],
           .h_1 = givens["h_1"] / 1000,
           .h_2 = givens["h_2"] / 1000,
           .mu = givens["mu"],
           .dx = givens["dx"],
           .x_1 = givens["x_1"],
           .x_3 = givens["x_3"],
           .strips = 0},
      pad{.P = givens["P"],
          .pads = givens["pads"],
          .r_m = givens["r_m"],
          .l = givens["l_pad"],
          .b = givens["b"],
          .x_N = givens["x_N"],
          .mu = givens["mu_pad"],
          .h_ref = givens["h_ref"] / 1000000,
          .speed = givens.angle("speed")} {
  demand_film(film);
  demand_pad(pad);
  film.strips = static_cast<long>(CGAL::to_double(film.l / film.dx));
}

}  // namespace epure::michell_bearing
