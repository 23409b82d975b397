// How far flanks really touch along the line of action.
//
// A and E (gear_pair.h) are where the tips meet the line. The flanks need not reach so far: at the root the cutter
// may have cut the involute away, or left its rounding; at the tip the teeth may be pointed before the tip circle.
// Each flank has a stretch of the line of its own, and contact is where both have theirs. (Corners of tips that touch
// beside the line of action are left out: they do not turn the wheels uniformly.)
#pragma once

#include "geometry/gears/gear_pair.h"

namespace epure::geometry {

struct EndOfContact {
  // Contact begins by the tip of wheel 2 or at the root of wheel 1, and ends by the tip of wheel 1 or at the root of
  // wheel 2. `point` is a tip where the teeth are pointed before their tip circle.
  enum class By { tip, point, root };
  By by;
  Deep xi;  // position on the line of action, metres from P0
};

// Flanks that never touch begin after they end.
struct ContactPath {
  EndOfContact begins, ends;
  Deep length() const { return ends.xi - begins.xi; }
};

// Throws Impossible when the tips do not reach the line of action or a wheel has no outline, Undecided when that
// cannot be told. Needs an Arithmetic<Deep> scope.
ContactPath contact_path(const PairData& of);

}  // namespace epure::geometry
