// The one table from meaning to line type, width and colour (ISO 128, line group 0.5).
#pragma once

#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

struct LineStyle {
  double width = 0.25;              // mm
  std::vector<double> dashes = {};  // mm; empty: continuous
  Colour colour = {};
};

LineStyle line_style(Meaning meaning);
LineStyle line_style(Meaning meaning, LineType type);
Colour ink(Meaning meaning);   // letters, arrow heads and points of this meaning
Colour tint(Meaning meaning);  // the light fill of an area

// The ink that stands for one of these on a dark ground, as opaque; what is none of them stays as it is.
Colour light_ink(const Colour& ink);

// The pattern stretched a little, so that the line begins and ends with a full dash (a closed one meets itself
// between dashes); continuous when the line is too short to show its pattern.
std::vector<double> fitted_dashes(const std::vector<double>& pattern, double length, bool closed);

inline constexpr Colour black{0, 0, 0, 1};
inline constexpr Colour white{1, 1, 1, 1};
inline constexpr Colour grey{0.42, 0.42, 0.42, 1};
inline constexpr double wide = 0.5, medium = 0.35, narrow = 0.25, fine = 0.18;  // mm

}  // namespace epure::drawings
