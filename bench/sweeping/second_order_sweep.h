// The second-order analysis of a linkage over a full turn of its crank, every number enclosed.
//
// Two positions at a time in vector registers (TwoBounded), on all processors. What TwoBounded cannot decide (a limit
// position, a pole at infinity, the last positions before one) is handed over, one position at a time, to Bounded,
// then Deep 128 and 256, then, for a crank at a multiple of 15°, to Exact, which proves what does not exist.
//
// The directions of the crank are enclosed to within 1.3e-15 (uniform_turns.h), each alone by Bounded to within 2
// ulp. Measured against that: most enclosures are 1.1 to 1.6 times as wide, the widest up to 4 times; but where a
// number passes zero with the cosine or sine of the crank it is as far off as these are, 1.3e-15 of its largest size,
// and not of itself.
#pragma once

#include "geometry/mechanisms/second_order.h"

#include <cstddef>
#include <span>

namespace epure::geometry {

// What is known of one position. yes: the numbers in `at` enclose the true values. no: proved not to exist, and
// undecided: no number could tell; what `at` holds is then without meaning, and so it is when what it depends on is
// not known.
struct Swept {
  SecondOrder<Bounded> at;
  Truth position;       // A, B, C: the linkage closes
  Truth motion;         // velocities and accelerations: not at a limit position of the crank
  Truth P0, K, centre;  // no: at infinity, or (crank and rocker in line; C in the pole) not determined
};

// How many positions each number settled (the last one that had to be asked), and how many none could settle wholly.
struct SweepCount {
  std::size_t side_by_side = 0, bounded = 0, deep = 0, exact = 0, open = 0;

  SweepCount& operator+=(const SweepCount& other) {
    side_by_side += other.side_by_side, bounded += other.bounded, deep += other.deep, exact += other.exact,
        open += other.open;
    return *this;
  }
  std::size_t handed_over() const { return bounded + deep + exact + open; }
};

// results[k] for the crank at k/n of a turn from +x, n = results.size(). The rounding mode and the processor's flags
// of the caller are as before. No other memory is taken that grows faster than √n. threads = 0: one for each
// processor. Throws Impossible when the plate of a slider-crank does not close (a linkage that does not is said of
// its positions).
SweepCount sweep_second_order(const DrivenFourBar& driven, std::span<Swept> results, unsigned threads = 0);
SweepCount sweep_second_order(const DrivenSliderCrank& driven, std::span<Swept> results, unsigned threads = 0);

}  // namespace epure::geometry
