// The part of the paper primitives cover.
#pragma once

#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

Box ink_box(const Primitive& primitive);
Box ink_box(const std::vector<Primitive>& primitives);

}  // namespace epure::drawings
