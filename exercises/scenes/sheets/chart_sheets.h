// Quantities over all places of the drive: the charts that a file asks for.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Throws BadScene where the file asks for what the mechanism has not (Scene::demand_charts).
std::vector<SheetMaker> chart_sheets(const std::shared_ptr<const Scene>& scene, const std::vector<Quantity>& known);

}  // namespace epure::scenes
