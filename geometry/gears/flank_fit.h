// A flank drawn with as few cubic Bezier arcs as a tolerance takes.
//
// Plain Hermite arcs agree with the curve at equal parameters and miss it by the fourth power of their length. Only
// the distance along the normals matters to a tooth, and a cubic with free handles can keep that to the sixth power:
// here its ends lie on the involute, and the handles are solved for so that in between it misses the involute five
// times by the same amount, to alternate sides, which is the least the largest miss can be (Chebyshev). Were the ends
// free too, arcs could be 4 % longer.
//
// Proved with intervals: the half angle of the involute through every point of the arc, by its series along the arc.
#pragma once

#include "geometry/curves/trace.h"
#include "geometry/gears/right_flank.h"

#include <vector>

namespace epure::geometry {

struct FlankArcs {
  std::vector<BezierArc> arcs = {};  // each starts at the very double the one before ends at
  double deviation = 0;              // proved upper bound, along the normals and to either side
};

// From the tangent `from` >= 0 to `to` > `from`, deviating by at most `tolerance` > 0. Needs an Arithmetic<Bounded>
// scope. Next to the base circle, where the involute has its cusp, the distance along normals is lost, and a piece
// that reaches no farther than twice the tolerance from that circle is drawn with Hermite arcs.
// Throws Undecided when doubles cannot follow the flank to the tolerance.
FlankArcs flank_arcs(const RightFlank<Bounded>& flank, double from, double to, double tolerance);

}  // namespace epure::geometry
