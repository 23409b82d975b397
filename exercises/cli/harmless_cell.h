// Cells of a CSV file that no spreadsheet runs (the OWASP rule).
#pragma once

#include <string>
#include <string_view>

namespace epure {

inline bool looks_like_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
}

// A text that a spreadsheet would take for a formula, behind an apostrophe, which it takes for a mark of text.
inline std::string harmless_cell(const std::string& text) { return looks_like_formula(text) ? "'" + text : text; }

// A given as it is typed: "-0,25" is a number to a spreadsheet, "-82,5deg" and "-1/3" are not.
inline std::string harmless_given(const std::string& typed) {
  return typed.find_first_not_of("+-0123456789.,eE") == std::string::npos ? typed : harmless_cell(typed);
}

// The text again.
inline std::string text_of_cell(const std::string& cell) {
  return cell.starts_with('\'') && looks_like_formula(std::string_view(cell).substr(1)) ? cell.substr(1) : cell;
}

}  // namespace epure
