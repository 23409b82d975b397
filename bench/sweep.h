// The second-order analysis of a four-bar over a whole turn, the plain loop of doubles against the sweep that proves
// its bounds.
#pragma once

namespace epure::bench {

// Nanoseconds for one position, one thread each, in one run.
struct SweepTimes {
  double fast_ns = 0, bounded_ns = 0;
};
SweepTimes time_sweep(double budget);

}  // namespace epure::bench
