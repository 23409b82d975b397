// What the letters of a scene's givens mean.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Of those that are no distances of two lettered points; none where there are no others; in full, then the sheet
// where they stand ("sheet 1"; empty on that sheet).
std::vector<Result> legend_of(const Scene& scene, const Words& first_sheet, Language language);

}  // namespace epure::scenes
