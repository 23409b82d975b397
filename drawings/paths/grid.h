// The grid both files keep positions on: 1/256 pt, anchored in the lower left corner of the paper. We round to it
// ourselves, so that Cairo, which rounds to the same step, changes nothing, and PDF, SVG, and a page cropped out of
// a sheet all hold the very same lengths.
#pragma once

#include "drawings/picture.h"

namespace epure::drawings {

inline constexpr double points_per_mm = 72 / 25.4;
inline constexpr double steps_per_point = 256;

double on_grid_in_points(double mm);
double on_grid(double mm);

// From the paper to the coordinates of a page in a file: points, y downwards, origin in the upper left corner. The
// corner is moved to the grid, by at most half a step, so that rounding does not depend on which part is shown.
class Frame {
 public:
  explicit Frame(const Box& extent)
      : left_(on_grid_in_points(extent.low.x)), top_(on_grid_in_points(extent.high.y)) {}

  Point rounded(Point p) const { return {on_grid_in_points(p.x) - left_, top_ - on_grid_in_points(p.y)}; }
  Point unrounded(Point p) const { return {p.x * points_per_mm - left_, top_ - p.y * points_per_mm}; }

 private:
  double left_, top_;
};

}  // namespace epure::drawings
