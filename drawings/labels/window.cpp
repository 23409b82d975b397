#include "drawings/labels/window.h"

#include <fmt/format.h>

#include <stdexcept>

#include "drawings/paths/vectors.h"

namespace epure::drawings {

Box window_of(const Figure& figure, std::size_t mark, Box area) {
  if (mark >= figure.window_of.size() || figure.window_of[mark] < 0) return area;
  const auto window = static_cast<std::size_t>(figure.window_of[mark]);
  if (window >= figure.windows.size()) return area;
  const Box box = intersection(figure.windows[window], area);
  if (is_nothing(box)) throw std::invalid_argument(fmt::format("window {} lies outside the drawing area", window));
  return box;
}

}  // namespace epure::drawings
