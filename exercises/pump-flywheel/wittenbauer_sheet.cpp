// Wittenbauer's diagram: work over reduced inertia, with its two tangents.
#include <algorithm>

#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pump-flywheel/drawn_pump.h"
#include "exercises/pump-flywheel/sheets.h"

namespace epure::pump_flywheel {

PanelSheet wittenbauer_sheet(const Solution& s, Language language) {
  const DrawnPump pump(s);
  const std::string of = "wittenbauer.";
  const double most = s["J_s_max"], right = most > 0 ? 1.1 * most : 1;
  const double upper = s[of + "intercept_max"], lower = s[of + "intercept_min"];
  const double steep = s[of + "slope_max"], slight = s[of + "slope_min"];
  const auto at = [&](double alpha) {
    const double sine = std::sin(alpha);
    return drawings::Datum{most * sine * sine, pump.energy(alpha)};
  };
  std::vector<drawings::Datum> run;
  for (int i = 0; i <= 720; ++i) run.push_back(at(i * degree / 2));
  double high = upper + steep * right, low = lower;
  for (const drawings::Datum& each : run) high = std::max(high, each.y), low = std::min(low, each.y);
  const double air = 0.05 * (high - low);
  drawings::Chart chart;
  chart.x = {.quantity = Words{"$mr^{2}$ sin² $α$", "$mr^{2}$ sen² $α$"}.in(language),
             .unit = "kg m²",
             .low = 0,
             .high = right};
  chart.y = {.quantity = "$\\it{W}$", .unit = "J", .low = low - air, .high = high + air};
  chart.curves = {{.name = "work", .runs = {run}, .meaning = Meaning::force, .label = "$\\it{W}$"},
                  {.name = "upper",
                   .runs = {{{0, upper}, {right, upper + steep * right}}},
                   .meaning = Meaning::velocity,
                   .label = "$ω^{2}_{max}$/2"},
                  {.name = "lower",
                   .runs = {{{0, lower}, {right, lower + slight * right}}},
                   .meaning = Meaning::locus,
                   .label = "$ω^{2}_{min}$/2"}};
  chart.horizontals = {{.at = 0}};
  chart.markers = {{.at = at(std::numbers::pi + s[of + "alpha_1"]), .label = "$β_{1}$"},
                   {.at = at(std::numbers::pi + s[of + "alpha_2"]), .label = "$β_{2}$"},
                   {.at = {0, upper}, .label = "$\\it{W}_{1}$", .meaning = Meaning::velocity},
                   {.at = {0, lower}, .label = "$\\it{W}_{2}$", .meaning = Meaning::locus}};
  // How the curve is run through: the angles that no other point has.
  for (const int degrees : {30, 60, 120, 150, 240, 300})
    if (most > 0)
      chart.markers.push_back(
          {.at = at(degrees * degree), .label = std::to_string(degrees) + "°", .meaning = Meaning::force});
  const ChartPanel panel(chart, {{{0, upper}, {}, of + "intercept_max"}, {{0, lower}, {}, of + "intercept_min"}});
  const Words tangents{
      "$\\it{E}_{0}$ + $\\it{W}$ = ($\\it{J}'$ + $mr^{2}$ sin² $α$)$ω^{2}$/2: from the point −$\\it{J}'$, "
      "−$\\it{E}_{0}$ far to the left the curve is seen between two tangents of the slopes $ω^{2}_{max}$/2 and "
      "$ω^{2}_{min}$/2. What they cut off on the axis of works is ($ω^{2}_{max}$ − $ω^{2}_{min}$)/2 = $iω^{2}$ times "
      "$\\it{J}'$: so $\\it{J}'$ = ($\\it{W}_{1}$ − $\\it{W}_{2}$)/($iω^{2}$), with nothing left out.",
      "$\\it{E}_{0}$ + $\\it{W}$ = ($\\it{J}'$ + $mr^{2}$ sen² $α$)$ω^{2}$/2: dal punto −$\\it{J}'$, −$\\it{E}_{0}$, "
      "lontano a sinistra, la curva è vista tra due tangenti di pendenza $ω^{2}_{max}$/2 e $ω^{2}_{min}$/2. Ciò che "
      "staccano sull'asse dei lavori è ($ω^{2}_{max}$ − $ω^{2}_{min}$)/2 = $iω^{2}$ per $\\it{J}'$: dunque "
      "$\\it{J}'$ = ($\\it{W}_{1}$ − $\\it{W}_{2}$)/($iω^{2}$), senza trascurare nulla."};
  return {.panels = panels(panel),
          .results = {remark(tangents.in(language)), values({of + "slope_max", of + "slope_min"}),
                      values({of + "alpha_1", of + "alpha_2"}), values({of + "intercept_max", of + "intercept_min"}),
                      values({of + "J_crank", of + "J_motor_shaft"}), values({of + "J_flywheel"}),
                      values({of + "n_t_flywheel"})},
          .seen = {"Wittenbauer's diagram, work over reduced inertia, with its two tangents",
                   "Il diagramma di Wittenbauer, lavoro su inerzia ridotta, con le due tangenti"},
          .told = {of + "intercept_max", of + "intercept_min", of + "J_crank"},
          .without_part = {"W_t", "n_0"}};
}

}  // namespace epure::pump_flywheel
