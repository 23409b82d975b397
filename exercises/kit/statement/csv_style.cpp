#include "exercises/kit/statement/csv_style.h"

#include <fmt/format.h>

#include <algorithm>

namespace epure {

std::string CsvStyle::field(std::string_view text) const {
  if (text.find_first_of(is_for_spreadsheet ? ";\"\r\n" : ",\"\r\n") == std::string_view::npos)
    return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string CsvStyle::typed(std::string number) const {
  if (is_for_spreadsheet) std::replace(number.begin(), number.end(), '.', ',');
  return number;
}

std::string CsvStyle::number(double value) const { return typed(fmt::format("{}", value == 0 ? 0.0 : value)); }

std::string CsvStyle::head(const std::string& name, const std::string& unit) const {
  return field(name + (unit == "1" ? "" : " (" + unit + ")"));
}

std::string CsvStyle::record(const std::vector<std::string>& fields) const {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) line += (i == 0 ? "" : is_for_spreadsheet ? ";" : ",") + fields[i];
  return line + "\r\n";
}

std::string csv(const LongTable& table, const CsvStyle& style) {
  std::vector<std::string> fields;
  for (const LongTable::Column& column : table.columns) fields.push_back(style.head(column.name, column.unit));
  std::string text = std::string(style.begin()) + style.record(fields);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    fields.clear();
    for (const LongTable::Column& column : table.columns) fields.push_back(style.number(column.values[row]));
    text += style.record(fields);
  }
  return text;
}

}  // namespace epure
