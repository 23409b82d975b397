// Curves drawn to a tolerance: Bezier arcs of proved deviation against points at equal steps.
#pragma once

#include <vector>

#include "bench/results.h"

namespace epure::bench {

// A cycloid, an involute, a coupler curve and a polode, each to 1e-4, 1e-5, ... m, `decades` tolerances; `budget`
// seconds for each.
std::vector<CurveResult> measure_curves(int decades, double budget);

}  // namespace epure::bench
