#include "drawings/sheet/galley.h"

#include <algorithm>

#include "drawings/text/text.h"

namespace epure::drawings {

void Galley::lines(const std::vector<std::string>& lines, double left, Weight weight) {
  for (const std::string& line : lines) {
    const TextSize extent = measure(line, size(), weight);
    const double above = std::max(0.0, extent.ascent - 0.78 * size());
    const double below = std::max(0.0, extent.descent - 0.3 * size());
    down(above);
    text(line, {left, baseline()}, size(), weight);
    down(leading() + below);
  }
}

}  // namespace epure::drawings
