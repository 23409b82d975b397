#include "exercises/kit/statement/csv_field.h"

#include <fmt/format.h>

namespace epure {

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_field(double value) { return fmt::format("{}", value == 0 ? 0.0 : value); }

std::string csv_head(const std::string& name, const std::string& unit) {
  return csv_field(name + (unit == "1" ? "" : " (" + unit + ")"));
}

}  // namespace epure
