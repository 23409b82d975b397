// The sheets of paths: of each point that the file asks for, over all places of the drive.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

std::vector<SheetMaker> path_sheets(const std::shared_ptr<const Scene>& scene);

}  // namespace epure::scenes
