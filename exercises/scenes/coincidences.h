// Points of different links that lie in one place: mostly a side that was said wrongly folded a group onto another.
#pragma once

#include <vector>

#include "exercises/scenes/scene.h"

namespace epure::scenes {

// A sentence for each two points, decided exactly; where that could not be told it says so. Nothing of a mechanism
// that does not close.
std::vector<Words> coincidences(const Built& built);

}  // namespace epure::scenes
