#include "exercises/kit/panels/compare.h"

#include <cmath>

#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

double as_read(double x, int figures) {
  if (x == 0) return 0;
  const double last = std::pow(10, std::floor(std::log10(std::abs(x))) + 1 - figures);
  return last * std::round(x / last);
}

}  // namespace

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
    const double one = as_read(row.first, read), other = as_read(row.second, read);  // or Δ contradicts them
    const double difference = one == 0 ? 0 : 100 * std::abs(other - one) / std::abs(one);
    table.rows.push_back({row.quantity, figures(row.first, read, language), figures(row.second, read, language),
                          percent(difference, language)});
  }
  return table;
}

}  // namespace epure
