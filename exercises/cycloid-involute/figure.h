// What the sheets of cycloid and involute share.
#pragma once

#include "exercises/kit/panels/plot.h"
#include "geometry/motion/rolling.h"

namespace epure::cycloid_involute {

// The path of M while the body turns from one angle to the other, radians. Returns how far, in mm of paper, the drawn
// line may be from the true one, proved.
double draw_path(Plot& plot, const geometry::Rolling& rolling, double from, double to, const std::string& name);

inline const std::vector<std::string> roman{"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X", "XI", "XII"};
inline constexpr int divisions = 12;

}  // namespace epure::cycloid_involute
