// Every number is checked before it reaches a file: Cairo lets NaN and overflow pass and writes nonsense.
#pragma once

#include "drawings/page.h"

namespace epure::drawings {

// Farther out than this nothing is drawn; a mark that reaches there was not clipped, or is not in millimetres.
inline constexpr double farthest = 10'000;  // mm

// Throws std::invalid_argument naming the mark and the value.
void check(const Page& page);
// Plain text for titles and descriptions: UTF-8 without control characters.
void check_plain_text(const std::string& text, const char* what);

}  // namespace epure::drawings
