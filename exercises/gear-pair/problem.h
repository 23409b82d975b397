// What is given of the pair, read and refused.
#pragma once

#include "exercises/kit/statement/description.h"
#include "geometry/gears/pair_data.h"

namespace epure::gear_pair {

std::vector<GivenSpec> givens();
std::vector<Printed> printed_by_the_source();

// Throws BadGivens for what is no pair of gears: the sentence names the given and the condition. A pair that is only
// faulty (geometry/gears/faults.h) is one.
geometry::PairData pair_of(const Givens& givens);

}  // namespace epure::gear_pair
