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
  // Where the torque is the mean one: in suction too, if that is strong.
  const bool suction_exceeds = pump.suction > mean;
  std::vector<double> crossings{0};
  if (suction_exceeds) {
    const double rises = std::asin(mean / pump.suction) / degree;
    crossings.insert(crossings.end(), {rises, 180 - rises});
  }
  crossings.insert(crossings.end(), {180 + first, 180 + second, 360});
  // What is wanting below the mean line, and what lies above it, in turn.
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    std::vector<drawings::Datum> between{{crossings[i], mean}};
    for (const drawings::Datum& each : torque)
      if (each.x >= crossings[i] && each.x <= crossings[i + 1]) between.push_back(each);
    between.push_back({crossings[i + 1], mean});
    chart.areas.push_back({between, i % 2 == 0 ? Meaning::velocity : Meaning::force});
  }
  chart.curves = {{.name = "torque", .runs = {torque}, .meaning = Meaning::force}};
  chart.horizontals = {{.at = mean, .label = "$\\it{M}_{m}$"}};
  chart.markers = {{.at = {180 + first, mean}, .label = "$β_{1}$"}, {.at = {180 + second, mean}, .label = "$β_{2}$"}};
  if (suction_exceeds) {
    chart.markers.push_back({.at = {crossings[1], mean}, .label = "$α_{1}$"});
    chart.markers.push_back({.at = {crossings[2], mean}, .label = "$α_{2}$"});
  }
  // Besides, the twelfths of the turn in delivery: both that have one height.
  const TorquePanel panel(pump.suction, pump.delivery,
                          {{90, "$\\it{F}_{a}r$"},
                           {180 + first, "$β_{1}$"},
                           {225, "225°, 315°"},
                           {315, ""},
                           {210, "210°, 330°"},
                           {330, ""},
                           {240, "240°, 300°"},
                           {300, ""},
                           {270, "270°"}},
                          chart,
                          {{"M_r_mean", {0, 0}, {0, mean}, 1},
                           {"alpha_1_deg", {180, mean}, {180 + first, mean}, 1},
                           {"alpha_2_deg", {180, mean}, {180 + second, mean}, 1},
                           {"M_r_suction_coefficient", {90, 0}, {90, pump.suction}, 1}});
  const Words projection{
      "The mean line $\\it{M}_{m}$ = $\\it{L}_{r}$/2π leaves as much area above as is wanting below; from $β_{1}$ to "
      "$β_{2}$, counted from the start of delivery ($α$ = 180°), the pump asks for more than the motor gives.",
      "La retta media $\\it{M}_{m}$ = $\\it{L}_{r}$/2π lascia tanta area sopra quanta ne manca sotto; da $β_{1}$ a "
      "$β_{2}$, contati dall'inizio della mandata ($α$ = 180°), la pompa chiede più di quanto dia il motore."};
  const Words in_suction{
      "In suction too: from $α_{1}$, where sin $α$ = $\\it{M}_{m}$/$\\it{F}_{a}r$, to $α_{2}$ = 180° − $α_{1}$.",
      "Anche in aspirazione: da $α_{1}$, dove sen $α$ = $\\it{M}_{m}$/$\\it{F}_{a}r$, a $α_{2}$ = 180° − $α_{1}$."};
  return {.panels = panels(panel),
          .results = {remark(projection.in(language)), remark(suction_exceeds ? in_suction.in(language) : ""),
                      values({"A_p", "V"}), values({"n_rpm", "omega"}), values({"F_a", "F_m"}),
                      values({"L_suction", "L_delivery"}), values({"L_r", "W_r"}),
                      values({"M_r_suction_coefficient", "M_r_delivery_coefficient"}), values({"M_r_mean", "tau"}),
                      remark("$τ$ = $n$/$n_{m}$"), values({"alpha_1_deg", "alpha_2_deg"})},
          .seen = {"The resisting torque over the turn, projected from the crank, with its mean line",
                   "Il momento resistente lungo il giro, proiettato dalla manovella, con la retta media"},
          .told = {"L_r", "M_r_mean", "alpha_1_deg", "alpha_2_deg"},
          .without_part = {"W_t", "n_0", "J_m", "m", "i"}};
}

}  // namespace epure::pump_flywheel
