// Quantities that a sheet tells, so many on a line.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::scenes {

inline void add_in_lines(PanelSheet& sheet, const std::vector<std::string>& names, std::ptrdiff_t in_a_line) {
  for (auto from = names.begin(); from != names.end(); from += std::min(in_a_line, names.end() - from))
    sheet.results.push_back(values({from, from + std::min(in_a_line, names.end() - from)}));
}

// By which sense ω and α are positive.
inline const Words positive_rates{"Positive: counter-clockwise.", "Positivo: il verso antiorario."};

}  // namespace epure::scenes
