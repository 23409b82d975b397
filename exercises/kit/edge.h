// Where a line leaves a room of the paper: for poles and centres too far away to be shown.
#pragma once

#include <algorithm>
#include <limits>

#include "exercises/kit/plot.h"

namespace epure {

// From X along the direction (not zero) as far as the room reaches.
inline Place at_edge(const Plot& plot, const drawings::Box& room, const Place& X, const Arrow2& direction) {
  const drawings::Point p = plot.at(X);
  double reach = std::numeric_limits<double>::infinity();  // in units of the direction
  if (direction.x != 0) reach = std::min(reach, ((direction.x > 0 ? room.high.x : room.low.x) - p.x) / direction.x);
  if (direction.y != 0) reach = std::min(reach, ((direction.y > 0 ? room.high.y : room.low.y) - p.y) / direction.y);
  return plot.from_paper({p.x + reach * direction.x, p.y + reach * direction.y});
}

}  // namespace epure
