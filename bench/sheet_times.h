// Whole sheets drawn by processes of their own, and the floor under them.
#pragma once

#include <vector>

#include "bench/results.h"
#include "exercises/kit/proof/exercise.h"

namespace epure::bench {

// The first sheet of each exercise, `runs` times in turn: `epure draw ID/SHEET` and epure-floor on
// the recorded calls of the same sheet. Empty where the two are not beside this program.
std::vector<SheetResult> measure_sheets(const Catalogue& exercises, int runs);

}  // namespace epure::bench
