// The polygons of velocities and accelerations of a scene, a sheet a group of links.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/dyad_equations.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/sheets/sheet_numbers.h"

namespace epure::scenes {

// For the groups that the scene has at its stated givens. A group's sheet is named after its joint, where there are
// several: "velocity-polygon-B"; where several have that joint, with the links that it places:
// "velocity-polygon-B-4".
std::vector<SheetMaker> polygon_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers);

// The name of the sheet of one of these equations.
std::string name_of_polygon(const std::vector<DyadEquation>& equations, std::size_t which, bool is_of_velocities);

}  // namespace epure::scenes
