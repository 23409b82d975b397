#include "exercises/kit/statement/long_table.h"

#include <fmt/format.h>

#include "exercises/kit/statement/csv_field.h"

namespace epure {
std::string csv(const LongTable& table) {
  std::string text;
  const auto record = [&](const auto& field_of) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += (i == 0 ? "" : ",") + field_of(table.columns[i]);
    text += "\r\n";
  };
  record([](const LongTable::Column& column) {
    return csv_field(column.name + (column.unit == "1" ? "" : " (" + column.unit + ")"));
  });
  for (std::size_t row = 0; row < table.rows(); ++row)
    record([&](const LongTable::Column& column) {
      const double value = column.values[row];
      return fmt::format("{}", value == 0 ? 0.0 : value);
    });
  return text;
}

}  // namespace epure
