#include "exercises/kit/linkages/coupler_quantities.h"

namespace epure {

Quantity metres(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "m", meaning};
}
Quantity speed(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "m/s", meaning};
}
Quantity acceleration(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "m/s^2", meaning};
}

std::vector<Quantity> coordinates(const std::string& name, const std::string& symbol, const Words& of) {
  return {metres(name + "_x", "$x_{" + symbol + "}$", {"abscissa of " + of.english, "ascissa di " + of.italian}),
          metres(name + "_y", "$y_{" + symbol + "}$", {"ordinate of " + of.english, "ordinata di " + of.italian})};
}

std::vector<Quantity> components(const std::string& name, const std::string& letter, const std::string& subscript,
                                 const std::string& unit, const Words& of) {
  const auto symbol = [&](const char* axis) { return "$" + letter + "_{" + subscript + axis + "}$"; };
  return {{name + "_x", symbol("x"), unit, {of.english + ", along x", of.italian + ", lungo x"}},
          {name + "_y", symbol("y"), unit, {of.english + ", along y", of.italian + ", lungo y"}},
          {name, symbol(""), unit, of}};
}

std::vector<Quantity> pole_quantities(const std::string& pole, const std::string& symbol,
                                      const std::vector<std::string>& points) {
  std::vector<Quantity> all = coordinates(pole, pole, {"the pole", "il polo"});
  all[0].meaning.italian = "ascissa del polo";
  all[1].meaning.italian = "ordinata del polo";
  for (const std::string& X : points)
    all.push_back(metres(pole + X, "$" + symbol + X + "$",
                         {"distance of " + X + " from the pole", "distanza di " + X + " dal polo"}));
  return all;
}

std::vector<Quantity> acceleration_pole_quantities(const std::vector<std::string>& points) {
  std::vector<Quantity> all{
      metres("K_x", "$x_{K}$", {"abscissa of the acceleration pole", "ascissa del polo delle accelerazioni"}),
      metres("K_y", "$y_{K}$", {"ordinate of the acceleration pole", "ordinata del polo delle accelerazioni"})};
  for (const std::string& X : points)
    all.push_back(metres("K" + X, "$K" + X + "$", {"distance of " + X + " from K", "distanza di " + X + " da K"}));
  return all;
}

std::vector<Quantity> circle_quantities() {
  return {
      metres("inflection_diameter", "$δ_{F}$",
             {"diameter of the inflection circle", "diametro della circonferenza dei flessi"}),
      metres("inflection_centre_x", "$x_{F}$",
             {"abscissa of the inflection circle's centre", "ascissa del centro della circonferenza dei flessi"}),
      metres("inflection_centre_y", "$y_{F}$",
             {"ordinate of the inflection circle's centre", "ordinata del centro della circonferenza dei flessi"}),
      metres("inflection_pole_x", "$x_{J}$", {"abscissa of the inflection pole J", "ascissa del polo dei flessi J"}),
      metres("inflection_pole_y", "$y_{J}$", {"ordinate of the inflection pole J", "ordinata del polo dei flessi J"}),
      metres("stationarity_diameter", "$δ_{S}$",
             {"diameter of the stationarity circle", "diametro della circonferenza di stazionarietà"}),
      metres("stationarity_centre_x", "$x_{S}$",
             {"abscissa of the stationarity circle's centre",
              "ascissa del centro della circonferenza di stazionarietà"}),
      metres("stationarity_centre_y", "$y_{S}$",
             {"ordinate of the stationarity circle's centre",
              "ordinata del centro della circonferenza di stazionarietà"})};
}

std::vector<Quantity> curvature_quantities(const std::string& X, const std::string& symbol) {
  return {metres(X + "prime_" + X, "$" + symbol + "'" + symbol + "$",
                 {"distance from " + X + "' to " + X, "distanza da " + X + "' a " + X}),
          metres("rho_" + X, "$ρ_{" + X + "}$",
                 {"radius of curvature of the path of " + X, "raggio di curvatura della traiettoria di " + X}),
          metres("curvature_centre_" + X + "_x", "$x_{Ω" + X + "}$",
                 {"abscissa of the centre of curvature", "ascissa del centro di curvatura"}),
          metres("curvature_centre_" + X + "_y", "$y_{Ω" + X + "}$",
                 {"ordinate of the centre of curvature", "ordinata del centro di curvatura"}),
          metres(X + "prime_x", "$x_{" + X + "'}$",
                 {"abscissa of " + X + "', on the inflection circle",
                  "ascissa di " + X + "', sulla circonferenza dei flessi"}),
          metres(X + "prime_y", "$y_{" + X + "'}$",
                 {"ordinate of " + X + "', on the inflection circle",
                  "ordinata di " + X + "', sulla circonferenza dei flessi"})};
}

std::vector<Quantity> in_case(const std::string& prefix, const Words& which, std::vector<Quantity> quantities) {
  for (Quantity& spec : quantities) {
    spec.name = prefix + spec.name;
    spec.meaning = {spec.meaning.english + ", " + which.english, spec.meaning.italian + ", " + which.italian};
  }
  return quantities;
}

std::vector<Quantity> joined(const std::vector<std::vector<Quantity>>& groups) {
  std::vector<Quantity> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace epure
