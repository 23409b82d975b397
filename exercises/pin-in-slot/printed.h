#pragma once

#include <vector>

#include "exercises/kit/statement/description.h"

namespace epure::pin_in_slot {

std::vector<Printed> printed_by_the_source();

}  // namespace epure::pin_in_slot
