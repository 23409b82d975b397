// What the source printed.
#pragma once

#include "exercises/kit/statement/description.h"

namespace epure::pump_flywheel {

std::vector<Printed> printed_by_the_source();

}  // namespace epure::pump_flywheel
