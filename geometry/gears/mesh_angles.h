// How the outlines of tooth_outline.h stand when the driving flanks touch at a given place of the path of contact.
//
// The frame is the pair's (gear_pair.h): wheel 1 about O1 below, driving counter-clockwise, its teeth's left flanks
// against wheel 2. At the path position ξ (metres from P0, positive in recess) the common tangent to the base circles
// has the tangent lengths r_w sin α_w ± ξ.
#pragma once

#include "geometry/constructions/plane.h"
#include "geometry/gears/pair_data.h"

namespace epure::geometry {

// Of the outlines from their own frames into the pair's: counter-clockwise in radians, about O1 and O2. For a rack
// `wheel2` is by how much it is moved along x, in metres; its reference line lies m x1 above the x axis.
// The double nearest to the true value, but for the last place.
struct MeshAngles {
  double wheel1, wheel2;
};
MeshAngles mesh_angles(const PairData& of, double xi);

// Where the outlines' frames are put: the origin of wheel 1's, and that of wheel 2's (of a rack not yet moved along
// x).
struct MeshCentres {
  Point<Bounded> wheel1, wheel2;
};
MeshCentres mesh_centres(const PairData& of);

}  // namespace epure::geometry
