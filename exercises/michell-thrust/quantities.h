// What is reported, by name.
#pragma once

#include <string>

#include "exercises/kit/statement/quantity.h"

namespace epure::michell_thrust {

Quantity quantity(const std::string& name);

}  // namespace epure::michell_thrust
