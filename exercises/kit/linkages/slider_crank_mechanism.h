// The slider-crank as its sheets draw it, from the places that the solution found.
#pragma once

#include <memory>

#include "exercises/kit/linkages/slider_crank_instant.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// A0, A, B, C and M must be in the solution.
std::shared_ptr<const Mechanism> slider_crank_mechanism(const Solution& solution, const SliderCrankInstant& instant);

}  // namespace epure
