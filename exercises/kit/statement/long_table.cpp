#include "exercises/kit/statement/long_table.h"

#include <fmt/format.h>

namespace epure {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_field(double value) { return fmt::format("{}", value == 0 ? 0.0 : value); }

std::string csv_head(const std::string& name, const std::string& unit) {
  return csv_field(name + (unit == "1" ? "" : " (" + unit + ")"));
}

std::string csv(const LongTable& table) {
  std::string text;
  const auto record = [&](const auto& field_of) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += (i == 0 ? "" : ",") + field_of(table.columns[i]);
    text += "\r\n";
  };
  record([](const LongTable::Column& column) { return csv_head(column.name, column.unit); });
  for (std::size_t row = 0; row < table.rows(); ++row)
    record([&](const LongTable::Column& column) { return csv_field(column.values[row]); });
  return text;
}

}  // namespace epure
