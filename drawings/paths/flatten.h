// What one needs to know of a path without drawing it: its box, its length, its course as short chords.
#pragma once

#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

// The box of end points and control points: contains the path, and equals its box for straight pieces.
Box bounds(const Path& path);
// As chords; curves leave their chord by at most about `tolerance` mm. A closed path ends where it starts.
std::vector<Point> flatten(const Path& path, double tolerance = 0.05);
double path_length(const Path& path);
// Without the points that the line through the others passes within `tolerance` mm: a curve that came as more chords
// than it needs.
std::vector<Point> thinned(const std::vector<Point>& points, double tolerance);

struct Halves {
  Piece first, second;
};
// De Casteljau at parameter t; `start` is where the curved piece begins.
Halves split(Point start, const Piece& piece, double t);

}  // namespace epure::drawings
