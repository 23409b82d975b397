// Lines of nearly one length.
#pragma once

#include <utility>

namespace epure::drawings {

// `fill(width)` breaks into lines that are no wider where possible, `widest(lines)` measures them: here made narrower
// for as long as that adds no line. `room` and widths in mm.
template <class Fill, class Widest>
auto in_even_lines(double room, Fill fill, Widest widest) {
  constexpr double narrower = 0.5;  // mm
  auto best = fill(room);
  while (best.size() > 1) {
    auto lines = fill(widest(best) - narrower);
    if (lines.size() > best.size() || widest(lines) >= widest(best)) break;
    best = std::move(lines);
  }
  return best;
}

}  // namespace epure::drawings
