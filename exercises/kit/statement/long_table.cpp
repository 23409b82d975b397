#include "exercises/kit/statement/long_table.h"

#include <fmt/format.h>

namespace epure {
namespace {

// In quotes where it holds what divides fields.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string csv(const LongTable& table) {
  std::string text;
  const auto record = [&](const auto& field_of) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += (i == 0 ? "" : ",") + field_of(table.columns[i]);
    text += "\r\n";
  };
  record([](const LongTable::Column& column) {
    return field(column.name + (column.unit == "1" ? "" : " (" + column.unit + ")"));
  });
  for (std::size_t row = 0; row < table.rows(); ++row)
    record([&](const LongTable::Column& column) {
      const double value = column.values[row];
      return fmt::format("{}", value == 0 ? 0.0 : value);
    });
  return text;
}

}  // namespace epure
