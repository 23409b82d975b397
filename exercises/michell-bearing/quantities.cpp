#include "exercises/michell-bearing/quantities.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "exercises/kit/statement/quantity_kinds.h"

namespace epure::michell_bearing {
namespace {

// "0p15" as "0.15".
Words place(std::string station) {
  std::replace(station.begin(), station.end(), 'p', '.');
  return decimal(station);
}
bool is_named(const std::string& station) { return station.starts_with("x_"); }
// Within letters a number has no decimal sign, which languages write differently: "0p15" as "150".
std::string in_thousandths(const std::string& station) {
  return std::to_string(std::lround(1000 * std::stod(place(station).english)));
}
std::string letters_of(const std::string& station) {
  return is_named(station) ? "$x_{" + station.substr(2) + "}$" : in_thousandths(station) + " mm";
}
Words where(const std::string& station) {
  if (is_named(station)) return {" at " + station, " in " + station};
  return Words{" at x = ", " in x = "} + place(station) + " m";
}

}  // namespace

const std::vector<Station>& stations() {
  static const std::vector<Station> all{{"0p00", 0},
                                        {"0p05", Rational(5, 100)},
                                        {"0p10", Rational(10, 100)},
                                        {"0p15", Rational(15, 100)},
                                        {"0p20", Rational(20, 100)},
                                        {"0p25", Rational(25, 100)},
                                        {"0p29", Rational(29, 100)},
                                        {"0p30", Rational(30, 100)},
                                        {"0p35", Rational(35, 100)},
                                        {"0p40", Rational(40, 100)}};
  return all;
}

const std::vector<Depth>& depths() {
  static const std::vector<Depth> all{{"0p05mm", Rational(5, 100000)},  {"0p10mm", Rational(10, 100000)},
                                      {"0p15mm", Rational(15, 100000)}, {"0p20mm", Rational(20, 100000)},
                                      {"0p25mm", Rational(25, 100000)}, {"0p30mm", Rational(30, 100000)}};
  return all;
}

Quantity film_quantity(const std::string& name) {
  static const QuantityKinds kinds{
      {"n", {"$n$", "1", {"ratio of the films, h_1/h_2", "rapporto degli spessori, h_1/h_2"}}},
      {"h_bar", {"$h^{*}$", "m", {"film where the pressure is greatest", "spessore dove la pressione è massima"}}},
      {"x_bar", {"$x^{*}$", "m", {"where the pressure is greatest", "sezione di pressione massima"}}},
      {"p_max", {"$p_{max}$", "Pa", {"greatest pressure", "pressione massima"}}},
      {"A", {"$\\it{A}$", "1", {"coefficient of the load", "coefficiente del carico"}}},
      {"N", {"$\\it{N}$", "N/m", {"load, for a unit of width", "portanza per unità di larghezza"}}},
      {"x_N", {"$x_{N}$", "m", {"where the load acts", "punto di applicazione del carico"}}},
      {"T", {"$\\it{T}$", "N/m", {"friction on the moving wall", "forza tangenziale sulla parete mobile"}}},
      {"T_fixed", {"$\\it{T}_{0}$", "N/m", {"friction on the fixed wall", "forza tangenziale sulla parete fissa"}}},
      {"f_m", {"$f_{m}$", "1", {"mean coefficient of friction", "coefficiente d'attrito mediato"}}},
      {"p_mean", {"$p_{m}$", "Pa", {"mean pressure", "pressione media"}}},
      {"p_max_over_p_mean",
       {"$p_{max}$/$p_{m}$", "1", {"greatest over mean pressure", "pressione massima su pressione media"}}},
      {"flow_rate", {"$q$", "m^2/s", {"flow, for a unit of width", "portata per unità di larghezza"}}},
      {"power_loss",
       {"$\\it{W}$", "W/m", {"power lost, for a unit of width", "potenza persa per unità di larghezza"}}},
      {"x_shear_zero_fixed",
       {"$x_{0}$",
        "m",
        {"where the shear on the fixed wall is zero", "dove si annulla lo sforzo sulla parete fissa"}}},
      {"x_shear_zero_moving",
       {"$x_{h}$",
        "m",
        {"where the shear on the moving wall is zero", "dove si annulla lo sforzo sulla parete mobile"}}},
      {"p_max_bezout",
       {"$p^{B}_{max}$", "Pa", {"greatest pressure of Bezout's table", "massima pressione della tabella di Bezout"}}},
      {"N_bezout", {"$\\it{N}_{B}$", "N/m", {"load by Bezout's formula", "carico con la formula di Bezout"}}},
      {"x_N_bezout",
       {"$x_{NB}$", "m", {"where the load acts, by Bezout's formula", "applicazione con la formula di Bezout"}}},
      {"N_funicular", {"$\\it{N}_{f}$", "N/m", {"load of eight strips", "carico di otto strisce"}}},
      {"x_N_funicular",
       {"$x_{Nf}$",
        "m",
        {"where the load acts, by the funicular polygon", "applicazione con il poligono funicolare"}}},
  };
  return quantity_of(kinds, name);
}

Quantity pad_quantity(const std::string& name) {
  static const QuantityKinds kinds{
      {"omega", {"$ω$", "rad/s", {"angular velocity", "velocità angolare"}}},
      {"V", {"$\\it{V}$", "m/s", {"speed on the mean circle", "velocità sulla circonferenza media"}}},
      {"N",
       {"$\\it{N}$", "N/m", {"load of a pad, for a unit of width", "carico del pattino per unità di larghezza"}}},
      {"l", {"$l_{p}$", "m", {"length of a pad", "lunghezza del pattino"}}},
      {"x_N_over_l", {"$x_{N}$/$l$", "1", {"place of the pivot", "posizione della cerniera"}}},
      {"n", {"$n$", "1", {"ratio of the films, h_1/h_2", "rapporto degli spessori, h_1/h_2"}}},
      {"A", {"$\\it{A}$", "1", {"coefficient of the load", "coefficiente del carico"}}},
      {"k", {"$k$", "1", {"coefficient of the friction", "coefficiente dell'attrito"}}},
      {"h_2", {"$h_{2}$", "m", {"least film", "spessore minimo del meato"}}},
      {"h_1", {"$h_{1}$", "m", {"greatest film", "spessore massimo del meato"}}},
      {"tilt", {"$α$", "rad", {"tilt of the pad, (h_1 - h_2)/l", "inclinazione del pattino, (h_1 - h_2)/l"}}},
      {"f_m", {"$f_{m}$", "1", {"mean coefficient of friction", "coefficiente d'attrito mediato"}}},
      {"T",
       {"$\\it{T}$",
        "N/m",
        {"friction of a pad, for a unit of width", "attrito del pattino per unità di larghezza"}}},
      {"p_mean", {"$p_{m}$", "Pa", {"mean pressure", "pressione media"}}},
      {"p_max", {"$p_{max}$", "Pa", {"greatest pressure", "pressione massima"}}},
      {"x_bar", {"$x^{*}$", "m", {"where the pressure is greatest", "sezione di pressione massima"}}},
      {"c", {"$c$", "1", {"factor of side leakage for the load", "coefficiente di fuoriuscita laterale del carico"}}},
      {"c_prime",
       {"$c'$",
        "1",
        {"factor of side leakage for the friction", "coefficiente di fuoriuscita laterale dell'attrito"}}},
      {"N_side_leakage",
       {"$\\it{N}'$",
        "N/m",
        {"load that the finite pad carries at h_2", "carico del pattino finito con lo stesso h_2"}}},
      {"h_2_side_leakage", {"$h'_{2}$", "m", {"least film of the finite pad", "spessore minimo del pattino finito"}}},
      {"f_m_side_leakage",
       {"$f'_{m}$", "1", {"friction coefficient of the finite pad", "coefficiente d'attrito del pattino finito"}}},
      {"film_margin",
       {"$h_{2}$/$h_{0}$", "1", {"least film over the one allowed", "spessore minimo su quello di riferimento"}}},
      {"film_margin_side_leakage",
       {"$h'_{2}$/$h_{0}$", "1", {"the same for the finite pad", "lo stesso per il pattino finito"}}},
      {"hydrodynamic",
       {"hydrodynamic",
        "1",
        {"1 when the film is at least the one allowed", "1 se il meato è almeno quello di riferimento"}}},
      {"hydrodynamic_side_leakage",
       {"hydrodynamic'", "1", {"the same for the finite pad", "lo stesso per il pattino finito"}}},
      {"friction_torque",
       {"$\\it{M}$", "N*m", {"torque of friction, all pads", "momento d'attrito, tutti i pattini"}}},
      {"power_loss", {"$\\it{W}$", "W", {"power lost, all pads", "potenza persa, tutti i pattini"}}},
      {"R_outer", {"$\\it{R}_{e}$", "m", {"outer radius", "raggio esterno"}}},
      {"R_inner", {"$\\it{R}_{i}$", "m", {"inner radius", "raggio interno"}}},
      {"pitch",
       {"$p_{c}$", "m", {"pitch of the pads on the mean circle", "passo dei pattini sulla circonferenza media"}}},
      {"gap",
       {"$d$", "m", {"gap between pads on the mean circle", "distanza tra i pattini sulla circonferenza media"}}},
  };
  return quantity_of(kinds, name);
}

Quantity at_station(const std::string& of, const std::string& station) {
  static const QuantityKinds kinds{
      {"h", {"$h$", "m", {"film", "spessore del meato"}}},
      {"dp_dx", {"$p'$", "Pa/m", {"gradient of the pressure", "gradiente della pressione"}}},
      {"p", {"$p$", "Pa", {"pressure", "pressione"}}},
      {"p_bezout", {"$p_{B}$", "Pa", {"pressure by Bezout's formula", "pressione con la formula di Bezout"}}},
      {"tau_0", {"$τ_{0}$", "Pa", {"shear on the fixed wall", "sforzo sulla parete fissa"}}},
      {"tau_h", {"$τ_{h}$", "Pa", {"shear on the moving wall", "sforzo sulla parete mobile"}}},
  };
  const QuantityKind& kind = kinds.at(of);
  return {of + "_at_" + station, kind.symbol + "(" + letters_of(station) + ")", kind.unit,
          kind.meaning + where(station)};
}

Quantity velocity_at(const std::string& station, const std::string& depth) {
  const Words meaning{"velocity of the film", "velocità della falda"};
  const std::string x = letters_of(station);
  if (depth == mid_film)
    return {"u_at_" + station + "_" + depth, "$u$(" + x + ", $h$/2)", "m/s",
            meaning + where(station) + Words{", in mid film", ", a metà meato"}};
  const std::string z = place(depth.substr(0, 4)).english;
  return {"u_at_" + station + "_z_" + depth, "$u$(" + x + ", " + in_thousandths(depth.substr(0, 4)) + " µm)", "m/s",
          meaning + where(station) + ", z = " + decimal(z) + " mm"};
}

}  // namespace epure::michell_bearing
