// A mechanism at a dead centre or change point: its links have a place there, but the drives do not tell how they
// move.
#pragma once

#include <optional>

#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Which group is at its limit, and what is special about its place; none where none is proved to be. Throws
// geometry::NotClosed where the mechanism does not close.
std::optional<Words> limit_of(const Built& built);

// Why friction has no forces here: something does not slide, or jams; none where neither is proved.
std::optional<Words> no_forces_with_friction(const Built& built);

}  // namespace epure::scenes
