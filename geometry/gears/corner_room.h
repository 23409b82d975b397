// Whether the corners of a wheel's tips find room between the mate's teeth.
//
// Below the end of contact the corner of a tip goes on towards the root, not along the line of action any more, and
// with little clearance it may run into the root curve although contact itself ends on the flank.
#pragma once

#include "geometry/gears/pair_data.h"

#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// Of an external pair, at the narrowest of the places that were looked at along the root curve of the wheel: how far
// the corner passes from it, as an arc about the centre of the wheel, in metres. Negative: there the teeth overlap.
// Positive: they have room there, and as good as certainly elsewhere, but that is not proved.
// Throws Impossible when a wheel has no outline or no point of the root curve is deep enough to be met, Undecided
// when that cannot be told. Needs an Arithmetic<Deep> scope.
Deep corner_room(const PairData& of, int wheel);

}  // namespace epure::geometry
