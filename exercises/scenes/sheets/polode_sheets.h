// The polodes of links that a file asks for, by the transport method.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

std::vector<SheetMaker> polode_sheets(const std::shared_ptr<const Scene>& scene);

}  // namespace epure::scenes
