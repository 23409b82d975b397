// What the source printed.
#pragma once

#include "exercises/kit/statement/description.h"

namespace epure::aircraft_landing {

std::vector<Printed> printed_by_the_source();

}  // namespace epure::aircraft_landing
