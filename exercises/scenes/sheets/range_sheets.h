// The mechanism at the ends of what its drives can go, for those that a file asks for under extremes.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

std::vector<SheetMaker> range_sheets(const std::shared_ptr<const Scene>& scene);

}  // namespace epure::scenes
