// What is reported of the crane, by name: letters, unit, meaning. Body 1 is the beam, body 2 the column.
#pragma once

#include "exercises/kit/statement/quantity.h"

namespace epure::boat_crane {

// One of the exercise's. `name` must be one of them.
const Quantity& quantity(const std::string& name);

}  // namespace epure::boat_crane
