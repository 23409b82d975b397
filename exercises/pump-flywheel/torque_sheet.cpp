// The resisting torque over the turn, from the crank's projection, and its mean by equal areas.
#include "exercises/kit/panels/sheet.h"
#include "exercises/pump-flywheel/drawn_pump.h"
#include "exercises/pump-flywheel/sheets.h"
#include "exercises/pump-flywheel/torque_panel.h"

namespace epure::pump_flywheel {

PanelSheet torque_sheet(const Solution& s, Language language) {
  const DrawnPump pump(s);
  const double first = s["alpha_1_deg"], second = s["alpha_2_deg"], mean = s["M_r_mean"];
  drawings::Chart chart;
  chart.x = {.quantity = "$α$", .unit = "°", .low = 0, .high = 360, .steps = drawings::degree_steps};
  chart.y = {.quantity = "$\\it{M}_{r}$", .unit = "N m", .low = 0, .high = 1.08 * pump.delivery};
  const auto torque = over_the_turn([&](double alpha) { return pump.resisting(alpha); });
  // What lies above the mean line, and what is wanting below it.
  std::vector<drawings::Datum> above{{180 + first, mean}}, before{{0, mean}}, after{{180 + second, mean}};
  for (const drawings::Datum& each : torque) {
    if (each.x > 180 + first && each.x < 180 + second) above.push_back(each);
    if (each.x < 180 + first) before.push_back(each);
    if (each.x > 180 + second) after.push_back(each);
  }
  above.push_back({180 + second, mean});
  before.push_back({180 + first, mean});
  after.push_back({360, mean});
  chart.areas = {{above, Meaning::force}, {before, Meaning::velocity}, {after, Meaning::velocity}};
  chart.curves = {{.name = "torque", .runs = {torque}, .meaning = Meaning::force}};
  chart.horizontals = {{.at = mean, .label = "$\\it{M}_{m}$"}};
  chart.markers = {{.at = {180 + first, mean}, .label = "$α_{1}$"}, {.at = {180 + second, mean}, .label = "$α_{2}$"}};
  const TorquePanel panel(pump.suction, pump.delivery,
                          {{90, "$\\it{F}_{a}r$"}, {180 + first, "$α_{1}$"}, {225, "$\\it{F}_{m}r$"}}, chart,
                          {{"M_r_mean", {0, 0}, {0, mean}, 1},
                           {"alpha_1_deg", {180, mean}, {180 + first, mean}, 1},
                           {"alpha_2_deg", {180, mean}, {180 + second, mean}, 1},
                           {"M_r_suction_coefficient", {90, 0}, {90, pump.suction}, 1}});
  const Words projection{
      "The crank of the length $\\it{F}r$: the height of its end is $\\it{M}_{r}$ = $\\it{F}r$ sin $α$. The mean "
      "line "
      "$\\it{M}_{m}$ = $\\it{L}_{r}$/2π leaves as much area above as is wanting below; from $α_{1}$ to $α_{2}$, "
      "counted from the start of delivery, the pump asks for more than the motor gives.",
      "La manovella lunga $\\it{F}r$: la quota del suo estremo è $\\it{M}_{r}$ = $\\it{F}r$ sen $α$. La retta media "
      "$\\it{M}_{m}$ = $\\it{L}_{r}$/2π lascia tanta area sopra quanta ne manca sotto; da $α_{1}$ ad $α_{2}$, "
      "contati dall'inizio della mandata, la pompa chiede più di quanto dia il motore."};
  return {.panels = panels(panel),
          .results = {remark(projection.in(language)), values({"A_p", "V"}), values({"n_rpm", "omega"}),
                      values({"F_a", "F_m"}), values({"L_suction", "L_delivery"}), values({"L_r", "W_r"}),
                      values({"M_r_suction_coefficient", "M_r_delivery_coefficient"}), values({"M_r_mean", "tau"}),
                      values({"alpha_1_deg", "alpha_2_deg"})},
          .seen = {"The resisting torque over the turn, projected from the crank, with its mean line",
                   "Il momento resistente lungo il giro, proiettato dalla manovella, con la retta media"},
          .told = {"L_r", "M_r_mean", "alpha_1_deg", "alpha_2_deg"},
          .without_part = {"W_t", "n_0", "J_m", "m", "i"}};
}

}  // namespace epure::pump_flywheel
