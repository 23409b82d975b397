// The involute function inv α = tan α - α and its inverse, both in terms of t = tan α:
//   inv = t - arctan t,   d inv/dt = t²/(1 + t²).
// Between the tooth's flank and the radius to its start on the base circle lies the polar angle inv α.
//
// Relative accuracy also near 0, where the two terms cancel: there inv = t³/3 - t⁵/5 + t⁷/7 - ...
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// tan α - α for tan α >= 0 (the caller's promise). Enclosures are at most some ulp wider than what the enclosure of
// the tangent makes them. Exact, Generic and Calcium only know inv 0: at any other algebraic tangent inv is
// transcendental or holds π. There Exact throws LeavesTheTower, Generic and Calcium Undecided.
Fast involute(Fast tangent);
Bounded involute(const Bounded& tangent);
Deep involute(const Deep& tangent);
Exact involute(const Exact& tangent);
Generic involute(const Generic& tangent);
Calcium involute(const Calcium& tangent);

// The inverse: tan α of inv α >= 0 (the caller's promise). Bounded and Deep: proved by Newton's method with
// intervals. Throw Undecided when the enclosure of inv reaches to zero or is too wide for that proof. Exact and
// Calcium as above.
Fast tangent_of_involute(Fast involute);
Bounded tangent_of_involute(const Bounded& involute);
Deep tangent_of_involute(const Deep& involute);
Exact tangent_of_involute(const Exact& involute);
Generic tangent_of_involute(const Generic& involute);
Calcium tangent_of_involute(const Calcium& involute);

}  // namespace epure::geometry
