#include "exercises/kit/panels/named_curve.h"

#include <cmath>

#include "exercises/kit/panels/edge.h"

namespace epure {

std::optional<Place> middle_of(const geometry::Trace& trace, const Plot& plot, const drawings::Box& room) {
  std::optional<Place> best;
  double farthest = 0;
  const drawings::Point centre{(room.low.x + room.high.x) / 2, (room.low.y + room.high.y) / 2};
  const double limit = 0.42 * room.height();
  for (const geometry::Branch& branch : trace.branches) {
    for (const geometry::BezierArc& arc : branch.arcs) {
      const drawings::Point p = plot.at(arc.end);
      const double away = std::abs(p.y - centre.y);
      if (!is_in(room, plot, arc.end) || away > limit || away < farthest) continue;
      farthest = away;
      best = arc.end;
    }
  }
  return best;
}

}  // namespace epure
