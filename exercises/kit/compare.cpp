#include "exercises/kit/compare.h"

#include <cmath>

#include "exercises/kit/sheet.h"

namespace epure {

double as_measured(const Measurement& measurement, drawings::Paper paper) {
  const drawings::Point from = drawings::as_filed(measurement.from, paper);
  const drawings::Point to = drawings::as_filed(measurement.to, paper);
  switch (measurement.kind) {
    case Measurement::along_x: return (to.x - from.x) * measurement.per_mm;
    case Measurement::along_y: return (to.y - from.y) * measurement.per_mm;
    case Measurement::length: break;
  }
  return std::hypot(to.x - from.x, to.y - from.y) * measurement.per_mm;
}

Readings::Readings(const DrawnSheet& drawn) {
  for (const Measurement& m : drawn.measurements) values_.emplace(m.quantity, as_measured(m, drawn.sheet.paper));
}

drawings::Table comparison_table(const std::vector<Comparison>& rows, const Words& first, const Words& second,
                                 Language language) {
  drawings::Table table{{"", first.in(language), second.in(language), "Δ %"}, {}};
  for (const Comparison& row : rows) {
    const double percent = row.first == 0 ? 0 : 100 * std::abs(row.second - row.first) / std::abs(row.first);
    table.rows.push_back({row.quantity, figures(row.first, 5, language), figures(row.second, 5, language),
                          percent == 0 ? "0" : figures(percent, 1, language)});
  }
  return table;
}

}  // namespace epure
