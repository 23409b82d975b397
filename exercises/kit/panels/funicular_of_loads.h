// The funicular polygon of a truss's loads that finds its reactions: chosen for the sheet, where it stands on the
// truss with its strings and beside it with pole and rays.
#pragma once

#include <vector>

#include "exercises/kit/panels/truss_figure.h"
#include "geometry/statics/support_polygon.h"

namespace epure {

// The loads in the order in which their lines follow each other, places in TrussFigure::outside, and their polygon
// with a pole from which the strings meet the lines of the loads well, clear of the truss.
struct FunicularOfLoads {
  std::vector<std::size_t> loads;
  geometry::SupportPolygon<double> polygon;
};
FunicularOfLoads funicular_of_loads(const TrussFigure& figure);

}  // namespace epure
