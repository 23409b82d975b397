// The harmonics of the torque against the cut-off of the motor, before and after the flywheel.
#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pump-flywheel/drawn_pump.h"
#include "exercises/pump-flywheel/sheets.h"

namespace epure::pump_flywheel {

PanelSheet harmonics_sheet(const Solution& s, Language language) {
  const double n_1 = s["n_1"], n_t = s["n_t"], with_flywheel = s["n_t_flywheel"], n_30 = s["n_30"];
  const bool has_flywheel = s["J_flywheel"] > 0;
  const DrawnPump pump(s);
  std::vector<drawings::Datum> amplitudes;
  std::vector<std::vector<drawings::Datum>> bars;
  const double least = std::pow(10, std::floor(std::log10(s["M_r_harmonic_30"] / 1.2)));
  for (int k = 1; k <= 30; k += k == 1 ? 1 : 2) {
    const double amplitude =
        k == 1 ? s["M_r_harmonic_1"] : 2 * (pump.suction + pump.delivery) / (std::numbers::pi * (k * k - 1));
    if (amplitude <= 0) continue;
    amplitudes.push_back({k * n_1, amplitude});
    bars.push_back({{k * n_1, least}, {k * n_1, amplitude}});
  }
  drawings::Chart chart;
  const double least_shown = has_flywheel ? with_flywheel : n_t;
  chart.x = {.quantity = Words{"$kτ$, cycles per turn of the motor", "$kτ$, cicli per giro del motore"}.in(language),
             .low = 0.7 * std::min({n_1, n_t, least_shown}),
             .high = 1.4 * std::max({n_30, n_t, least_shown}),
             .scale = drawings::AxisScale::logarithmic};
  chart.y = {.quantity = "$\\it{M}_{k}$",
             .unit = "N m",
             .low = least,
             .high = 2 * std::max(s["M_r_harmonic_1"], s["M_r_harmonic_2"]),
             .scale = drawings::AxisScale::logarithmic};
  chart.curves = {{.name = "bars", .runs = bars, .meaning = Meaning::force},
                  {.name = "harmonics", .meaning = Meaning::force, .points = amplitudes}};
  chart.verticals = {{.at = n_t, .label = "$n_{t}$", .meaning = Meaning::velocity}};
  if (has_flywheel) chart.verticals.push_back({.at = with_flywheel, .label = "$n'_{t}$", .meaning = Meaning::locus});
  for (const int k : {1, 2, 30}) {
    const double amplitude = s["M_r_harmonic_" + std::to_string(k)];
    if (amplitude > 0)
      chart.markers.push_back(
          {.at = {k * n_1, amplitude}, .label = "$k$ = " + std::to_string(k), .meaning = Meaning::force});
  }
  const Words first = s["motor_alone_suffices"] == 1
                          ? Words{"Without a flywheel the cut-off $n_{t}$ lies below all harmonics: the motor's rotor "
                                  "alone suffices.",
                                  "Senza volano la frequenza di taglio $n_{t}$ sta sotto tutte le armoniche: basta il "
                                  "rotore del motore."}
                          : Words{"Without a flywheel harmonics lie below the cut-off $n_{t}$: neither the motor's "
                                  "stiffness nor its inertia alone suffices.",
                                  "Senza volano alcune armoniche stanno sotto la frequenza di taglio $n_{t}$: non "
                                  "bastano né la sola rigidezza né la sola inerzia del motore."};
  const Words none{"The irregularity asks for no flywheel: the rotor has inertia enough.",
                   "L'irregolarità non richiede volano: basta l'inerzia del rotore."};
  const Words then =
      !has_flywheel ? none
      : s["stiffness_negligible_with_flywheel"] == 1
          ? Words{"With the flywheel $n'_{t}$ is below the fundamental $n_{1}$: the stiffness is negligible.",
                  "Con il volano $n'_{t}$ è sotto la fondamentale $n_{1}$: la rigidezza è trascurabile."}
          : Words{"With the flywheel $n'_{t}$ is not below the fundamental $n_{1}$: the stiffness counts.",
                  "Con il volano $n'_{t}$ non è sotto la fondamentale $n_{1}$: la rigidezza conta."};
  const Words formulas{
      "$\\it{M}_{k}$: the amplitudes of the Fourier series of $\\it{M}_{r}$, of which the odd ones beyond the first "
      "are "
      "nought. $k_{m}$ = $\\it{M}_{t}$/($ω_{0}$ − $ω_{m}$), $n_{t}$ = $k_{m}$/($\\it{J}_{m}ω_{m}$).",
      "$\\it{M}_{k}$: le ampiezze della serie di Fourier di $\\it{M}_{r}$, di cui le dispari oltre la prima sono "
      "nulle. "
      "$k_{m}$ = $\\it{M}_{t}$/($ω_{0}$ − $ω_{m}$), $n_{t}$ = $k_{m}$/($\\it{J}_{m}ω_{m}$)."};
  return {.panels = panels(ChartPanel(chart)),
          .results = {remark(formulas.in(language)), values({"M_r_harmonic_1", "M_r_harmonic_2"}),
                      values({"M_r_harmonic_30"}), values({"omega_m", "omega_sync"}), values({"M_t", "k_m"}),
                      values({"n_1", "n_30"}), values({"n_t"}), remark(first.in(language)),
                      values(has_flywheel ? std::vector<std::string>{"n_t_flywheel"} : std::vector<std::string>{}),
                      remark(then.in(language))},
          .seen = {"Harmonics of the torque over cycles per turn of the motor, with the cut-off before and after the "
                   "flywheel",
                   "Armoniche del momento in cicli per giro del motore, con la frequenza di taglio prima e dopo il "
                   "volano"},
          .told = {"n_1", "n_30", "n_t", "n_t_flywheel"},
          .without_part = {"m"}};
}

}  // namespace epure::pump_flywheel
