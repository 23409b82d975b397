// What the letters of a scene's givens mean.
#pragma once

#include <optional>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Of those that are no distances of two lettered points; none where there are no others. `first_sheet`: "sheet 1",
// where they are told, which stands there where the column has no room for them; empty on it.
std::optional<Section> legend_of(const Scene& scene, const Words& first_sheet, Language language);

}  // namespace epure::scenes
