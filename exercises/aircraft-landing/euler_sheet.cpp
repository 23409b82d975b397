// Euler's polygons over the exact curves: the source's step overshoots all that there is to see.
#include <algorithm>
#include <cmath>
#include <utility>

#include "exercises/aircraft-landing/sheets.h"
#include "exercises/aircraft-landing/speeds.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::aircraft_landing {
namespace {

// As it stands, in doubles; nothing beyond `most` steps.
std::vector<std::vector<drawings::Datum>> euler_polygons(const Solution& s, double h, int most) {
  const geometry::analytic::SpinUp law = Landing(s.givens()).law();
  const double A = CGAL::to_double(law.A), B = CGAL::to_double(law.B), C = CGAL::to_double(law.C),
               D = CGAL::to_double(law.D), R = CGAL::to_double(law.R);
  double v = s["v_0"], omega = CGAL::to_double(law.omega_0);
  std::vector<drawings::Datum> aircraft{{0, v}}, rim{{0, R * omega}};
  for (int k = 1; k <= most; ++k) {
    const double square = v * v;
    v -= h * (A + B * square);
    omega += h * (C + D * square);
    aircraft.push_back({k * h, v});
    rim.push_back({k * h, R * omega});
    if (R * omega >= v) return {aircraft, rim};
  }
  return {};
}

void add_corners(drawings::Chart& chart, const std::vector<std::vector<drawings::Datum>>& polygons,
                 const std::string& name, const std::string& label) {
  std::vector<drawings::Datum> points;
  for (const auto& polygon : polygons)
    for (const drawings::Datum& corner : polygon)
      if (corner.y >= 0 && std::isfinite(corner.y)) points.push_back(corner);
  if (!points.empty())
    chart.curves.push_back({.name = name, .meaning = Meaning::force, .points = points, .label = label});
}

// Of corners too near to each other to be told apart: so many of them are enough.
void add_lines(drawings::Chart& chart, const std::vector<std::vector<drawings::Datum>>& polygons,
               const std::string& name, const std::string& label) {
  constexpr std::size_t enough = 200;
  drawings::Curve curve{.name = name, .meaning = Meaning::force, .label = label};
  for (const auto& polygon : polygons) {
    curve.runs.emplace_back();
    const std::size_t step = polygon.size() / enough + 1;
    for (std::size_t i = 0; i < polygon.size(); i += step) {
      if (polygon[i].y < 0 || !std::isfinite(polygon[i].y)) return;
      curve.runs.back().push_back(polygon[i]);
    }
    curve.runs.back().push_back(polygon.back());
  }
  if (!polygons.empty()) chart.curves.push_back(std::move(curve));
}

Result steps_to_end(const Solution& s, const std::string& step, const std::string& scheme) {
  const auto n = s.value(scheme + "steps");
  return remark(n ? step + ": $n$ = " + std::to_string(std::lround(*n)) : std::string{});
}

}  // namespace

PanelSheet euler_sheet(const Solution& s, Language language) {
  const double h = CGAL::to_double(s.givens()["Delta_t"]), t_s = s["t_s"], v_0 = s["v_0"];
  const double R = CGAL::to_double(s.givens()["R"]), v_1 = s["euler_100ms.v_1"], rim_1 = R * s["euler_100ms.omega_1"];
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
  add_corners(fine, euler_polygons(s, h / 100, 400), "euler_100", "Δ$t$/100");
  fine.verticals = {{.at = t_s, .label = "$t_{s}$"}};
  add_lines(fine, euler_polygons(s, h / 1000, 4000), "euler_1000", "Δ$t$/1000");
  const Words overshoot{
      "Above: after the source's first step of Δ$t$ the rim already runs $ω_{1}\\it{R}$/$v_{1}$ times as fast as the "
      "aircraft; slip had ended within the step. Below: with a hundredth of the step the corners lie on the curves "
      "as "
      "nearly as can be drawn, and with a thousandth the polygon itself covers them.",
      "Sopra: dopo il primo passo Δ$t$ della fonte la periferia va già $ω_{1}\\it{R}$/$v_{1}$ volte più veloce "
      "dell'aereo; lo strisciamento era finito dentro il passo. Sotto: con un centesimo del passo i vertici stanno "
      "sulle curve, per quanto si può disegnare, e con un millesimo il poligono stesso le ricopre."};
  return {
      .panels = panels(ChartPanel(coarse, read), ChartPanel(fine)),
      .results = {remark(overshoot.in(language)), values({"euler_100ms.v_1", "euler_100ms.omega_1"}),
                  values({"euler_100ms.rim_speed_over_speed_1"}), values({"t_s"}),
                  steps_to_end(s, "Δ$t$/100", "euler_1ms."), values({"euler_1ms.t_s"}),
                  steps_to_end(s, "Δ$t$/1000", "euler_100us."), values({"euler_100us.t_s"}),
                  values({"euler_1ms.v_20", "euler_1ms.omega_20"}),
                  values({"euler_100us.v_200", "euler_100us.omega_200"})},
      .seen = {"Euler's polygon of the source's step over the exact speeds, and those of a hundredth and a "
               "thousandth of it",
               "Il poligono di Eulero con il passo della fonte sulle velocità esatte, e quelli con un centesimo e "
               "un millesimo"},
      .told = {"euler_100ms.v_1", "euler_100ms.omega_1", "t_s", "euler_1ms.t_s", "euler_100us.t_s"},
      .without_part = {"f_a"}};
}

}  // namespace epure::aircraft_landing
