// What is wrong with a pair. Each fault is a decision, taken exactly.
#pragma once

#include "geometry/gears/pair_data.h"

#include <string>
#include <vector>

namespace epure::geometry {

struct Fault {
  enum class Kind {
    // of wheel 1 or 2; lengths in metres
    tip_inside_base,    // r_tip < r_b: no flank at all (a ring's tooth reaches inside its base circle)
    pointed,            // the tip is `value` thick, not more than 0
    undercut,           // z = `value` is less than `limit` = 2 (ha - x)/sin²α
    undercut_by_edge,   // not the one before, but the cutter's straight edge reaches beyond ha: z `value`, its own
                        // `limit`
    contact_on_fillet,  // the mate's tip needs the flank down to the radius `value`, which begins at `limit` (of a
                        // wheel that is not undercut)
    corner_in_root,  // of external pairs: the corners of the mate's tips dig into the root curve beside the line of
                     // action; at the narrowest place looked at `value` < 0 remains (proved; room is not)
    negative_clearance,  // the tip of the wheel digs into the other's root: `value` < 0 remains between them
    // of the pair, wheel is 0
    interference_approach,    // the path of approach is `value`, more than `limit` = P0T1
    interference_recess,      // the path of recess is `value`, more than `limit` = P0T2
    contact_ratio_below_one,  // of all AE: flanks that are cut away (contact_path.h) may leave less
    pointed_cutter,           // of the cutter's tip, between its roundings, `value` < 0 remains
    tips_collide              // ring too small: beside the mesh the tips run into each other, overlapping by -`value`
  };
  Kind kind;
  int wheel = 0;
  double value = 0, limit = 0;
  // True when no number could tell whether the fault is there; `reason` then says what was open.
  bool undecided = false;
  Words reason = {};
};

// All of them; empty for a pair that works. What a fault leaves without meaning is not asked for: a wheel with the
// tip inside its base circle has no contact. Throws Impossible as gear_pair.
std::vector<Fault> faults(const PairData& of);

}  // namespace epure::geometry
