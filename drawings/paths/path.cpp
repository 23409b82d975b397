// Paths as exercises and symbols build them.
#include <stdexcept>

#include "drawings/paths/vectors.h"
#include "drawings/picture.h"

namespace epure::drawings {

Path segment(Point from, Point to) { return {from, {{true, {}, {}, to}}, false}; }

Path polyline(const std::vector<Point>& corners, bool closed) {
  if (corners.empty()) throw std::invalid_argument("a polyline without corners");
  Path path{corners.front(), {}, closed};
  for (std::size_t i = 1; i < corners.size(); ++i) path.pieces.push_back({true, {}, {}, corners[i]});
  return path;
}

Path arc(Point centre, double radius, double from, double to) {
  if (!std::isfinite(from) || !std::isfinite(to) || !(to > from))
    throw std::invalid_argument("an arc needs finite angles, the second greater than the first");
  if (!std::isfinite(radius) || radius < 0) throw std::invalid_argument("an arc needs a finite radius, not negative");
  constexpr double turn = 2 * std::numbers::pi;
  // The relative slack lets "from + 2π" computed in floating point still count as a full turn.
  const bool full = to - from >= turn * (1 - 1e-12);
  const double sweep = full ? turn : to - from;
  // Control points at 4/3 tan(step/4) of the radius along the tangents: off by 4.2e-6 of the radius at 45°, and by
  // 2.73e-4 at 90°, which a small circle's place in the file does not tell.
  const double longest_step = 2.73e-4 * radius <= file_resolution / 2 ? turn / 4 : turn / 8;
  const int count = std::max(1, static_cast<int>(std::ceil(sweep / longest_step - 1e-9)));
  const double step = sweep / count;
  const double reach = 4.0 / 3.0 * std::tan(step / 4) * radius;
  Path path{centre + radius * direction(from), {}, full};
  for (int i = 0; i < count; ++i) {
    const Point u = direction(from + i * step), v = direction(from + (i + 1) * step);
    const bool closes = full && i + 1 == count;
    const Point end = closes ? path.start : centre + radius * v;
    path.pieces.push_back({false, centre + radius * u + reach * left_of(u), end - reach * left_of(v), end});
  }
  return path;
}

Path circle(Point centre, double radius) { return arc(centre, radius, 0, 2 * std::numbers::pi); }

}  // namespace epure::drawings
