#include "exercises/michell-thrust/quantities.h"

#include <map>

#include "exercises/kit/statement/quantity_kinds.h"

namespace epure::michell_thrust {

Quantity quantity(const std::string& name) {
  static const QuantityKinds kinds{
      {"R_m", {"$\\it{R}_{m}$", "m", {"mean radius", "raggio medio"}}},
      {"omega", {"$ω$", "rad/s", {"angular velocity", "velocità angolare"}}},
      {"v", {"$v$", "m/s", {"speed on the mean circle", "velocità sulla circonferenza media"}}},
      {"b", {"$b$", "m", {"width of a pad", "larghezza del pattino"}}},
      {"l", {"$l$", "m", {"length of a pad", "lunghezza del pattino"}}},
      {"N_p", {"$\\it{N}_{p}$", "N", {"load of a pad", "carico del pattino"}}},
      {"p_m", {"$p_{m}$", "Pa", {"mean pressure", "pressione media"}}},
      {"c", {"$c$", "1", {"factor of side leakage for the width", "coefficiente di fuoriuscita della larghezza"}}},
      {"b_eff", {"$b'$", "m", {"effective width", "larghezza efficace"}}},
      {"N", {"$\\it{N}$", "N/m", {"load for a unit of effective width", "carico per unità di larghezza efficace"}}},
      {"mu", {"$μ$", "Pa*s", {"viscosity", "viscosità"}}},
      {"n", {"$n$", "1", {"ratio of the films, h_1/h_2", "rapporto degli spessori, h_1/h_2"}}},
      {"A", {"$\\it{A}$", "1", {"coefficient of the load", "coefficiente del carico"}}},
      {"A_n_minus_1_squared", {"$\\it{A}$($n$ − 1)$^{2}$", "1", {"A (n - 1)^2", "A (n - 1)^2"}}},
      {"k", {"$k$", "1", {"coefficient of the friction", "coefficiente dell'attrito"}}},
      {"x_N", {"$x_{N}$", "m", {"pivot, from the leading edge", "cerniera, dal bordo d'ingresso"}}},
      {"x_N_over_l", {"$x_{N}$/$l$", "1", {"where the load acts", "punto di applicazione del carico"}}},
      {"h_2", {"$h_{2}$", "m", {"least film", "altezza minima del meato"}}},
      {"h_1", {"$h_{1}$", "m", {"greatest film", "altezza massima del meato"}}},
      {"alpha", {"$α$", "rad", {"tilt of the pad", "inclinazione del pattino"}}},
      {"alpha_deg", {"$α$", "deg", {"tilt of the pad", "inclinazione del pattino"}}},
      {"c_prime",
       {"$c'$", "1", {"factor of side leakage for the friction", "coefficiente di fuoriuscita dell'attrito"}}},
      {"f_m", {"$f_{m}$", "1", {"mean coefficient of friction", "coefficiente d'attrito mediato"}}},
      {"T", {"$\\it{T}$", "N/m", {"friction for a unit of width", "azione tangenziale per unità di larghezza"}}},
      {"T_p", {"$\\it{T}_{p}$", "N", {"friction of a pad", "azione tangenziale sul pattino"}}},
      {"M", {"$\\it{M}$", "N*m", {"resisting torque, all pads", "coppia resistente, tutti i pattini"}}},
      {"dissipated_power", {"$\\it{W}$", "W", {"power lost", "potenza dissipata"}}},
      {"h_p_max", {"$h^{*}$", "m", {"film where the pressure is greatest", "altezza dove la pressione è massima"}}},
      {"x_p_max", {"$x^{*}$", "m", {"where the pressure is greatest", "sezione di pressione massima"}}},
      {"p_max", {"$p_{max}$", "Pa", {"greatest pressure", "pressione massima"}}},
      {"p_1_4",
       {"$p$($l$/4)", "Pa", {"pressure at a quarter of the length", "pressione a un quarto della lunghezza"}}},
      {"p_1_2", {"$p$($l$/2)", "Pa", {"pressure in the middle", "pressione a metà"}}},
      {"p_3_4", {"$p$(3$l$/4)", "Pa", {"pressure at three quarters", "pressione a tre quarti"}}},
  };
  return quantity_of(kinds, name);
}

Quantity on_the_chord(const std::string& name) {
  static const std::map<std::string, std::string> symbols{{"n", "$n_{c}$"},
                                                          {"A", "$\\it{A}_{c}$"},
                                                          {"A_n_minus_1_squared", "$\\it{A}_{c}$($n_{c}$ − 1)$^{2}$"},
                                                          {"k", "$k_{c}$"},
                                                          {"h_2", "$h_{2c}$"},
                                                          {"h_1", "$h_{1c}$"},
                                                          {"alpha", "$α_{c}$"},
                                                          {"alpha_deg", "$α_{c}$"},
                                                          {"f_m", "$f_{mc}$"},
                                                          {"T", "$\\it{T}_{c}$"},
                                                          {"T_p", "$\\it{T}_{pc}$"},
                                                          {"M", "$\\it{M}_{c}$"},
                                                          {"dissipated_power", "$\\it{W}_{c}$"}};
  Quantity of = quantity(name);
  if (const auto found = symbols.find(name); found != symbols.end()) of.symbol = found->second;
  return of;
}

Quantity of_infinite_width(const std::string& name) {
  Quantity of = on_the_chord(name);
  if (name == "h_2") of.symbol = "$h_{2∞}$";
  if (name == "h_1") of.symbol = "$h_{1∞}$";
  return of;
}

}  // namespace epure::michell_thrust
