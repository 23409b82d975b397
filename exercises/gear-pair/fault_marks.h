// Where in the figure the faults of a pair lie: each marked and named there. Nothing on these sheets is accelerated,
// so the colour of accelerations is that of faults.
#pragma once

#include "exercises/gear-pair/teeth.h"

namespace epure::gear_pair {

inline constexpr Meaning fault_ink = Meaning::acceleration;

void mark_faults(Plot& plot, const DrawnPair& pair, const Teeth& teeth, Language language);

// Only that the tips of a ring too small collide, which happens beside the mesh.
void mark_colliding_tips(Plot& plot, const DrawnPair& pair, Language language);

}  // namespace epure::gear_pair
