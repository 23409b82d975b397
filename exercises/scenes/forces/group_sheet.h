// The sheet of a group of links: cut free, with what acts on them, and the polygons of their forces.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/scenes/forces/force_groups.h"

namespace epure::scenes {

enum class Shows { all, bodies, polygons };
PanelSheet group_sheet(const Built& built, const Solution& s, const GroupForces& group, Shows shows,
                       Language language);

// "3 and 4".
Words enumerated_links(const std::vector<std::string>& numbers);

}  // namespace epure::scenes
