// Where a mark of a figure may show.
#pragma once

#include "drawings/picture.h"

namespace epure::drawings {

// Its window as far as it lies in `area`, or all of that. Throws std::invalid_argument for a window outside.
Box window_of(const Figure& figure, std::size_t mark, Box area);

}  // namespace epure::drawings
