// Where a picture that is cut stands in its room.
#pragma once

#include "drawings/picture.h"

namespace epure {

// Where the plane's origin lies for what is needed to be inside the room, and of all that could be shown as much as
// there is place for. (Boxes from the plane's origin, in mm.)
drawings::Point origin_showing(const drawings::Box& all, const drawings::Box& needed, const drawings::Box& room);

}  // namespace epure
