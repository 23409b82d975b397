// The grid both files keep positions on: 1/256 pt, anchored in the lower left corner of the paper. We round to it
// ourselves, so that Cairo, which rounds to the same step, changes nothing, and PDF, SVG, and a page cropped out of
// a sheet all hold the very same lengths.
#pragma once

#include "drawings/picture.h"

namespace epure::drawings {

inline constexpr double points_per_mm = 72 / 25.4;

double on_grid_in_points(double mm);
double on_grid(double mm);

}  // namespace epure::drawings
