// What the source printed.
#pragma once

#include "exercises/kit/statement/description.h"

namespace epure::boat_crane {

std::vector<Printed> printed_by_the_source();

}  // namespace epure::boat_crane
