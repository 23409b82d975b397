// What the programs of this project share: the command line on the whole catalogue, as a process of its own.
#pragma once

#include "exercises/cli/run.h"

namespace epure {

// For main: sets up the process, runs the command line, and returns the exit code.
int run_program(int count, char** words, const Bench& bench);

}  // namespace epure
