#include "exercises/oscillator-pendulum/quantities.h"

#include <algorithm>

#include "exercises/kit/statement/quantity_kinds.h"
#include "geometry/numbers/given.h"

namespace epure::oscillator_pendulum {
namespace {

std::string as_number(std::string name) {
  std::replace(name.begin(), name.end(), 'p', '.');
  return name;
}
// Letters have no decimal sign, which languages write differently: "500 ms", "5 s".
std::string letters_of(const std::string& name) {
  if (name.find('p') == std::string::npos) return name + " s";
  return geometry::to_text(instant(name) * 1000) + " ms";
}

}  // namespace

Rational instant(const std::string& name) { return geometry::parse_given(as_number(name), "1"); }

Quantity oscillator_quantity(const std::string& name) {
  static const QuantityKinds kinds{
      {"alpha", {"$α$", "1/s", {"ζ ω_n, the decay", "ζ ω_n, lo smorzamento"}}},
      {"beta", {"$β$", "1/s", {"ω_n √(ζ² - 1)", "ω_n √(ζ² - 1)"}}},
      {"two_beta",
       {"2$β$", "1/s", {"twice beta, the difference of the roots", "il doppio di beta, differenza delle radici"}}},
      {"C_1", {"$\\it{C}_{1}$", "m", {"constant of the slow exponential", "costante dell'esponenziale lento"}}},
      {"C_2", {"$\\it{C}_{2}$", "m", {"constant of the fast exponential", "costante dell'esponenziale rapido"}}},
      {"c", {"$c$", "N*s/m", {"damping constant", "costante di smorzamento"}}},
      {"k", {"$k$", "N/m", {"stiffness", "rigidezza"}}},
      {"c_critical", {"$c_{c}$", "N*s/m", {"critical damping constant", "smorzamento critico"}}},
      {"lambda_1",
       {"$λ_{1}$",
        "1/s",
        {"greater root, slope of a straight trajectory", "radice maggiore, pendenza di una traiettoria rettilinea"}}},
      {"lambda_2",
       {"$λ_{2}$",
        "1/s",
        {"smaller root, slope of the other straight trajectory",
         "radice minore, pendenza dell'altra traiettoria rettilinea"}}},
      {"t_x_max", {"$t_{m}$", "s", {"when x is extreme for the first time", "primo istante in cui x è estrema"}}},
      {"x_max", {"$x_{m}$", "m", {"the extreme of x", "elongazione estrema"}}},
      {"t_inflection", {"$t_{f}$", "s", {"when x'' is zero for the first time", "primo istante in cui x'' è nulla"}}},
      {"x_inflection", {"$x_{f}$", "m", {"x where x'' is zero", "x nel flesso"}}},
      {"x_dot_min",
       {"$x'_{f}$",
        "m/s",
        {"velocity where x'' is zero, the extreme on the way back", "velocità nel flesso, estrema nel ritorno"}}},
      {"E_0", {"$\\it{E}_{0}$", "J", {"energy at the start", "energia iniziale"}}},
      {"E_at_x_max", {"$\\it{E}_{m}$", "J", {"energy where x is extreme", "energia all'elongazione estrema"}}},
  };
  return quantity_of(kinds, name);
}

Quantity pendulum_quantity(const std::string& name) {
  static const QuantityKinds kinds{
      {"I_A0", {"$\\it{I}_{A0}$", "kg*m^2", {"moment of inertia about A0", "momento d'inerzia rispetto ad A0"}}},
      {"Omega_squared", {"$Ω^{2}$", "1/s^2", {"m g r/I_A0", "m g r/I_A0"}}},
      {"Omega", {"$Ω$", "rad/s", {"circular frequency of small swings", "pulsazione delle piccole oscillazioni"}}},
      {"equivalent_length", {"$l$", "m", {"length of the equivalent simple pendulum", "lunghezza ridotta"}}},
      {"weight", {"$m_{p}g$", "N", {"weight", "peso"}}},
      {"k", {"$k_{e}$", "1", {"modulus, sin θ_0/2", "modulo, sen θ_0/2"}}},
      {"K",
       {"$\\it{K}$",
        "1",
        {"complete elliptic integral of the first kind", "integrale ellittico completo di prima specie"}}},
      {"period", {"$\\it{T}$", "s", {"period", "periodo"}}},
      {"period_small", {"$\\it{T}_{0}$", "s", {"period of small swings", "periodo delle piccole oscillazioni"}}},
      {"period_ratio",
       {"$\\it{T}$/$\\it{T}_{0}$",
        "1",
        {"period over that of small swings", "periodo su quello delle piccole oscillazioni"}}},
      {"period_numeric",
       {"$\\it{T}_{n}$",
        "s",
        {"when the table has come back to the side where it began",
         "quando la tabella è tornata dalla parte da cui è partita"}}},
      {"t_first_bottom",
       {"$t_{b}$", "s", {"first passage through the lowest place", "primo passaggio per il punto più basso"}}},
      {"theta_dot_max", {"$θ'_{m}$", "rad/s", {"greatest angular velocity", "massima velocità angolare"}}},
      {"R_12_x_max",
       {"|$\\it{R}_{12x}$|$_{max}$", "N", {"greatest horizontal reaction", "massima reazione orizzontale"}}},
      {"t_R_12_x_max",
       {"$t_{x}$",
        "s",
        {"when the horizontal reaction is greatest for the first time",
         "primo istante di reazione orizzontale massima"}}},
      {"R_12_y_max", {"$\\it{R}_{12y,max}$", "N", {"greatest vertical reaction", "massima reazione verticale"}}},
      {"R_12_y_min", {"$\\it{R}_{12y,min}$", "N", {"least vertical reaction", "minima reazione verticale"}}},
      {"R_12_y_at_bottom",
       {"$\\it{R}_{12y}$($θ$ = 0)",
        "N",
        {"vertical reaction at the lowest place", "reazione verticale nel punto più basso"}}},
      {"energy_ratio_numeric_at_1",
       {"$\\it{E}_{n}$/$\\it{E}_{0}$(1 s)",
        "1",
        {"energy of the table at t = 1 s, over that at the start",
         "energia della tabella per t = 1 s, su quella iniziale"}}},
  };
  return quantity_of(kinds, name);
}

Quantity at_instant(const std::string& of, const std::string& name) {
  static const QuantityKinds kinds{
      {"x", {"$x$", "m", {"position", "posizione"}}},
      {"x_dot", {"$x'$", "m/s", {"velocity", "velocità"}}},
      {"x_ddot", {"$x''$", "m/s^2", {"acceleration", "accelerazione"}}},
      {"x_euler", {"$x_{E}$", "m", {"position by Euler's method", "posizione con il metodo di Eulero"}}},
      {"x_dot_euler", {"$x'_{E}$", "m/s", {"velocity by Euler's method", "velocità con il metodo di Eulero"}}},
      {"x_ddot_euler",
       {"$x''_{E}$", "m/s^2", {"acceleration by Euler's method", "accelerazione con il metodo di Eulero"}}},
      {"err_euler", {"$e$", "1", {"relative error of Euler's method", "errore relativo del metodo di Eulero"}}},
      {"theta", {"$θ$", "rad", {"angle", "angolo"}}},
      {"theta_dot", {"$θ'$", "rad/s", {"angular velocity", "velocità angolare"}}},
      {"theta_ddot", {"$θ''$", "rad/s^2", {"angular acceleration", "accelerazione angolare"}}},
      {"R_12_x", {"$\\it{R}_{12x}$", "N", {"horizontal reaction", "reazione orizzontale"}}},
      {"R_12_y", {"$\\it{R}_{12y}$", "N", {"vertical reaction", "reazione verticale"}}},
      {"theta_small", {"$θ_{0}$cos$Ωt$", "rad", {"angle of small swings", "angolo delle piccole oscillazioni"}}},
      {"theta_numeric", {"$θ_{n}$", "rad", {"angle of the table", "angolo della tabella"}}},
      {"theta_dot_numeric",
       {"$θ'_{n}$", "rad/s", {"angular velocity of the table", "velocità angolare della tabella"}}},
      {"theta_ddot_numeric",
       {"$θ''_{n}$", "rad/s^2", {"angular acceleration of the table", "accelerazione angolare della tabella"}}},
      {"R_12_x_numeric",
       {"$\\it{R}_{12x,n}$", "N", {"horizontal reaction of the table", "reazione orizzontale della tabella"}}},
      {"R_12_y_numeric",
       {"$\\it{R}_{12y,n}$", "N", {"vertical reaction of the table", "reazione verticale della tabella"}}},
  };
  const QuantityKind& kind = kinds.at(of);
  return {of + "_at_" + name, kind.symbol + "(" + letters_of(name) + ")", kind.unit,
          kind.meaning + Words{" at t = ", " per t = "} + decimal(as_number(name)) + " s"};
}

const std::vector<std::string>& instants(const std::string& of) {
  using Names = std::vector<std::string>;
  static const Names to_20{"1",  "2",  "3",  "4",  "5",  "6",  "7",  "8",  "9",  "10",
                           "11", "12", "13", "14", "15", "16", "17", "18", "19", "20"};
  static const Names few{"1", "2", "5", "10", "20"},
      tenths{"0p1", "0p2", "0p3", "0p4", "0p5", "0p6", "0p7", "0p8", "0p9", "1"};
  const auto with = [](const Names& before, Names all, const Names& after = {}) {
    all.insert(all.begin(), before.begin(), before.end());
    all.insert(all.end(), after.begin(), after.end());
    return all;
  };
  static const std::map<std::string, Names> all{
      {"x", with({"0p5"}, to_20, {"25", "30", "35", "40"})},
      {"x_dot", few},
      {"x_ddot", with({"0"}, few)},
      {"x_euler", with({"0p5"}, to_20)},
      {"x_dot_euler", with({"0p5"}, few)},
      {"x_ddot_euler", with({"0", "0p5"}, few)},
      {"err_euler", with({"0p5"}, few)},
      {"theta", with({"0", "0p01"}, tenths)},
      {"theta_dot", with({"0"}, tenths)},
      {"theta_ddot", with({"0"}, tenths)},
      {"R_12_x", with({"0"}, tenths)},
      {"R_12_y", with({"0"}, tenths)},
      {"theta_small", {"0p5", "1"}},
      {"theta_numeric", tenths},
      {"theta_dot_numeric", {"0p5", "1"}},
      {"theta_ddot_numeric", {"0p5", "1"}},
      {"R_12_x_numeric", {"0p5", "1"}},
      {"R_12_y_numeric", {"0p5", "1"}},
  };
  return all.at(of);
}

}  // namespace epure::oscillator_pendulum
