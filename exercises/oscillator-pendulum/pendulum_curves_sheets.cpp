#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/phase_plane_panel.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/oscillator-pendulum/charts.h"
#include "exercises/oscillator-pendulum/problem.h"
#include "exercises/oscillator-pendulum/quantities.h"
#include "exercises/oscillator-pendulum/sheets.h"

namespace epure::oscillator_pendulum {
namespace {

// θ' = a sin θ, of which all points have the direction dθ'/dθ = -Ω²/a.
std::vector<Line> sine_isoclines(double greatest, double wide) {
  std::vector<Line> all;
  for (const double part : {-1.2, -0.8, -0.4, 0.4, 0.8, 1.2}) {
    Line line;
    constexpr int points = 60;
    for (int k = -points; k <= points; ++k) {
      const double theta = wide * k / points;
      line.push_back({theta, part * greatest * std::sin(theta)});
    }
    all.push_back(line);
  }
  return all;
}

// As far as the phase plane shows it.
std::vector<Moving> spiral_of_table(const Solution& s) {
  constexpr double table = 1;
  return swing_of_table(s.givens(), s[pen("Omega")], std::min(2.5 * table, 3 * s[pen("period")]));
}
// As far as the chart of the angle does.
double end_of_angle_chart(const Solution& s) {
  return 1.12 * std::max(s[pen("period")], s.value(pen("period_numeric")).value_or(0));
}
std::vector<Moving> angle_of_table(const Solution& s) {
  return swing_of_table(s.givens(), s[pen("Omega")], std::min(end_of_angle_chart(s), 5.0));
}

// Half again as far as there is need for, or the whole of it where that is less.
double with_room(const Line& line, double Datum::*along, double whole) {
  double most = 0;
  for (const Datum& each : line) most = std::max(most, std::abs(each.*along));
  return std::min(whole, 1.5 * most);
}

PhasePlanePanel pendulum_plane(const Solution& s, Language language) {
  const Givens& givens = s.givens();
  const double Omega = s[pen("Omega")], period = s[pen("period")];
  const Line exact = in_phase_plane(swing(givens, Omega, period, smooth)),
             spiral = thinned(in_phase_plane(spiral_of_table(s)), 300);
  Line above, below;
  for (int k = -smooth / 4; k <= smooth / 4; ++k) {
    const double theta = 4 * M_PI * k / smooth, rate = 2 * Omega * std::cos(theta / 2);
    above.push_back({theta, rate});
    below.push_back({theta, -rate});
  }
  // Small swings are shown larger, and the separatrix then lies outside.
  Line both = exact;
  both.insert(both.end(), spiral.begin(), spiral.end());
  const double wide = with_room(both, &Datum::x, M_PI), most = with_room(both, &Datum::y, 2.1 * Omega);
  PhasePlane plane{.x = axis("$θ$", "rad", {-wide, wide}),
                   .y = axis("$θ'$", "rad/s", {-most, most}),
                   .motion = [=](const Datum& p) {
                     return Arrow2{p.y, -Omega * Omega * std::sin(p.x)};
                   }};
  plane.isoclines = sine_isoclines(most / 1.05 / std::sin(std::min(wide, M_PI / 2)), wide);
  if (2 * Omega * std::cos(wide / 2) < most)
    plane.orbits.push_back({.name = "separatrix",
                            .label = Words{"separatrix", "separatrice"}.in(language),
                            .runs = {above, below},
                            .meaning = Meaning::second_locus,
                            .line = drawings::LineType::dashed});
  plane.orbits.push_back({.name = "orbit", .label = Words{"exact", "esatta"}.in(language), .runs = {exact}});
  plane.orbits.push_back({.name = "table",
                          .label = Words{"recursion", "ricorsiva"}.in(language),
                          .runs = {spiral},
                          .meaning = Meaning::velocity});
  for (const std::string& name : instants("theta_dot")) {
    const auto theta = s.value(pen(at("theta", name))), rate = s.value(pen(at("theta_dot", name)));
    if (!theta || !rate) continue;
    plane.read.push_back({{*theta, *rate}, pen(at("theta", name)), pen(at("theta_dot", name))});
    plane.markers.push_back({.at = {*theta, *rate}, .label = in_milliseconds(name), .meaning = Meaning::locus});
  }
  for (const char* name : {"0p5", "1"}) {
    const auto theta = s.value(pen(at("theta_numeric", name))), rate = s.value(pen(at("theta_dot_numeric", name)));
    if (!theta || !rate) continue;
    plane.read.push_back({{*theta, *rate}, pen(at("theta_numeric", name)), pen(at("theta_dot_numeric", name))});
    plane.markers.push_back(
        {.at = {*theta, *rate}, .label = {}, .shape = drawings::PointShape::ring, .meaning = Meaning::velocity});
  }
  return PhasePlanePanel(plane);
}

ChartPanel angle_chart(const Solution& s, Language language) {
  const Givens& givens = s.givens();
  const double Omega = s[pen("Omega")], period = s[pen("period")], small = s[pen("period_small")],
               theta_0 = geometry::to_double(givens.angle("theta_0")), end = end_of_angle_chart(s);
  const std::vector<Moving> table = angle_of_table(s);
  Line cosine;
  for (int i = 0; i <= smooth; ++i)
    cosine.push_back({end * i / smooth, theta_0 * std::cos(Omega * end * i / smooth)});
  drawings::Chart chart;
  const double most = 1.35 * std::abs(theta_0);
  chart.x = axis("$t$", "s", {0, end});
  chart.y = axis("$θ$", "rad", {-most, most});
  chart.horizontals = {{.at = 0}};
  chart.verticals = {{.at = period, .label = "$\\it{T}$", .meaning = Meaning::locus},
                     {.at = small, .label = "$\\it{T}_{0}$"}};
  const auto of_table = s.value(pen("period_numeric"));
  if (of_table) chart.verticals.push_back({.at = *of_table, .label = "$\\it{T}_{n}$", .meaning = Meaning::velocity});
  chart.curves = {
      {.name = "theta",
       .runs = {over_time(swing(givens, Omega, end, smooth))},
       .meaning = Meaning::locus,
       .label = Words{"exact", "esatta"}.in(language)},
      {.name = "theta_small", .runs = {cosine}, .meaning = Meaning::construction, .label = "$θ_{0}$cos $Ωt$"},
      {.name = "theta_numeric",
       .runs = {thinned(over_time(table), 400)},
       .meaning = Meaning::velocity,
       .label = Words{"recursion", "ricorsiva"}.in(language)}};
  std::vector<ChartPanel::Read> all;
  for (const char* of : {"theta", "theta_numeric", "theta_small"})
    for (const std::string& name : instants(of)) read(all, s, seconds(name), {}, pen(at(of, name)));
  all.push_back({{s[pen("t_first_bottom")], 0}, pen("t_first_bottom"), {}});
  all.push_back({{period, 0}, pen("period"), {}});
  all.push_back({{small, 0}, pen("period_small"), {}});
  if (of_table) all.push_back({{*of_table, 0}, pen("period_numeric"), {}});
  return ChartPanel(chart, all);
}

}  // namespace

PanelSheet pendulum_plane_sheet(const Solution& s, Language language) {
  const RunOfTable run = run_of_table(spiral_of_table(s), s[pen("Omega")]);
  const Words closed{"The exact orbit is closed: $θ'^{2}$ = 2$Ω^{2}$(cos $θ$ − cos $θ_{0}$). ",
                     "L'orbita esatta è chiusa: $θ'^{2}$ = 2$Ω^{2}$(cos $θ$ − cos $θ_{0}$). "},
      winds{"The recursion adds energy at every step and winds outwards",
            "La formula ricorsiva aggiunge energia a ogni passo e si apre in spirale"},
      wavers{"The recursion does not keep the energy: some steps add to it, others take from it",
             "La formula ricorsiva non conserva l'energia: alcuni passi ne aggiungono, altri ne tolgono"},
      over{"; it goes over the top", "; passa per il punto più alto"}, stop{". ", ". "};
  std::string rings;
  for (const char* name : {"0p5", "1"})
    if (s.value(pen(at("theta_numeric", name)))) rings += (rings.empty() ? "" : ", ") + in_milliseconds(name) + " ms";
  const Words told_rings =
      rings.empty() ? Words{}
                    : format_words("Rings: its values after {}. ", "Anelli: i suoi valori dopo {}. ", rings);
  const Words orbit = closed + (run.gains_always ? winds : wavers) + (run.goes_over ? over + stop : stop) +
                      told_rings + Words{"Numbers: $t$ in ms.", "Numeri: $t$ in ms."};
  return {.panels = panels(pendulum_plane(s, language)),
          .theory = {{{"The plane", "Il piano"}, {remark(orbit.in(language))}}},
          .results = {values(all_pen({"I_A0", "equivalent_length"})), values(all_pen({"Omega", "theta_dot_max"})),
                      values(all_pen({"energy_ratio_numeric_at_1"})),
                      table({"$t$ (ms)", "$θ$ (rad)", "$θ'$ (rad/s)"}, rows_of_pendulum({"theta", "theta_dot"}))},
          .seen = {"The phase plane of the pendulum: the exact orbit, the spiral of the recursion, the separatrix",
                   "Il piano delle fasi del pendolo: orbita esatta, spirale della formula ricorsiva, separatrice"},
          .told = {pen("theta_dot_max"), pen("energy_ratio_numeric_at_1")},
          .without_part = givens_of_oscillator};
}

PanelSheet angle_sheet(const Solution& s, Language language) {
  const RunOfTable run = run_of_table(angle_of_table(s), s[pen("Omega")]);
  const Words exact{
      "$\\it{T}$ = 4$\\it{K}$/$Ω$ of the exact motion, $\\it{T}_{0}$ = 2$π$/$Ω$ of small swings",
      "$\\it{T}$ = 4$\\it{K}$/$Ω$ del moto esatto, $\\it{T}_{0}$ = 2$π$/$Ω$ delle piccole oscillazioni"},
      over{". The recursion goes over the top, and has no period.",
           ". La formula ricorsiva passa per il punto più alto e non ha periodo."},
      not_yet{". The recursion has not swung to and fro by then.",
              ". La formula ricorsiva non ha ancora compiuto un'oscillazione."};
  const Words of_row{
      ", $\\it{T}_{n}$ of the recursion: the step at which it rests again on the side where it began.",
      ", $\\it{T}_{n}$ della formula ricorsiva: il passo in cui si ferma di nuovo dalla parte da cui è partita."};
  const Words recursion = s.value(pen("period_numeric")) ? of_row : run.goes_over ? over : not_yet;
  const Words periods = exact + recursion;
  return {
      .panels = panels(angle_chart(s, language)),
      .theory = {{{"Periods", "Periodi"}, {remark(periods.in(language))}}},
      .results = {values(all_pen({"k", "K"})), values(all_pen({"period", "period_small", "period_numeric"})),
                  values(all_pen({"period_ratio"})), values(all_pen({"t_first_bottom"})),
                  table({"$t$ (ms)", "$θ$ (rad)", "$θ_{n}$ (rad)"}, rows_of_pendulum({"theta", "theta_numeric"}))},
      .seen = {"The angle of the pendulum over time: exact, for small swings, and by the recursion",
               "L'angolo del pendolo nel tempo: esatto, per piccole oscillazioni e con la formula ricorsiva"},
      .told = all_pen({"period", "period_small", "theta_at_1", "theta_numeric_at_1"}),
      .without_part = givens_of_oscillator};
}

}  // namespace epure::oscillator_pendulum
