#pragma once

#include <vector>

#include "exercises/kit/proof/exercise.h"

namespace epure::slider_crank_acceleration {

std::vector<Printed> printed_by_the_source();

}  // namespace epure::slider_crank_acceleration
