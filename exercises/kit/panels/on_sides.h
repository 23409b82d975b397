// Arrows of a polygon that would be drawn on its other sides.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "exercises/kit/panels/plot.h"

namespace epure {

// Whether an arrow, not of length 0, lies on one of these sides, or on a part of it.
inline bool lies_on_a_side(const Place& from, const Place& to, const std::vector<std::pair<Place, Place>>& sides) {
  constexpr double same = 1e-6;  // of the arrow: what no eye tells apart
  const Arrow2 along = to - from;
  const double length = magnitude(along);
  return std::any_of(sides.begin(), sides.end(), [&](const auto& side) {
    const auto off = [&](const Place& P) { return std::abs(cross(along, P - from)) / length; };
    const auto at = [&](const Place& P) { return dot(along, P - from) / length; };
    const auto [low, high] = std::minmax({at(side.first), at(side.second)});
    return off(side.first) < same * length && off(side.second) < same * length && high > 0 && low < length;
  });
}

}  // namespace epure
