// All zeros of a function of a direction over a full turn: found, proved, and enclosed.
#pragma once

#include "geometry/curves/trace.h"
#include "geometry/curves/turn_arcs.h"
#include "geometry/numbers/enclosure.h"

#include <functional>
#include <vector>

namespace epure::geometry {

// In `t` on arc `arc` of turn_arcs.h the function vanishes exactly once, and crosses zero.
struct Zero {
  int arc;
  Bounded t;
  Bounded slope;  // encloses the derivative by t, over t and as far again beyond its ends; does not contain zero
  Vector<Bounded> direction() const { return direction_on_turn(arc, t); }
};

struct Zeros {
  std::vector<Zero> found;  // in the order of the turn, which begins at the direction (3/5, -4/5)
  // Parts of the turn where the function does not exist, as far as that was proved.
  std::vector<Gap> absent;
  // Parts on which it stayed open whether there are zeros, and how many: where the function touches zero without
  // crossing it, is zero throughout, or ends.
  std::vector<Gap> open;
};

// The function and its derivative by t, enclosed over the t of an arc.
using TurnFunction = std::function<BoundedTangent(int arc, const Bounded& t)>;

// The turn is halved, piece by piece. A piece is settled when the function is proved not to vanish on it, not to
// exist on it, or to be monotone and of unlike signs at the ends; interval Newton steps then narrow the zero down.
// What is not settled after `most_looks` pieces is open: nothing is dropped.
Zeros search_zeros(const TurnFunction& function, int most_looks);

}  // namespace epure::geometry
