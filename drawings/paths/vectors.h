// Plane vectors in millimetres, for drawing only.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawings/picture.h"

namespace epure::drawings {

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
// Paper coordinates stay within 10,000 km, so the squares neither overflow nor need std::hypot, which is ten times
// slower.
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline double distance(Point a, Point b) { return length(b - a); }
inline Point direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline double angle_of(Point a) { return std::atan2(a.y, a.x); }
// A quarter turn counter-clockwise: the left side of a direction.
inline Point left_of(Point a) { return {-a.y, a.x}; }
inline Point between(Point a, Point b, double t) { return a + t * (b - a); }
// The unit vector from a to b; zero when they coincide, which the caller must exclude or tolerate.
inline Point unit(Point a, Point b) {
  const double d = distance(a, b);
  return d > 0 ? (1 / d) * (b - a) : Point{};
}

// The point of the segment from-to that is nearest to p.
inline Point nearest_on(Point from, Point to, Point p) {
  const Point way = to - from;
  const double square = dot(way, way);
  return between(from, to, square > 0 ? std::clamp(dot(p - from, way) / square, 0.0, 1.0) : 0);
}

inline Box grown(Box b, double by) { return {{b.low.x - by, b.low.y - by}, {b.high.x + by, b.high.y + by}}; }
inline bool contains(Box b, Point p) {
  return p.x >= b.low.x && p.x <= b.high.x && p.y >= b.low.y && p.y <= b.high.y;
}
inline bool contains(Box outer, Box inner) { return contains(outer, inner.low) && contains(outer, inner.high); }
inline bool apart(Box a, Box b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y;
}
inline Point middle(Box b) { return between(b.low, b.high, 0.5); }
inline Point nearest_in(Box b, Point p) {
  return {std::clamp(p.x, b.low.x, b.high.x), std::clamp(p.y, b.low.y, b.high.y)};
}
// A box that holds nothing yet: grows with `include`.
inline Box nothing() { return {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}}; }
inline bool is_nothing(Box b) { return b.low.x > b.high.x || b.low.y > b.high.y; }
inline Box include(Box b, Point p) {
  return {{std::min(b.low.x, p.x), std::min(b.low.y, p.y)}, {std::max(b.high.x, p.x), std::max(b.high.y, p.y)}};
}
inline Box include(Box a, Box b) { return is_nothing(b) ? a : include(include(a, b.low), b.high); }
inline Box intersection(Box a, Box b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

}  // namespace epure::drawings
