// The instant centres of all pairs of links of a scene, and the lines on which they are found.
#pragma once

#include <memory>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/sheets/sheet_numbers.h"

namespace epure::scenes {

// As many sheets as the centres that no joint gives need: "instant-centres", "instant-centres-2". None where several
// drives leave nothing to be found.
std::vector<SheetMaker> centres_sheets(const std::shared_ptr<const Scene>& scene, const SheetNumbers& numbers);

}  // namespace epure::scenes
