// What letters must keep clear of: the chords of everything drawn, in a uniform grid over the drawing area.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

// A straight stroke as labels see it. Heavy ones (links, vectors, symbols) are worse to cross than thin ones.
struct Obstacle {
  Point from, to;
  double half_width = 0;
  bool heavy = true;
  int step = 0;  // of the construction, which drew it; 0: it was there before
};

// Distance between a box and a segment; 0 when they meet.
double gap(Box box, Point from, Point to);
double gap(Box first, Box second);
// True only if `gap` is more than `reach`, which is not negative: a quick answer for most of what is farther off.
bool is_beyond(double reach, Box box, Point from, Point to);
// Length of the part of the segment inside the box.
double length_inside(Box box, Point from, Point to);

class Obstacles {
 public:
  explicit Obstacles(Box area);

  void add(const Obstacle& obstacle);
  // Calls `visit(obstacle)` once for each piece of an obstacle whose own box lies within `reach` of the box, until
  // it returns false.
  template <typename Visit>
  void near(Box box, double reach, Visit visit) const;

 private:
  struct Span {
    int low_x, high_x, low_y, high_y;
  };
  Span span(Box box) const;
  std::vector<std::uint32_t>& cell(int x, int y);
  const std::vector<std::uint32_t>& cell(int x, int y) const;

  static constexpr double cell_size = 5;  // mm: about the height of a label with air around it
  Box area_;
  int columns_, rows_;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::vector<Obstacle> pieces_;
  mutable std::vector<std::uint32_t> seen_;  // the last query that met the piece
  mutable std::uint32_t query_ = 0;
};

template <typename Visit>
void Obstacles::near(Box box, double reach, Visit visit) const {
  ++query_;
  const Box around{{box.low.x - reach, box.low.y - reach}, {box.high.x + reach, box.high.y + reach}};
  const Span s = span(around);
  for (int y = s.low_y; y <= s.high_y; ++y)
    for (int x = s.low_x; x <= s.high_x; ++x)
      for (const std::uint32_t index : cell(x, y)) {
        if (seen_[index] == query_) continue;
        seen_[index] = query_;
        const Obstacle& o = pieces_[index];
        if (std::max(o.from.x, o.to.x) < around.low.x || std::min(o.from.x, o.to.x) > around.high.x ||
            std::max(o.from.y, o.to.y) < around.low.y || std::min(o.from.y, o.to.y) > around.high.y)
          continue;
        if (!visit(o)) return;
      }
}

}  // namespace epure::drawings
