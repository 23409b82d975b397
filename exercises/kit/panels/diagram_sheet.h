// A sheet with the mechanism and the polygons of its velocities or accelerations that take their directions from it:
// below it side by side, or beside it one below the other, whichever leaves them larger.
#pragma once

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {

struct DiagramSheet {
  const MechanismFigure& mechanism;
  std::vector<VectorPolygon> polygons;
  std::vector<std::string> results = {};  // a paragraph each
  std::optional<drawings::Table> table = {};
  Words description = {};
  std::vector<Value> values = {};
};

// The steps of all polygons are numbered through. Returns the plots of the polygons, to add to them.
std::vector<Plot> draw_diagram_sheet(DrawnSheet& onto, const DiagramSheet& shown, const SheetRequest& request);

}  // namespace epure
