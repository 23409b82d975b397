// The forces of a scene under loads: the whole mechanism, and group after group the links cut free with their
// polygons.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/sheets/sheet_numbers.h"

namespace epure::scenes {

// For the groups that the scene has at its stated givens: "forces", then "forces-5-6" of links 5 and 6, to "forces-2"
// of the crank. None where no forces are asked for.
std::vector<SheetMaker> force_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers);

}  // namespace epure::scenes
