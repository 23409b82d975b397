// Points and vectors as they are drawn, in doubles: for pictures and the words beside them. What is reported is
// computed in the numbers of its construction.
#pragma once

#include <cmath>

#include "geometry/constructions/plane.h"

namespace epure {

using Place = geometry::Point<double>;  // metres, or the unit of the plane of vectors
using Arrow2 = geometry::Vector<double>;

inline double magnitude(const Arrow2& v) { return std::hypot(v.x, v.y); }
inline double distance(const Place& P, const Place& Q) { return std::hypot(Q.x - P.x, Q.y - P.y); }

// Of the way from P to Q: radians from +x, in [-π, π]. Zero when they are one place.
inline double direction(const Place& P, const Place& Q) { return std::atan2(Q.y - P.y, Q.x - P.x); }

}  // namespace epure
