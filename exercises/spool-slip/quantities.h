// What is reported of the spool, by name: letters, unit, meaning.
#pragma once

#include "exercises/kit/statement/quantity.h"

namespace epure::spool_slip {

// One of the exercise's. `name` must be one of them.
const Quantity& quantity(const std::string& name);

}  // namespace epure::spool_slip
