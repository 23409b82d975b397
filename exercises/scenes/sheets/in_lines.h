// Quantities that a sheet tells, so many on a line, and from where and which way they count.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

inline void add_in_lines(PanelSheet& sheet, const std::vector<std::string>& names, std::ptrdiff_t in_a_line) {
  for (auto from = names.begin(); from != names.end(); from += std::min(in_a_line, names.end() - from))
    sheet.results.push_back(values({from, from + std::min(in_a_line, names.end() - from)}));
}

// By which sense ω and α are positive.
inline const Words positive_rates{"Positive: counter-clockwise.", "Positivo: il verso antiorario."};

// From where coordinates count, if a point of the frame is there: the head of the column of what they are of. (Where
// none is, the figure shows the axes.)
inline std::string from_origin(const Built& built, Language language) {
  const int origin = point_at(built, 0, {0, 0});
  if (origin == geometry::nothing) return {};
  return Words{"from ", "da "}.in(language) + "$" + point_letters(built.letters.points[index(origin)]) + "$";
}

}  // namespace epure::scenes
