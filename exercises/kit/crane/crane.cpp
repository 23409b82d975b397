#include "exercises/kit/crane/crane.h"

#include "exercises/kit/statement/given_number.h"

namespace epure {
namespace {

Rational in_metres(const Givens& givens, const std::string& symbol) { return givens[symbol] / 1000; }

Words millimetres(const Rational& metres) { return told_value(1000 * metres); }

geometry::analytic::DoubleT section_of(const Givens& givens, const std::string& body) {
  const geometry::analytic::DoubleT of{in_metres(givens, "H_" + body), in_metres(givens, "b_" + body),
                                       in_metres(givens, "s_" + body)};
  if (of.h() <= 0)
    throw BadGivens(
        format_words("H_{0} = {1} mm leaves no web: it must be greater than both flanges together, 2 s_{0} = {2} mm",
                     "H_{0} = {1} mm non lascia anima: deve superare le due piattabande insieme, 2 s_{0} = {2} mm",
                     body, millimetres(of.H), millimetres(2 * of.s)));
  if (of.b < of.s)
    throw BadGivens(
        format_words("b_{0} = {1} mm is less than the web's thickness s_{0} = {2} mm: a flange must be at least as "
                     "wide as the web",
                     "b_{0} = {1} mm è minore dello spessore dell'anima s_{0} = {2} mm: una piattabanda dev'essere "
                     "larga almeno quanto l'anima",
                     body, millimetres(of.b), millimetres(of.s)));
  return of;
}

// The greatest of 1, 2, 5 times a power of ten that is not greater than x > 0.
Rational rounded_down(const Rational& x) {
  Rational decade = 1;
  while (decade > x) decade /= 10;
  while (10 * decade <= x) decade *= 10;
  return 5 * decade <= x ? 5 * decade : 2 * decade <= x ? 2 * decade : decade;
}

GivenSpec length(const std::string& symbol, const Words& meaning, const std::string& unit, const std::string& stated,
                 const std::string& letters) {
  return {symbol, meaning, unit, stated, Range::positive, letters};
}

}  // namespace

std::vector<GivenSpec> Crane::givens() {
  return {
      length("L", {"distance BC; BD is 3L", "distanza BC; BD è 3L"}, "m", "3", "$\\it{L}$"),
      length("H_0", {"height of the column", "altezza della colonna"}, "m", "5", "$\\it{H}_{0}$"),
      {"W_b", {"mass of the boat", "massa del natante"}, "kg", "300", Range::positive, "$\\it{W}_{b}$"},
      length("s_1", {"walls of the beam's section", "pareti della sezione della trave"}, "mm", "5", "$s_{1}$"),
      length("H_1", {"depth of the beam", "altezza della trave"}, "mm", "300", "$\\it{H}_{1}$"),
      length("b_1", {"width of the beam's flanges", "larghezza delle piattabande della trave"}, "mm", "200",
             "$b_{1}$"),
      length("s_2", {"walls of the column's section", "pareti della sezione della colonna"}, "mm", "2", "$s_{2}$"),
      length("H_2", {"depth of the column's section", "altezza della sezione della colonna"}, "mm", "180",
             "$\\it{H}_{2}$"),
      length("b_2", {"width of the column's flanges", "larghezza delle piattabande della colonna"}, "mm", "100",
             "$b_{2}$"),
      {"sigma_S", {"yield stress", "tensione di snervamento"}, "MPa", "300", Range::positive, "$σ_{S}$"},
      {"Delta_sigma_L",
       {"fatigue limit (range)", "limite di fatica (ampiezza)"},
       "MPa",
       "200",
       Range::positive,
       "$Δσ_{L}$"},
      {"Psi",
       {"safety demanded of all checks", "sicurezza richiesta in tutte le verifiche"},
       "1",
       "1.5",
       Range::positive,
       "$Ψ$"},
      {"E", {"Young's modulus", "modulo di Young"}, "MPa", "210000", Range::positive, "$\\it{E}$"},
      {"g", {"acceleration of gravity", "accelerazione di gravità"}, "m/s^2", "9.80665", Range::positive, "$g$"},
  };
}

Crane::Crane(const Givens& givens)
    : L(givens["L"]),
      H_0(givens["H_0"]),
      beam(section_of(givens, "1")),
      column(section_of(givens, "2")),
      E(1000000 * givens["E"]),
      g(givens["g"]),
      mass(givens["W_b"]) {}

const Rational& Crane::mass_of_the_source() {
  static const Rational kilograms = 600;
  return kilograms;
}

Rational Crane::pole_distance(const Rational& boat) const { return rounded_down(2 * boat * g); }

Rational Crane::enlargement(const Rational& boat) const {
  return rounded_down(Rational(3, 10) * E * beam.J_x() / (boat * g * L * L));
}

}  // namespace epure
