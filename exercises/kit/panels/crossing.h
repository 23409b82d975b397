// How well two lines meet.
#pragma once

#include <cmath>

#include "exercises/kit/panels/plot.h"

namespace epure {

// The angle between two lines of these directions, 0 to pi/2: where it is small, the meeting is unsure. Neither is 0.
inline double crossing_angle(const Arrow2& one, const Arrow2& other) {
  return std::atan2(std::abs(cross(one, other)), std::abs(geometry::dot(one, other)));
}

}  // namespace epure
