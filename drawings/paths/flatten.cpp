#include "drawings/paths/flatten.h"

#include "drawings/paths/vectors.h"

namespace epure::drawings {

Box bounds(const Path& path) {
  Box box = include(nothing(), path.start);
  for (const Piece& piece : path.pieces) {
    if (!piece.straight) box = include(include(box, piece.first_control), piece.second_control);
    box = include(box, piece.end);
  }
  return box;
}

Halves split(Point start, const Piece& piece, double t) {
  const Point a = between(start, piece.first_control, t), b = between(piece.first_control, piece.second_control, t),
              c = between(piece.second_control, piece.end, t), ab = between(a, b, t), bc = between(b, c, t),
              at = between(ab, bc, t);
  return {{false, a, ab, at}, {false, bc, c, piece.end}};
}

namespace {

// A chord over 1/n of the parameter is left by at most |f''|/(8 n²), and |f''| is at most 6 times the larger second
// difference of the control points. 256 steps keep far geometry cheap.
int steps_for(Point start, const Piece& piece, double tolerance) {
  const Point first = start - 2 * piece.first_control + piece.second_control;
  const Point second = piece.first_control - 2 * piece.second_control + piece.end;
  const double bend = std::max(length(first), length(second));
  return static_cast<int>(std::clamp(std::ceil(std::sqrt(0.75 * bend / tolerance)), 1.0, 256.0));
}

Point on_curve(Point start, const Piece& piece, double t) {
  const double s = 1 - t;
  return s * s * s * start + 3 * s * s * t * piece.first_control + 3 * s * t * t * piece.second_control +
         t * t * t * piece.end;
}

}  // namespace

std::vector<Point> flatten(const Path& path, double tolerance) {
  std::vector<Point> points{path.start};
  for (const Piece& piece : path.pieces) {
    const Point start = points.back();
    const int steps = piece.straight ? 1 : steps_for(start, piece, tolerance);
    for (int i = 1; i < steps; ++i) points.push_back(on_curve(start, piece, static_cast<double>(i) / steps));
    points.push_back(piece.end);
  }
  if (path.closed) points.push_back(path.start);
  return points;
}

double path_length(const Path& path) {
  const std::vector<Point> points = flatten(path);
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

namespace {

// From one point on: the directions of chords that pass within a tolerance of all points seen so far, each farther
// away than the last.
class Fan {
 public:
  Fan(Point from, double tolerance) : from_(from), tolerance_(tolerance) {}

  // Whether a chord may end here, over all points before.
  bool reaches(Point p) const {
    const Point way = p - from_;
    return length(way) >= farthest_ && (!is_bounded_ || (cross(right_, way) >= 0 && cross(way, left_) >= 0));
  }

  void see(Point p) {
    const Point way = p - from_;
    farthest_ = length(way);
    if (farthest_ <= tolerance_) return;
    // The tangents to the circle of the tolerance about p.
    const double sine = tolerance_ / farthest_, cosine = std::sqrt(1 - sine * sine);
    const Point left = cosine * way + sine * left_of(way), right = cosine * way - sine * left_of(way);
    if (!is_bounded_ || cross(left, left_) > 0) left_ = left;
    if (!is_bounded_ || cross(right_, right) > 0) right_ = right;
    is_bounded_ = true;
  }

 private:
  static double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

  Point from_, left_, right_;
  double tolerance_, farthest_ = 0;
  bool is_bounded_ = false;
};

}  // namespace

std::vector<Point> thinned(const std::vector<Point>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<Point> kept{points.front()};
  Fan fan(points.front(), tolerance);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    fan.see(points[i]);
    if (fan.reaches(points[i + 1])) continue;
    kept.push_back(points[i]);
    fan = Fan(points[i], tolerance);
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace epure::drawings
