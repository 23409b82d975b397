// The faults of a pair: told, and marked in the figure where they lie. Nothing on these sheets is accelerated, so the
// colour of accelerations is that of faults.
#pragma once

#include "exercises/gear-pair/teeth.h"

namespace epure::gear_pair {

inline constexpr Meaning fault_ink = Meaning::acceleration;

// One sentence that names the wheel, the numbers and what follows from it.
Words sentence(const geometry::Fault& fault, const geometry::PairData& of);

// "wheel 1", "the ring".
Words name_of(int wheel, const geometry::PairData& of);

void mark_faults(Plot& plot, const Pair& pair, const Teeth& teeth, Language language);
// Only that the tips of a ring too small collide, which happens beside the mesh.
void mark_colliding_tips(Plot& plot, const Pair& pair, Language language);

}  // namespace epure::gear_pair
