// The four-bar linkage as its sheets draw it, from the places that the solution found.
#pragma once

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// A0, A, B and B0 must be in the solution, after the prefix of the case; with C too, the coupler is a plate. Links: 1
// the frame, 2 the crank, 3 the coupler, 4 the rocker.
Mechanism four_bar_mechanism(const Solution& solution, double sense_of_crank, const std::string& of_case = {});

}  // namespace epure
