#include "exercises/kit/panels/compare.h"

#include <cmath>

#include "exercises/kit/panels/sheet.h"

namespace epure {

Readings::Readings(const DrawnSheet& drawn) {
  for (const Measurement& m : drawn.measurements) shown_.emplace(m.quantity, measure(m, {}, drawn.sheet.paper));
}

bool Readings::is_unit(double length, const std::string& like) const {
  return std::abs(length) >= shown_.at(like).per_mm;
}

drawings::Table comparison_table(const std::vector<Comparison>& rows, const Words& first, const Words& second,
                                 Language language) {
  constexpr int read = 3;  // figures: of 50 to 150 mm a ruler tells half a millimetre
  drawings::Table table{{"", first.in(language), second.in(language), "Δ %"}, {}};
  for (const Comparison& row : rows) {
    const double difference = row.first == 0 ? 0 : 100 * std::abs(row.second - row.first) / std::abs(row.first);
    table.rows.push_back({row.quantity, figures(row.first, read, language), figures(row.second, read, language),
                          percent(difference, language)});
  }
  return table;
}

}  // namespace epure
