// How far the drawn teeth of two wheels are from each other: the gap between the Bezier arcs themselves, enclosed.
//
// Metres.
#pragma once

#include "geometry/gears/arc_gap.h"
#include "geometry/gears/mesh_angles.h"
#include "geometry/gears/tooth_outline.h"

namespace epure::geometry {

// The flanks on which wheel 1 drives, those behind the teeth, or the whole outlines.
enum class Flanks { driving, coasting, all };

// Between two outlines in the frame of the pair, turned by the angles; of all teeth that come near each other. What
// the answer says is explained in arc_gap.h; low > 0 for the whole outlines, which close around the wheels, proves
// that the wheels have no point in common.
ArcGap mesh_gap(const PairData& of, const ToothOutline& wheel1, const ToothOutline& wheel2, const MeshAngles& angles,
                Flanks flanks, double accuracy, double horizon);

}  // namespace epure::geometry
