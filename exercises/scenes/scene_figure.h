// What a scene looks like: its links as bars and plates, its joints, its guides.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// The names of the points that move, in the order of the file.
std::vector<std::string> moving_points(const Built& built);

Mechanism figure_of(const Built& built, const Solution& solution);

}  // namespace epure::scenes
