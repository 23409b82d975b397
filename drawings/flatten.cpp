#include "drawings/flatten.h"

#include "drawings/vectors.h"

namespace epure::drawings {

Box bounds(const Path& path) {
  Box box = include(nothing(), path.start);
  for (const Piece& piece : path.pieces) {
    if (!piece.straight) box = include(include(box, piece.first_control), piece.second_control);
    box = include(box, piece.end);
  }
  return box;
}

Halves halve(Point start, const Piece& piece) {
  const Point a = between(start, piece.first_control, 0.5),
              b = between(piece.first_control, piece.second_control, 0.5),
              c = between(piece.second_control, piece.end, 0.5), ab = between(a, b, 0.5), bc = between(b, c, 0.5),
              centre = between(ab, bc, 0.5);
  return {{false, a, ab, centre}, {false, bc, c, piece.end}};
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

}  // namespace epure::drawings
