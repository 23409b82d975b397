// What is reported of the welds, by name: letters, unit, meaning.
#pragma once

#include "exercises/kit/statement/quantity.h"

namespace epure::crane_welds {

// One of the exercise's. `name` must be one of them.
const Quantity& quantity(const std::string& name);

}  // namespace epure::crane_welds
