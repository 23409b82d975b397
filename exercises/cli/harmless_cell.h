// Cells of a CSV file that no spreadsheet runs (the OWASP rule).
#pragma once

#include <string>

namespace epure {

// A text that a spreadsheet would take for a formula, behind an apostrophe, which it takes for a mark of text.
inline std::string harmless_cell(const std::string& text) {
  const bool is_formula = !text.empty() && std::string("=+-@\t\r").find(text.front()) != std::string::npos;
  return is_formula ? "'" + text : text;
}

}  // namespace epure
