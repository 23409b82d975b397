// What is reported of the landing, by name: letters, unit, meaning.
#pragma once

#include "exercises/kit/statement/quantity.h"

namespace epure::aircraft_landing {

// `name` must be one of them, or of Euler's: "v_20", "omega_1".
Quantity quantity(const std::string& name);

}  // namespace epure::aircraft_landing
