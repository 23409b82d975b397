// Lines that stand at known angles.
#pragma once

#include "geometry/numbers/angle.h"

namespace epure::geometry {

// Whether lines at these angles are parallel: decided exactly, where their sines and cosines could not always tell.
inline bool are_parallel(const Angle& one, const Angle& other) { return is_whole_turns(Rational(2) * (one - other)); }

}  // namespace epure::geometry
