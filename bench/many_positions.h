// One position of a mechanism with all velocities and accelerations after the other: by hand, and by what carries out
// any linkage (geometry/linkages/carried_out.h), in one run.
#pragma once

#include "bench/results.h"

namespace epure::bench {

// The four-bar's with pole, acceleration pole and a centre of curvature, the full second order. Errors are those at
// the 24 positions of the corpus in the folder. Throws what reading it throws.
std::vector<PositionResult> measure_positions(const std::string& corpora, double budget);

}  // namespace epure::bench
