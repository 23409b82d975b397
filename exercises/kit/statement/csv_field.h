// A field of a CSV file, as RFC 4180 has it.
#pragma once

#include <string>
#include <string_view>

namespace epure {

// In quotes where it holds what divides fields or records.
inline std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace epure
