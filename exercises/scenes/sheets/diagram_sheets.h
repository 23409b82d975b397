// The velocities and the accelerations of all points of a scene, drawn on the mechanism.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/sheets/sheet_numbers.h"

namespace epure::scenes {

std::vector<SheetMaker> diagram_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers);

}  // namespace epure::scenes
