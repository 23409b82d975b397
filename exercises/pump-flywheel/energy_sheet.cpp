// The energy that the flywheel takes and gives: the torque left over, integrated graphically.
#include <algorithm>

#include "exercises/kit/panels/integration_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pump-flywheel/drawn_pump.h"
#include "exercises/pump-flywheel/sheets.h"
#include "exercises/pump-flywheel/torque.h"

namespace epure::pump_flywheel {
namespace {

constexpr double half_turn = std::numbers::pi;

// Reads are ordinates at the strips' ends. `left_over`: the letters of the torque.
IntegrationPanel integrated(const DrawnPump& pump, const std::string& left_over, double first, double second,
                            std::vector<IntegrationRow::Read> read) {
  std::vector<double> ends = strips_of_suction(half_turn);
  const std::vector<double> late = strips_of_delivery(first, second, half_turn);
  for (const double end : late)  // of which doubles may have one that begins where the other half ends
    if (half_turn + end > ends.back()) ends.push_back(half_turn + end);
  std::vector<double> corners, carried;
  for (const double end : ends) corners.push_back(pump.energy(end));
  for (std::size_t i = 1; i < ends.size(); ++i)
    carried.push_back((corners[i] - corners[i - 1]) / (ends[i] - ends[i - 1]));
  return {{.letters = "$α$", .unit = "rad", .ends = ends},
          {{.letters = left_over,
            .unit = "N m",
            .meaning = Meaning::force,
            .curve = [=](double alpha) { return pump.mean - pump.resisting(alpha); },
            .carried = carried},
           {.letters = "Δ$\\it{T}$",
            .unit = "J",
            .meaning = Meaning::velocity,
            .id = "Delta_T",
            .curve = [=](double alpha) { return pump.energy(alpha); },
            .corners = corners,
            .read = std::move(read)}},
          {"the ordinate that makes the areas equal", "l'ordinata che compensa le aree"}};
}

const Words off_the_curve{
    "At its corners the polygon lies on the true curve, as the areas are equal; between them it is off by at most "
    "$δ_{T}$, the greatest of Δ$α^{2}$/8 times the steepest slope of $\\it{M}_{r}$ in the strip of the width Δ$α$.",
    "Nei vertici il poligono sta sulla curva esatta, poiché le aree sono uguali; fra l'uno e l'altro se ne scosta al "
    "più di $δ_{T}$, il massimo di Δ$α^{2}$/8 per la massima pendenza di $\\it{M}_{r}$ nella striscia larga Δ$α$."};

Result on_flywheel(const Solution& s, const std::string& of, Language language) {
  const Words words =
      s[of + "J_flywheel"] > 0
          ? Words{"Of $\\it{J}$ = $\\it{J}'τ^{2}$ the motor has $\\it{J}_{m}$; the flywheel the rest.",
                  "Di $\\it{J}$ = $\\it{J}'τ^{2}$ il motore ha $\\it{J}_{m}$; il volano il resto."}
          : Words{
                "$\\it{J}$ = $\\it{J}'τ^{2}$ is not more than $\\it{J}_{m}$: the motor alone suffices, and no "
                "flywheel is needed.",
                "$\\it{J}$ = $\\it{J}'τ^{2}$ non supera $\\it{J}_{m}$: il solo motore basta e il volano non "
                "occorre."};
  return remark(words.in(language));
}

Words without_mass(const Solution& s) {
  const Words left_out{"The reciprocating mass is left out, which is allowed while $mr^{2}$ is far below $\\it{J}'$",
                       "Le masse alterne sono trascurate: è lecito finché $mr^{2}$ è molto minore di $\\it{J}'$"};
  return left_out + (s["J_s_max_over_J_crank"] < 1 ? Words{".", "."}
                                                   : Words{"; here it is not, and the sheets with the mass hold.",
                                                           "; qui non lo è, e valgono le tavole con le masse."});
}

}  // namespace

PanelSheet energy_sheet(const Solution& s, Language language) {
  const DrawnPump pump(s);
  const double first = s["alpha_1"], second = s["alpha_2"];
  return {.panels = panels(integrated(pump, "$\\it{M}_{m}$ − $\\it{M}_{r}$", first, second,
                                      {{.quantity = "Delta_T_suction_end",
                                        .label = "Δ$\\it{T}$(π)",
                                        .at = half_turn,
                                        .value = s["Delta_T_suction_end"]},
                                       {.quantity = "Delta_T_peak",
                                        .label = "Δ$\\it{T}_{1}$",
                                        .at = half_turn + first,
                                        .value = s["Delta_T_peak"]},
                                       {.quantity = "Delta_T_trough",
                                        .label = "Δ$\\it{T}_{2}$",
                                        .at = half_turn + second,
                                        .value = s["Delta_T_trough"]}})),
          .results =
              {remark(off_the_curve.in(language)), values({"polygon_off_at_most"}), values({"M_r_mean"}),
               values({"alpha_1", "alpha_2"}), values({"alpha_1_deg", "alpha_2_deg"}),
               values({"Delta_T_suction_end"}), values({"Delta_T_peak", "Delta_T_trough"}), values({"Delta_T_max"}),
               remark("Δ$\\it{T}_{max}$ = Δ$\\it{T}_{1}$ − Δ$\\it{T}_{2}$, $\\it{J}'$ = Δ$\\it{T}_{max}$/($iω^{2}$)"),
               values({"J_crank", "J_motor_shaft"}), on_flywheel(s, "", language), values({"J_flywheel"}),
               values({"omega_max", "omega_min"}), remark(without_mass(s).in(language)),
               values({"J_s_max_over_J_crank"})},
          .seen = {"The torque left over along the turn, and its integral polygon, the energy of the flywheel",
                   "Il momento eccedente lungo il giro e il suo poligono integrale, l'energia del volano"},
          .told = {"Delta_T_peak", "Delta_T_trough", "Delta_T_max", "J_crank", "J_flywheel"},
          .without_part = {"W_t", "n_0"}};
}

PanelSheet energy_with_mass_sheet(const Solution& s, Language language) {
  const DrawnPump pump(s, s["M_inertia_max"]);
  const double first = s["reciprocating_mass.alpha_1"], second = s["reciprocating_mass.alpha_2"];
  const Words left_over{"$\\it{M}_{m}$ − $\\it{M}_{r}$ − $\\it{M}_{s}$ sin 2$α$",
                        "$\\it{M}_{m}$ − $\\it{M}_{r}$ − $\\it{M}_{s}$ sen 2$α$"};
  IntegrationPanel panel = integrated(
      pump, left_over.in(language), first, second,
      {{.quantity = {}, .label = "Δ$\\it{T}_{1}$", .at = half_turn + first, .value = pump.energy(half_turn + first)},
       {.quantity = {},
        .label = "Δ$\\it{T}_{2}$",
        .at = half_turn + second,
        .value = pump.energy(half_turn + second)}});
  const Words mass{
      "The reciprocating mass asks for $\\it{M}_{s}$ sin 2$α$, $\\it{M}_{s}$ = $mr^{2}ω^{2}$/2, and gives it back: "
      "over the turn it does no work, but it moves $β_{1}$ and $β_{2}$.",
      "Le masse alterne chiedono $\\it{M}_{s}$ sen 2$α$, $\\it{M}_{s}$ = $mr^{2}ω^{2}$/2, e lo restituiscono: nel "
      "giro non fanno lavoro, ma spostano $β_{1}$ e $β_{2}$."};
  const Words cut_off{"With it the motor follows harmonics below $n'_{t}$ cycles per turn alone:",
                      "Con esso il motore segue le sole armoniche sotto $n'_{t}$ cicli al giro:"};
  const std::string of = "reciprocating_mass.";
  return {
      .panels = panels(std::move(panel)),
      .results = {remark(off_the_curve.in(language)), values({of + "polygon_off_at_most"}), remark(mass.in(language)),
                  values({"M_inertia_max", "J_s_max"}), values({of + "alpha_1", of + "alpha_2"}),
                  values({of + "alpha_1_deg", of + "alpha_2_deg"}), values({of + "Delta_T_max"}),
                  values({of + "J_crank", of + "J_motor_shaft"}), on_flywheel(s, of, language),
                  values({of + "J_flywheel"}), remark(cut_off.in(language)), values({of + "n_t_flywheel"})},
      .seen = {"The torque left over with the reciprocating mass, and its integral polygon",
               "Il momento eccedente con le masse alterne e il suo poligono integrale"},
      .told = {of + "alpha_1", of + "alpha_2", of + "Delta_T_max", of + "J_crank"},
      .without_part = {"W_t", "n_0"}};
}

}  // namespace epure::pump_flywheel
