// The points of links that have no acceleration now, each found by two rays.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Of links that no joint pins to the frame, with two points that move; some on a sheet.
std::vector<SheetMaker> acceleration_pole_sheets(const std::shared_ptr<const Scene>& scene);

}  // namespace epure::scenes
