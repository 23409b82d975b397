// What the parts of this exercise share.
#pragma once

#include <vector>

#include "exercises/kit/proof/solution.h"
#include "exercises/kit/statement/description.h"

namespace epure::ideal_statics {

std::vector<RouteValue> solve(const Givens& givens, Rung rung);
std::vector<Printed> printed_by_the_source();

}  // namespace epure::ideal_statics
