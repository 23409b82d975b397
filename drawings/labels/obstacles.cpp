#include "drawings/labels/obstacles.h"

#include <array>

#include "drawings/paths/clip.h"
#include "drawings/paths/vectors.h"

namespace epure::drawings {

namespace {

double squared(Point a) { return dot(a, a); }

double squared_from_segment(Point p, Point from, Point to) { return squared(nearest_on(from, to, p) - p); }

}  // namespace

double gap(Box box, Point from, Point to) {
  if (clip_segment(from, to, box)) return 0;
  double least = std::min(squared(nearest_in(box, from) - from), squared(nearest_in(box, to) - to));
  const std::array corners{box.low, box.high, Point{box.low.x, box.high.y}, Point{box.high.x, box.low.y}};
  for (const Point corner : corners) least = std::min(least, squared_from_segment(corner, from, to));
  return std::sqrt(least);
}

bool is_beyond(double reach, Box box, Point from, Point to) {
  const Box around{{std::min(from.x, to.x), std::min(from.y, to.y)},
                   {std::max(from.x, to.x), std::max(from.y, to.y)}};
  if (apart(grown(box, reach), around)) return true;
  // Else from the segment's whole line: the box reaches towards it as far as two of its corners do.
  const Point normal = left_of(to - from);
  const double corner = (std::abs(normal.x) * box.width() + std::abs(normal.y) * box.height()) / 2;
  const double room = std::abs(dot(normal, middle(box) - from)) - corner;
  return room > 0 && room * room > reach * reach * squared(normal);
}

double gap(Box first, Box second) {
  const double x = std::max({first.low.x - second.high.x, second.low.x - first.high.x, 0.0});
  const double y = std::max({first.low.y - second.high.y, second.low.y - first.high.y, 0.0});
  return length({x, y});
}

double length_inside(Box box, Point from, Point to) {
  const auto inside = clip_segment(from, to, box);
  return inside ? distance(inside->first, inside->second) : 0;
}

Obstacles::Obstacles(Box area)
    : area_(area),
      columns_(static_cast<int>(area.width() / cell_size) + 1),
      rows_(static_cast<int>(area.height() / cell_size) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

Obstacles::Span Obstacles::span(Box box) const {
  const auto index = [](double offset, int count) {
    return static_cast<int>(std::clamp(std::floor(offset / cell_size), 0.0, count - 1.0));
  };
  return {index(box.low.x - area_.low.x, columns_), index(box.high.x - area_.low.x, columns_),
          index(box.low.y - area_.low.y, rows_), index(box.high.y - area_.low.y, rows_)};
}

std::vector<std::uint32_t>& Obstacles::cell(int x, int y) {
  return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
}
const std::vector<std::uint32_t>& Obstacles::cell(int x, int y) const {
  return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
}

void Obstacles::add(const Obstacle& obstacle) {
  const auto inside = clip_segment(obstacle.from, obstacle.to, area_);
  if (!inside) return;
  // Cut to the size of a cell, or a long diagonal would stand in every cell of its box.
  const auto count = static_cast<int>(std::ceil(distance(inside->first, inside->second) / cell_size)) + 1;
  for (int i = 0; i < count; ++i) {
    Obstacle piece = obstacle;
    piece.from = between(inside->first, inside->second, static_cast<double>(i) / count);
    piece.to = between(inside->first, inside->second, static_cast<double>(i + 1) / count);
    const auto number = static_cast<std::uint32_t>(pieces_.size());
    const Span s = span(include(include(nothing(), piece.from), piece.to));
    for (int y = s.low_y; y <= s.high_y; ++y)
      for (int x = s.low_x; x <= s.high_x; ++x) cell(x, y).push_back(number);
    pieces_.push_back(piece);
    seen_.push_back(0);
  }
}

}  // namespace epure::drawings
