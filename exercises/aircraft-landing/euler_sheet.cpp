// Euler's polygons over the exact curves: the source's step overshoots all that there is to see.
#include <algorithm>
#include <cmath>
#include <utility>

#include "exercises/aircraft-landing/sheets.h"
#include "exercises/aircraft-landing/speeds.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/statement/format_words.h"

namespace epure::aircraft_landing {
namespace {

using Polygons = std::vector<std::vector<drawings::Datum>>;  // of the aircraft and of the rim

// As it stands, in doubles; none where the scheme is not carried out.
Polygons euler_polygons(const Solution& s, double h, const std::string& scheme) {
  const auto steps = s.value(scheme + "steps");
  if (!steps) return {};
  const geometry::analytic::SpinUp law = Landing(s.givens()).law();
  const double A = CGAL::to_double(law.A), B = CGAL::to_double(law.B), C = CGAL::to_double(law.C),
               D = CGAL::to_double(law.D), R = CGAL::to_double(law.R);
  double v = s["v_0"], omega = CGAL::to_double(law.omega_0);
  std::vector<drawings::Datum> aircraft{{0, v}}, rim{{0, R * omega}};
  for (long k = 1; k <= std::lround(*steps); ++k) {
    const double square = v * v;
    v -= h * (A + B * square);
    omega += h * (C + D * square);
    aircraft.push_back({static_cast<double>(k) * h, v});
    rim.push_back({static_cast<double>(k) * h, R * omega});
  }
  return {aircraft, rim};
}

// One corner in so many is enough to see where they lie, or how the polygon runs.
std::size_t one_in(const Polygons& polygons, std::size_t enough) { return polygons.front().size() / enough + 1; }
std::vector<drawings::Datum> thinned(const std::vector<drawings::Datum>& polygon, std::size_t every) {
  std::vector<drawings::Datum> some;
  for (std::size_t i = 0; i < polygon.size(); i += every) some.push_back(polygon[i]);
  return some;
}
constexpr std::size_t corners_enough = 40, lines_enough = 200;

void add_corners(drawings::Chart& chart, const Polygons& polygons, const std::string& name,
                 const std::string& label) {
  std::vector<drawings::Datum> points;
  for (const auto& polygon : polygons)
    for (const drawings::Datum& corner : thinned(polygon, one_in(polygons, corners_enough)))
      if (corner.y >= 0) points.push_back(corner);
  if (!points.empty())
    chart.curves.push_back({.name = name, .meaning = Meaning::force, .points = points, .label = label});
}

void add_lines(drawings::Chart& chart, const Polygons& polygons, const std::string& name, const std::string& label) {
  if (polygons.empty()) return;
  drawings::Curve curve{.name = name, .meaning = Meaning::force, .label = label};
  for (const auto& polygon : polygons) {
    curve.runs.push_back(thinned(polygon, one_in(polygons, lines_enough)));
    curve.runs.back().push_back(polygon.back());
  }
  chart.curves.push_back(std::move(curve));
}

// Above: how far the first step of Δt leads, and whether slip lasts that long.
Words of_first_step(const Solution& s, double h, double v_1, double rim_1) {
  const Words first{"Above: after the first step of Δ$t$ ", "Sopra: dopo il primo passo Δ$t$ "},
      stands{"the aircraft would no longer go ahead", "l'aereo non andrebbe più avanti"},
      ahead{"the rim already runs $ω_{1}\\it{R}$/$v_{1}$ times as fast as the aircraft",
            "la periferia va già $ω_{1}\\it{R}$/$v_{1}$ volte più veloce dell'aereo"},
      behind{"the rim runs at $ω_{1}\\it{R}$/$v_{1}$ of the aircraft's speed",
             "la periferia va a $ω_{1}\\it{R}$/$v_{1}$ della velocità dell'aereo"},
      over{"; slip had ended within the step. ", "; lo strisciamento era finito dentro il passo. "},
      goes_on{"; slip ends later. ", "; lo strisciamento finisce dopo. "};
  return first + (v_1 <= 0 ? stands : rim_1 >= v_1 ? ahead : behind) + (s["t_s"] <= h ? over : goes_on);
}

// Below: what is drawn of a scheme.
Words of_scheme(const std::string& step, const Polygons& polygons, const Words& drawn) {
  return Words{step, step} +
         (polygons.empty() ? Words{": more than 20000 steps, not carried out. ", ": più di 20000 passi, non svolto. "}
                           : drawn);
}

std::string with_steps(const Solution& s, const std::string& step, const std::string& scheme) {
  const auto n = s.value(scheme + "steps");
  return n ? step + ", $n$ = " + std::to_string(std::lround(*n)) : step;
}

}  // namespace

PanelSheet euler_sheet(const Solution& s, Language language) {
  const double h = CGAL::to_double(s.givens()["Delta_t"]), t_s = s["t_s"], v_0 = s["v_0"];
  const double R = CGAL::to_double(s.givens()["R"]), v_1 = s["euler_100ms.v_1"], rim_1 = R * s["euler_100ms.omega_1"];
  constexpr int figures_told = 6;  // fewer do not tell the three times apart
  const double least = std::min(0.0, v_1), most = std::max({v_0, rim_1, v_1}), air = 0.08 * (most - least);
  drawings::Chart coarse = chart_of_speeds(s, 1.1 * std::max(h, t_s), least < 0 ? least - air : 0, most + air);
  coarse.curves.push_back({.name = "euler",
                           .runs = {{{0, v_0}, {h, v_1}}, {{0, CGAL::to_double(s.givens()["rim_0"])}, {h, rim_1}}},
                           .meaning = Meaning::force,
                           .points = {{h, v_1}, {h, rim_1}},
                           .label = "Δ$t$"});
  coarse.verticals = {{.at = t_s, .label = "$t_{s}$"}};
  const std::vector<ChartPanel::Read> read{{{h, v_1}, {}, "euler_100ms.v_1"},
                                           {{h, rim_1}, {}, "euler_100ms.omega_1", 1, 1 / R}};
  constexpr double past_the_end = 1.15;
  drawings::Chart fine = chart_of_speeds(s, past_the_end * t_s, 0, 1.1 * v_0);
  const Polygons hundredth = euler_polygons(s, h / 100, "euler_1ms."),
                 thousandth = euler_polygons(s, h / 1000, "euler_100us.");
  add_corners(fine, hundredth, "euler_100", "Δ$t$/100");
  fine.verticals = {{.at = t_s, .label = "$t_{s}$"}};
  add_lines(fine, thousandth, "euler_1000", "Δ$t$/1000");
  const std::size_t every = hundredth.empty() ? 1 : one_in(hundredth, corners_enough);
  const Words corners = every == 1 ? Words{": the corners. ", ": i vertici. "}
                                   : format_words(": one corner in {}. ", ": un vertice su {}. ", every);
  const Words seen = of_first_step(s, h, v_1, rim_1) +
                     Words{"Below, over the exact curves, Δ$t$/100", "Sotto, sulle curve esatte, Δ$t$/100"} +
                     of_scheme("", hundredth, corners) +
                     of_scheme("Δ$t$/1000", thousandth, {": the polygon.", ": il poligono."});
  const Words scheme{
      "$v_{i+1}$ = $v_{i}$ − ($\\it{A}$ + $\\it{B}v_{i}^{2}$)Δ$t$, $ω_{i+1}$ = $ω_{i}$ + ($\\it{C}$ + "
      "$\\it{D}v_{i}^{2}$)Δ$t$, with the $\\it{A}$ … $\\it{D}$ of the closed form, until $ω\\it{R}$ ≥ $v$: $n$ "
      "steps.",
      "$v_{i+1}$ = $v_{i}$ − ($\\it{A}$ + $\\it{B}v_{i}^{2}$)Δ$t$, $ω_{i+1}$ = $ω_{i}$ + ($\\it{C}$ + "
      "$\\it{D}v_{i}^{2}$)Δ$t$, con le $\\it{A}$ … $\\it{D}$ della forma chiusa, finché $ω\\it{R}$ ≥ $v$: $n$ "
      "passi."};
  return {
      .panels = panels(ChartPanel(coarse, read), ChartPanel(fine)),
      .theory = {{{"The scheme", "Lo schema"}, {remark(scheme.in(language)), remark(seen.in(language))}}},
      .results = {values({"euler_100ms.v_1", "euler_100ms.omega_1"}), values({"euler_100ms.rim_speed_over_speed_1"}),
                  table({"", "$t_{s}$ (s)"},
                        {{Words{"exact", "esatto"}.in(language), {"t_s"}},
                         {with_steps(s, "Δ$t$/100", "euler_1ms."), {"euler_1ms.t_s"}, "–"},
                         {with_steps(s, "Δ$t$/1000", "euler_100us."), {"euler_100us.t_s"}, "–"}},
                        figures_told),
                  values({"euler_1ms.v_20", "euler_1ms.omega_20"}),
                  values({"euler_100us.v_200", "euler_100us.omega_200"})},
      .seen = {"Euler's polygon of the source's step over the exact speeds, and those of a hundredth and a "
               "thousandth of it",
               "Il poligono di Eulero con il passo della fonte sulle velocità esatte, e quelli con un centesimo "
               "e un millesimo"},
      .told = {"euler_100ms.v_1", "euler_100ms.omega_1", "t_s", "euler_1ms.t_s", "euler_100us.t_s"},
      .without_part = {"f_a"}};
}

}  // namespace epure::aircraft_landing
