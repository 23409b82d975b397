#include "exercises/pump-flywheel/pump.h"

#include "exercises/kit/statement/given_number.h"

namespace epure::pump_flywheel {
namespace {}  // namespace

std::vector<GivenSpec> given_specs() {
  return {
      {"Q", {"flow", "portata"}, "l/min", "2000", Range::positive, "$\\it{Q}$"},
      {"p_m", {"delivery pressure", "pressione di mandata"}, "kgf/cm^2", "5", Range::positive, "$p_{m}$"},
      {"p_a",
       {"suction depression", "depressione all'aspirazione"},
       "kgf/cm^2",
       "0.5",
       Range::not_negative,
       "$p_{a}$"},
      {"D", {"diameter of the piston", "diametro dello stantuffo"}, "mm", "210", Range::positive, "$\\it{D}$"},
      {"c", {"stroke", "corsa"}, "mm", "280", Range::positive, "$c$"},
      {"W_t", {"power of the motor", "potenza di targa del motore"}, "kW", "18.5", Range::positive, "$\\it{W}_{t}$"},
      {"n_m",
       {"rated speed of the motor", "velocità di targa del motore"},
       "rpm",
       "2910",
       Range::positive,
       "$n_{m}$"},
      {"n_0", {"synchronous speed", "velocità di sincronismo"}, "rpm", "3000", Range::positive, "$n_{0}$"},
      {"J_m",
       {"moment of inertia of the motor", "momento d'inerzia del motore"},
       "kg m^2",
       "0.01725",
       Range::positive,
       "$\\it{J}_{m}$"},
      {"m", {"reciprocating mass", "massa in moto alterno"}, "kg", "50", Range::not_negative, "$m$"},
      {"i", {"irregularity", "irregolarità periodica"}, "1", "0.05", Range::positive, "$i$"},
      {"kgf", {"kilogram-force", "chilogrammo forza"}, "N", "9.80665", Range::positive, "kgf"}};
}

Pump::Pump(const Givens& givens)
    : Q(givens["Q"] / 60000),
      p_m(givens["p_m"] * givens["kgf"] * 10000),
      p_a(givens["p_a"] * givens["kgf"] * 10000),
      D(givens["D"] / 1000),
      c(givens["c"] / 1000),
      W_t(givens["W_t"] * 1000),
      J_m(givens["J_m"]),
      m(givens["m"]),
      i(givens["i"]),
      rated(givens.angle("n_m")),
      synchronous(givens.angle("n_0")) {
  if (sign_of(synchronous - rated) <= 0)
    throw BadGivens(format_words(
        "n_m = {} rpm must be less than n_0 = {} rpm: an induction motor runs below its synchronous speed",
        "n_m = {} giri/min dev'essere minore di n_0 = {} giri/min: un motore asincrono gira sotto la velocità di "
        "sincronismo",
        givens.text("n_m"), givens.text("n_0")));
  if (i >= Rational(2))
    throw BadGivens(format_words("i = {} must be less than 2: at 2 the crank would stand still once a turn",
                                 "i = {} dev'essere minore di 2: con 2 la manovella si fermerebbe una volta al giro",
                                 told_value(i)));
  if (p_a > p_m)
    throw BadGivens(
        format_words("p_a = {} must not be greater than p_m = {}: the torque would be greatest in suction, and the "
                     "flywheel is found from delivery",
                     "p_a = {} non può superare p_m = {}: il momento sarebbe massimo in aspirazione, e il volano si "
                     "trova dalla mandata",
                     givens.text("p_a"), givens.text("p_m")));
}

}  // namespace epure::pump_flywheel
