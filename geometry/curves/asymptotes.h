// The asymptotes of a locus: its tangents at its points at infinity.
#pragma once

#include "geometry/curves/trace.h"

namespace epure::geometry {

struct Asymptote {
  Line<Bounded> enclosure;    // unit normal; contains the true line
  Line<double> line;          // its middle
  Vector<Bounded> direction;  // the direction of the turn (the crank) at which the point is at infinity
};

struct Asymptotes {
  std::vector<Asymptote> lines;  // in the order of the turn, which begins at the direction (3/5, -4/5)
  // Pieces on which it stayed open whether there is one: a point where w touches zero without a change of sign, the
  // end of the stretch on which the locus exists.
  std::vector<Gap> open;
};

// Every simple zero of w is proved to exist and to be the only one nearby: w is monotone about it and changes sign,
// and interval Newton steps narrow it down. The asymptote is the line through the point P at infinity and P', P x P'.
Asymptotes asymptotes(const TracedLocus& locus);

template <class Locus>
Asymptotes asymptotes(const Locus& locus) {
  return asymptotes(TracedLocus{locus, locus});
}

}  // namespace epure::geometry
