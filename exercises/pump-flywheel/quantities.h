// What is reported of the pump, by name: letters, unit, meaning.
#pragma once

#include "exercises/kit/statement/quantity.h"

namespace epure::pump_flywheel {

// `name` must be one of them.
const Quantity& quantity(const std::string& name);

}  // namespace epure::pump_flywheel
