// The outline of one tooth as it is drawn: Bezier arcs that never lie outside the true tooth.
//
// The frame is the wheel's own: its centre is the origin and the middle of the tooth lies on +y, for a ring too,
// whose teeth point to its centre. A rack's reference line is the x axis, the middle of the tooth the y axis, and the
// tooth points down. The outline runs from the middle of the space on the right (+x) to that on the left, so that
// copies turned by 2π/z, of a rack moved by πm, join up to the rounding of doubles. Left is the exact mirror image of
// right.
//
// What is drawn follows, to either side within half the tolerance, the outline of the tooth set back by half the
// tolerance (tooth_form.h). So every drawn point lies inside the true tooth, by no more than the tolerance, and drawn
// teeth do not overlap where true ones do not. Flank and root meet exactly: with one tangent, or where an undercut
// root crosses the flank. Only the far side of a sharp corner may be farther from the drawing, by half the tolerance
// over the sine of half the corner's angle.
//
// Metres.
#pragma once

#include "geometry/curves/trace.h"
#include "geometry/gears/pair_data.h"

#include <vector>

namespace epure::geometry {

struct OutlinePiece {
  enum class Kind { root, fillet, flank, tip } kind;
  std::vector<BezierArc> arcs;
};

struct ToothOutline {
  std::vector<OutlinePiece> pieces;  // root, fillet, flank, tip, flank, fillet, root; without what has no length
  double deviation = 0;              // proved upper bound of how far a drawn point lies inside the true outline
};

// Of wheel 1 or 2; wheel 2 may be a ring or rack. tolerance > 0.
// A rounding that does not fit is drawn as large as fits; a ring's tooth begins at the base circle when its tip would
// lie inside it; a pointed tooth ends where its flanks meet, and so does a ring's pointed space. Throws Impossible
// when no outline exists: the cutter is pointed or cuts the tooth off, no flank is left; Undecided when the tolerance
// is below the noise of doubles.
ToothOutline tooth_outline(const PairData& of, int wheel, double tolerance);

}  // namespace epure::geometry
