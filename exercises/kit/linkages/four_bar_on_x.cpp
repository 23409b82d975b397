#include "exercises/kit/linkages/four_bar_on_x.h"

#include <cmath>

namespace epure {

std::vector<GivenSpec> four_bar_on_x_givens() {
  return {{"A0B0", {"frame A₀B₀, along +x", "telaio A₀B₀, lungo +x"}, "m", "0.80", Range::positive, "$A_{0}B_{0}$"},
          {"A0A", {"crank A₀A", "manovella A₀A"}, "m", "0.20", Range::positive, "$A_{0}A$"},
          {"AB", {"coupler AB", "biella AB"}, "m", "0.50", Range::positive, "$AB$"},
          {"B0B", {"rocker B₀B", "bilanciere B₀B"}, "m", "0.70", Range::positive, "$B_{0}B$"},
          {"n",
           {"crank speed, counter-clockwise", "velocità della manovella, antioraria"},
           "rpm",
           "400",
           Range::any,
           "$n_{2}$"},
          {.symbol = "phi",
           .meaning = {"angle of the crank from A₀ → B₀", "anomalia della manovella, da A₀ → B₀"},
           .unit = "deg",
           .stated = "20",
           .range = Range::any,
           .letters = "$θ_{2}$",
           .also = {"theta_2"}},
          {"alpha_2",
           {"angular acceleration of the crank", "accelerazione angolare della manovella"},
           "rad/s^2",
           "0",
           Range::any,
           "$α_{2}$"}};
}

FourBarInstant four_bar_on_x(const Givens& givens, geometry::Side side) {
  return {.lengths = {givens["A0A"], givens["AB"], givens["B0B"], givens["A0B0"], Rational(0)},
          .side = side,
          .n = givens.angle("n"),
          .crank = givens.angle("phi"),
          .alpha_2 = givens.angle("alpha_2")};
}

Quantity coupler_angle() { return {"theta_3", "$θ_{3}$", "rad", {"direction of AB from +x", "anomalia di AB"}}; }
Quantity rocker_angle() {
  return {"theta_4", "$θ_{4}$", "rad", {"direction from B to B₀, from +x", "anomalia di BB₀, da B verso B₀"}};
}
Quantity in(Configuration of, const Quantity& quantity) {
  if (of == Configuration::chosen) return quantity;
  Quantity other = quantity.meaning_that(quantity.meaning + Words{", other configuration", ", altra configurazione"});
  other.name += "_other_branch";
  other.symbol.insert(other.symbol.size() - 1, "'");
  return other;
}

Explanation cut_off(std::function<double()> value, int decimals) {
  return {{"cut off after the last printed digit, not rounded", "troncato dopo l'ultima cifra, non arrotondato"},
          [value = std::move(value), decimals] {
            const double unit = std::pow(10, decimals);
            return std::trunc(value() * unit) / unit;
          }};
}

}  // namespace epure
