// A vector polygon as a sequence of pictures, a step a picture, all at one scale, beside the mechanism that gives the
// directions.
#pragma once

#include <vector>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/polygon_picture.h"

namespace epure::rivals_polygons {

struct Picture {
  PolygonStage stage;
  Words caption;
};

// Each known vector; then the lines of the unknown ones; then the polygon closed. `figures` are the numbers that the
// last pictures have in the source.
std::vector<Picture> pictures_of(const VectorPolygon& polygon, const std::vector<int>& figures);

// Draws mechanism and pictures where they come out largest. Returns the scales of lengths and vectors, for the bars.
// Throws BadGivens when a requested scale of lengths does not fit.
std::vector<Scale> draw_pictures(DrawnSheet& onto, const MechanismFigure& mechanism, const VectorPolygon& polygon,
                                 const std::vector<Picture>& pictures, const SheetRequest& request);

}  // namespace epure::rivals_polygons
