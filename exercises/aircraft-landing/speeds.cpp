#include "exercises/aircraft-landing/speeds.h"

#include "geometry/numbers/accurate.h"

namespace epure::aircraft_landing {

std::vector<SpeedsAt> speeds_until_slip_ends(const Solution& s, int steps) {
  constexpr long bits = 256;
  const geometry::Arithmetic<geometry::Deep> scope(bits);
  const geometry::analytic::SpinUp law = Landing(s.givens()).law();
  const double end = s["t_s"], R = CGAL::to_double(law.R);
  const auto v_0 = geometry::from_rational<geometry::Deep>(law.v_0);
  std::vector<SpeedsAt> all;
  for (int i = 0; i <= steps; ++i) {
    const double t = end * i / steps;
    const auto now = spun_up(law, geometry::Deep::from_double(t));
    all.push_back({t, enclosure(now.v).value, R * enclosure(now.omega).value, enclosure(v_0 - now.v).value});
  }
  return all;
}

std::vector<drawings::Datum> of_aircraft(const std::vector<SpeedsAt>& all) {
  std::vector<drawings::Datum> points;
  for (const SpeedsAt& each : all) points.push_back({each.t, each.v});
  return points;
}
std::vector<drawings::Datum> of_rim(const std::vector<SpeedsAt>& all) {
  std::vector<drawings::Datum> points;
  for (const SpeedsAt& each : all) points.push_back({each.t, each.rim});
  return points;
}

drawings::Chart chart_of_speeds(const Solution& s, double last, double low, double high) {
  constexpr int steps = 200;
  const auto all = speeds_until_slip_ends(s, steps);
  const double t_s = s["t_s"], v_s = s["v_s"];
  drawings::Chart chart;
  chart.x = {.quantity = "$t$", .unit = "s", .low = 0, .high = last};
  chart.y = {.quantity = "$v$, $ω\\it{R}$", .unit = "m/s", .low = low, .high = high};
  chart.curves = {{.name = "v", .runs = {of_aircraft(all)}, .meaning = Meaning::velocity, .label = "$v$"},
                  {.name = "rim",
                   .runs = {of_rim(all)},
                   .meaning = Meaning::locus,
                   .line = drawings::LineType::continuous,
                   .label = "$ω\\it{R}$"}};
  if (last > t_s)
    chart.curves.push_back({.name = "rolling",
                            .runs = {{{t_s, v_s}, {last, v_s + s["a_after"] * (last - t_s)}}},
                            .meaning = Meaning::velocity,
                            .line = drawings::LineType::continuous});
  return chart;
}

}  // namespace epure::aircraft_landing
