// Functions whose terms nearly cancel, so that plain doubles lose most of their digits, or all:
//
//   tan α - α                        the involute function, near α = 0                    ≈ α³/3
//   (n + 1) ln n - 2 (n - 1)         near n = 1                                           ≈ (n - 1)³/6
//   (e^{βt} - e^{-βt}) / (2 β)       = sinh(βt)/β, near β = 0                             ≈ t
//
// Fast computes the formula as it stands: that is what a user of doubles gets. Bounded and Deep
// keep their relative accuracy: each function is monotone, so its values at the ends of the enclosure bound it, and
// at a point Arb's functions run with more and more bits until what is left after cancelling has as many as asked.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

// α in radians, |α| < π/2: else throws Undecided.
Fast tangent_less_angle(Fast alpha);
Bounded tangent_less_angle(const Bounded& alpha);
Deep tangent_less_angle(const Deep& alpha);

// n > 0: else throws Undecided.
Fast logarithms_near_one(Fast n);
Bounded logarithms_near_one(const Bounded& n);
Deep logarithms_near_one(const Deep& n);

// β = 0 gives t, but for Fast: it divides by β and throws Undecided.
Fast exponentials_over_twice(Fast beta, Fast t);
Bounded exponentials_over_twice(const Bounded& beta, const Bounded& t);
Deep exponentials_over_twice(const Deep& beta, const Deep& t);

}  // namespace epure::geometry::analytic
