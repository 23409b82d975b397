#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/phase_plane_panel.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/oscillator-pendulum/charts.h"
#include "exercises/oscillator-pendulum/problem.h"
#include "exercises/oscillator-pendulum/quantities.h"
#include "exercises/oscillator-pendulum/sheets.h"

namespace epure::oscillator_pendulum {
namespace {

std::string osc(const std::string& name) { return "oscillator." + name; }
std::vector<Row> rows_of_oscillator(const std::vector<std::string>& columns) {
  return rows({"1", "2", "5", "10", "20"}, 1, "oscillator.", columns);
}

ChartPanel motion_chart(const Solution& s, Language language) {
  const double end = time_shown(s.givens());
  const Line exact = over_time(oscillation(s.givens(), end, smooth)),
             euler = over_time(euler_polygon(s.givens(), end));
  drawings::Chart chart;
  chart.x = axis("$t$", "s", {0, end});
  chart.y = axis("$x$", "m", ends_of(exact, &Datum::y, 0.15));
  chart.horizontals = {{.at = 0}};
  chart.curves = {{.name = "x", .runs = {exact}, .meaning = Meaning::locus, .label = "$x$($t$)"},
                  {.name = "x_euler",
                   .runs = {euler},
                   .meaning = Meaning::velocity,
                   .points = euler.size() <= most_marked ? euler : Line{},
                   .label = Words{"Euler", "Eulero"}.in(language)}};
  std::vector<ChartPanel::Read> all;
  for (const std::string& name : instants("x")) read(all, s, seconds(name), {}, osc(at("x", name)));
  for (const std::string& name : instants("x_euler")) read(all, s, seconds(name), {}, osc(at("x_euler", name)));
  for (const auto& [t, x, letters] :
       {std::tuple("t_x_max", "x_max", "$x_{m}$"), std::tuple("t_inflection", "x_inflection", "$x_{f}$")}) {
    const auto time = s.value(osc(t)), place = s.value(osc(x));
    if (!time || !place || *time > end) continue;
    chart.markers.push_back({.at = {*time, *place}, .label = letters, .meaning = Meaning::locus});
    all.push_back({{*time, *place}, osc(t), osc(x)});
  }
  return ChartPanel(chart, all);
}

Words law_in_words(const Rational& zeta) {
  if (zeta == 1) return decimal("$x$ = $v_{0}t$e$^{−αt}$");
  if (zeta < 1)
    return {"$x$ = ($v_{0}$/$b$)e$^{−αt}$sin $bt$, $b$ = $ω_{n}$√(1 − $ζ^{2}$)",
            "$x$ = ($v_{0}$/$b$)e$^{−αt}$sen $bt$, $b$ = $ω_{n}$√(1 − $ζ^{2}$)"};
  return decimal("$x$ = e$^{−αt}$($\\it{C}_{1}$e$^{βt}$ + $\\it{C}_{2}$e$^{−βt}$)");
}

// Straight lines through the origin, of which all points have one direction of motion.
std::vector<Line> isoclines_through_origin(const Ends& x, const Ends& y) {
  constexpr int how_many = 12;
  const double wide = std::max(-x.low, x.high), high = std::max(-y.low, y.high);
  std::vector<Line> all;
  for (int i = 0; i < how_many; ++i) {
    const double angle = M_PI * (i + 0.5) / how_many, dx = 2 * wide * std::cos(angle),
                 dy = 2 * high * std::sin(angle);
    Line line;
    constexpr int points = 60;
    for (int k = -points; k <= points; ++k) line.push_back({dx * k / points, dy * k / points});
    all.push_back(line);
  }
  return all;
}

PhasePlanePanel oscillator_plane(const Solution& s, Language language) {
  const Givens& givens = s.givens();
  const double zeta = nearest(givens["zeta"]), omega = geometry::to_double(givens.angle("omega_n")),
               end = 40 / omega * std::max(1.0, std::min(zeta, 10.0));
  const Line exact = in_phase_plane(oscillation(givens, end, 2 * smooth)),
             euler = in_phase_plane(euler_polygon(givens, std::min(end, 20.0)));
  Ends x = ends_of(exact, &Datum::x, 0.12), y = ends_of(exact, &Datum::y, 0.1);
  // Room on the other side of the axes, where the straight trajectories go on.
  const double wide = x.high - x.low, high = y.high - y.low;
  x = {std::min(x.low, -0.25 * wide), std::max(x.high, 0.25 * wide)};
  y = {std::min(y.low, -0.3 * high), std::max(y.high, 0.3 * high)};
  PhasePlane plane{.x = axis("$x$", "m", x), .y = axis("$x'$", "m/s", y), .motion = [=](const Datum& p) {
                     return Arrow2{p.y, -2 * zeta * omega * p.y - omega * omega * p.x};
                   }};
  plane.isoclines = isoclines_through_origin(x, y);
  const auto through_origin = [&](double slope) { return Line{{x.low, slope * x.low}, {x.high, slope * x.high}}; };
  for (const auto& [name, letters] :
       {std::pair("lambda_1", "$x'$ = $λ_{1}x$"), std::pair("lambda_2", "$x'$ = $λ_{2}x$")})
    if (const auto slope = s.value(osc(name)); slope && (givens["zeta"] != 1 || name == std::string("lambda_1")))
      plane.orbits.push_back(
          {.name = name,
           .label = letters,
           .runs = {through_origin(*slope)},
           .meaning = Meaning::second_locus,
           .line = name == std::string("lambda_1") ? drawings::LineType::dash_dotted : drawings::LineType::dashed});
  if (zeta > 0)
    plane.orbits.push_back({.name = "inflections",
                            .label = "$x''$ = 0",
                            .runs = {through_origin(-omega / (2 * zeta))},
                            .meaning = Meaning::acceleration,
                            .line = drawings::LineType::dashed});
  plane.orbits.push_back({.name = "orbit", .label = Words{"exact", "esatta"}.in(language), .runs = {exact}});
  plane.orbits.push_back({.name = "euler",
                          .label = Words{"Euler", "Eulero"}.in(language),
                          .runs = {euler},
                          .meaning = Meaning::velocity,
                          .points = euler.size() <= most_marked ? euler : Line{}});
  for (const char* name : {"1", "2", "5", "10", "20"}) {
    const auto place = s.value(osc(at("x", name))), rate = s.value(osc(at("x_dot", name)));
    if (!place || !rate || seconds(name) > end) continue;
    plane.read.push_back({{*place, *rate}, osc(at("x", name)), osc(at("x_dot", name))});
    plane.markers.push_back({.at = {*place, *rate}, .label = std::string(name) + " s", .meaning = Meaning::locus});
  }
  const auto x_f = s.value(osc("x_inflection")), v_f = s.value(osc("x_dot_min"));
  if (x_f && v_f) plane.read.push_back({{*x_f, *v_f}, osc("x_inflection"), osc("x_dot_min")});
  return PhasePlanePanel(plane);
}

}  // namespace

PanelSheet motion_sheet(const Solution& s, Language language) {
  const Words euler{
      "Euler's polygon goes on from each point along its own tangent for Δ$t$: $x_{i+1}$ = $x_{i}$ + $x'_{i}$Δ$t$, "
      "$x'_{i+1}$ = $x'_{i}$ + $x''_{i}$Δ$t$. $e$ = ($x_{E}$ − $x$)/$x$ at one instant.",
      "Il poligono di Eulero prosegue da ogni punto per Δ$t$ lungo la tangente: $x_{i+1}$ = $x_{i}$ + $x'_{i}$Δ$t$, "
      "$x'_{i+1}$ = $x'_{i}$ + $x''_{i}$Δ$t$. $e$ = ($x_{E}$ − $x$)/$x$ allo stesso istante."};
  return {
      .panels = panels(motion_chart(s, language)),
      .theory = {{{"Law of motion", "Legge del moto"},
                  {remark("$x''$ + 2$ζω_{n}x'$ + $ω_{n}^{2}x$ = 0; " + law_in_words(s.givens()["zeta"]).in(language)),
                   remark(euler.in(language))}}},
      .results = {values({osc("alpha"), osc("beta")}), values({osc("C_1"), osc("C_2")}),
                  values({osc("t_x_max"), osc("x_max")}), values({osc("t_inflection"), osc("x_inflection")}),
                  table({"$t$ (s)", "$x$ (m)", "$x_{E}$ (m)", "$e$"},
                        rows_of_oscillator({"x", "x_euler", "err_euler"}))},
      .seen = {"The position of the oscillator over time, exact and by Euler's method",
               "La posizione dell'oscillatore nel tempo, esatta e con il metodo di Eulero"},
      .told = {osc("x_max"), osc("t_x_max"), osc("x_at_5"), osc("x_euler_at_5")},
      .without_part = givens_of_pendulum};
}

PanelSheet phase_plane_sheet(const Solution& s, Language language) {
  const Words isoclines{
      "On a straight line through the origin all trajectories have one direction (strokes): d$x'$/d$x$ = −2$ζω_{n}$ "
      "− "
      "$ω_{n}^{2}x$/$x'$.",
      "Su una retta per l'origine tutte le traiettorie hanno una direzione (trattini): d$x'$/d$x$ = −2$ζω_{n}$ − "
      "$ω_{n}^{2}x$/$x'$."};
  const Words straight =
      s.givens()["zeta"] < 1
          ? Words{"$ζ$ < 1: no line is its own direction, so no trajectory is straight, and all wind round the origin.",
                  "$ζ$ < 1: nessuna retta coincide con la propria direzione, nessuna traiettoria è rettilinea, e tutte si "
                  "avvolgono sull'origine."}
          : Words{"Where the line has its own direction it is a trajectory: its slope is a root of the characteristic "
                  "equation. All others end in the origin along $x'$ = $λ_{1}x$.",
                  "Dove la retta coincide con la propria direzione è essa stessa una traiettoria: la pendenza è radice "
                  "dell'equazione caratteristica. Tutte le altre finiscono nell'origine lungo $x'$ = $λ_{1}x$."};
  return {
      .panels = panels(oscillator_plane(s, language)),
      .theory = {{{"The plane", "Il piano"}, {remark(isoclines.in(language)), remark(straight.in(language))}}},
      .results = {values({osc("lambda_1"), osc("lambda_2")}), values({osc("c"), osc("k"), osc("c_critical")}),
                  values({osc("x_max"), osc("x_inflection"), osc("x_dot_min")}),
                  values({osc("E_0"), osc("E_at_x_max")}),
                  table({"$t$ (s)", "$x'$ (m/s)", "$x'_{E}$ (m/s)"}, rows_of_oscillator({"x_dot", "x_dot_euler"}))},
      .seen = {"The phase plane of the oscillator with isoclines, straight trajectories and Euler's polygon",
               "Il piano delle fasi dell'oscillatore con isocline, traiettorie rettilinee e poligono di Eulero"},
      .told = {osc("x_max"), osc("x_dot_min"), osc("E_0"), osc("E_at_x_max")},
      .without_part = givens_of_pendulum};
}

}  // namespace epure::oscillator_pendulum
