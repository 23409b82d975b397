// What the source printed.
#pragma once

#include "exercises/kit/statement/description.h"

namespace epure::crane_welds {

std::vector<Printed> printed_by_the_source();

}  // namespace epure::crane_welds
