// Where letters stand at a traced curve.
#pragma once

#include <optional>

#include "exercises/kit/panels/plot.h"
#include "geometry/curves/trace.h"

namespace epure {

// The middle of its longest run inside the room; none where nothing of it is.
std::optional<Place> middle_of(const geometry::Trace& trace, const Plot& plot, const drawings::Box& room);

}  // namespace epure
