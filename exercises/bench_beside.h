// `epure bench` is a program of its own, so that a drawing does not load what only measures.
#pragma once

#include "exercises/cli/run.h"

namespace epure {

// Becomes the program epure-bench in this one's folder, with the same words. Returns only by throwing WrongUsage,
// when that is not there.
Bench bench_beside(char** words);

}  // namespace epure
