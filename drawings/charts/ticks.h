// Where an axis carries numbers, and what they say.
#pragma once

#include <string>
#include <vector>

#include "drawings/charts/chart.h"

namespace epure::drawings {

enum class Along { horizontal, vertical };

struct Tick {
  double value = 0;
  std::string text;  // rich text, in units of 10^power
};
struct Ticks {
  double low = 0, high = 1;  // the ends of the axis, moved outwards to numbers unless they are to stay
  int power = 0;
  std::vector<Tick> numbered;
  std::vector<double> between;  // short ticks without a number
};

// The finest numbering of an axis `length` mm long whose numbers keep a comfortable distance. The axis must be sound
// (require_sound).
Ticks ticks(const Axis& axis, double length, Along along, Language language);

// Throws std::invalid_argument, naming the axis, when its ends give no scale (see draw() in chart.h).
void require_sound(const Axis& axis);

// "ω₄ (10⁶ rad/s)", as rich text.
std::string title(const Axis& axis, int power = 0);

AxisMap axis_map(const Axis& axis, double low, double high, double from, double to);

inline constexpr double number_size = 2.7;  // mm

}  // namespace epure::drawings
