// The least distance between two sets of Bezier arcs, enclosed.
//
// By branch and bound: of the pairs of arcs the one that may be nearest is halved until it is known well enough. The
// hull of the control points contains an arc, and two hulls are apart by at least as much as their shadows on any
// line; two points, one of each arc, bound the distance from above.
#pragma once

#include "geometry/constructions/plane.h"

#include <array>
#include <vector>

namespace epure::geometry {

// Control points that are known up to intervals.
using EnclosedArc = std::array<Point<Bounded>, 4>;

// low <= distance <= high.
//   low > 0     proves that no arcs meet
//   high <= 0   proves that two cross; low is -∞, since how deep is not asked
//   otherwise   low is -∞ and high > 0: they may touch or not, within the noise of doubles
struct ArcGap {
  double low, high;
};

// high - low <= accuracy unless noise prevents it. Arcs that are farther apart than `horizon` are only known to be:
// low is then the horizon, and high may be infinite. Needs an Arithmetic<Bounded> scope.
ArcGap arc_gap(const std::vector<EnclosedArc>& first, const std::vector<EnclosedArc>& second, double accuracy,
               double horizon);

}  // namespace epure::geometry
