#include "exercises/oscillator-pendulum/charts.h"

#include <algorithm>

#include "exercises/kit/statement/decimal.h"
#include "exercises/oscillator-pendulum/quantities.h"

namespace epure::oscillator_pendulum {

std::string at(const std::string& of, const std::string& instant) { return of + "_at_" + instant; }

Line over_time(const std::vector<Moving>& all) {
  Line line;
  for (const Moving& each : all) line.push_back({each.t, each.position});
  return line;
}
Line in_phase_plane(const std::vector<Moving>& all) {
  Line line;
  for (const Moving& each : all) line.push_back({each.position, each.rate});
  return line;
}

Ends ends_of(const Line& line, double Datum::*along, double air) {
  double low = 0, high = 0;
  for (const Datum& each : line) low = std::min(low, each.*along), high = std::max(high, each.*along);
  const double more = air * (high - low);
  return {low < 0 ? low - more : low, high > 0 ? high + more : high};
}
drawings::Axis axis(const std::string& quantity, const std::string& unit, const Ends& ends) {
  drawings::Axis axis{.quantity = quantity, .unit = unit, .low = ends.low, .high = ends.high};
  axis.to_ticks = false;
  return axis;
}

void read(std::vector<ChartPanel::Read>& onto, const Solution& s, double x, const std::string& along_x,
          const std::string& along_y) {
  if (const auto y = s.value(along_y)) onto.push_back({{x, *y}, along_x, along_y});
}
double seconds(const std::string& name) { return nearest(instant(name)); }

std::string in_milliseconds(const std::string& name) { return geometry::to_text(instant(name) * 1000); }
std::vector<Row> rows(const std::vector<std::string>& instants_told, int units_of_a_second,
                      const std::string& case_name, const std::vector<std::string>& columns) {
  std::vector<Row> all;
  for (const std::string& name : instants_told) {
    std::vector<std::string> names;
    for (const std::string& column : columns) names.push_back(case_name + at(column, name));
    all.push_back({geometry::to_text(instant(name) * units_of_a_second), names, "–"});
  }
  return all;
}
std::vector<Row> rows_of_pendulum(const std::vector<std::string>& columns) {
  return rows({"0p1", "0p2", "0p3", "0p4", "0p5", "0p6", "0p7", "0p8", "0p9", "1"}, 1000, "pendulum.", columns);
}

std::string pen(const std::string& name) { return "pendulum." + name; }
std::vector<std::string> all_pen(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(pen(name));
  return all;
}

}  // namespace epure::oscillator_pendulum
