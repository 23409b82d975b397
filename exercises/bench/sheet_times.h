// Whole sheets drawn by processes of their own, and the floor under them.
#pragma once

#include <vector>

#include "exercises/bench/report.h"
#include "exercises/kit/exercise.h"

namespace epure::bench {

// The first sheet of each exercise, `runs` times in turn: `epure draw ID/SHEET` (this program), and epure-floor
// beside it on the recorded calls of the same sheet. Empty where there is no epure-floor beside this program.
std::vector<SheetResult> measure_sheets(const Catalogue& exercises, int runs);

}  // namespace epure::bench
