#include "drawings/paths/grid.h"

#include <cmath>

namespace epure::drawings {

// Ties cannot matter: both neighbours are equally far.
double on_grid_in_points(double mm) {
  return std::floor(mm * points_per_mm * steps_per_point + 0.5) / steps_per_point;
}
double on_grid(double mm) { return on_grid_in_points(mm) / points_per_mm; }

Point as_filed(Point p, Paper) { return {on_grid(p.x), on_grid(p.y)}; }

}  // namespace epure::drawings
