// How far a pair may go: undercut by the generating rack, interference, the least numbers of teeth. Decided exactly.
//
// A rack, or a mate, can touch the involute of a wheel only on its own side of T, where the line of action touches
// the wheel's base circle: there the involute ends. What reaches beyond T cuts the flank away (undercut, when the
// rack generates the wheel) or jams (interference, when it is the mate's tip).
#pragma once

#include "geometry/gears/gear_pair.h"
#include "geometry/numbers/climb.h"

namespace epure::geometry {

// How deep T lies below the reference line of the rack that generates the wheel with these z and x, over m: the rack
// undercuts with every point of its straight edge that lies deeper.
//   T lies r sin²α = m z sin²α / 2 below the reference circle's pitch point, the line x m above it.
template <class T>
T depth_of_tangent_point(const PairData& of, long z, const Rational& x) {
  return from_rational<T>(Rational(z) / 2) * square(sine<T>(of.alpha)) + from_rational<T>(x);
}

// How deep the straight edge of the cutter reaches below its reference line, over m: its tip lies at hf, and the
// rounding by rho, tangent to edge and tip, takes the last rho (1 - sin α) from the edge.
template <class T>
T depth_of_straight_edge(const PairData& of) {
  return from_rational<T>(of.hf) - from_rational<T>(of.rho) * (T(1) - sine<T>(of.alpha));
}

// Against the rack with the straight edges of the addendum ha: positive when T lies deeper, zero at the limit,
// negative when the rack undercuts wheel 1 or 2. Never of a ring or rack.
Decision room_above_undercut(const PairData& of, int wheel);
// The same against the straight edge that the cutter has.
Decision room_above_cutter_edge(const PairData& of, int wheel);

// Teeth, not rounded: 2 (ha - x)/sin²α.
template <class T>
T undercut_limit_teeth(const PairData& of, const Rational& x) {
  return quotient(from_rational<T>(2 * (of.ha - x)), square(sine<T>(of.alpha)));
}
// The smallest whole number of teeth, at least 1, of a wheel with the shift x that the rack does not undercut.
// Throws Undecided when no number can tell.
long minimum_teeth_against_rack(const PairData& of, const Rational& x);

// Teeth, not rounded: wheel 1 with fewer, and a wheel 2 in the ratio z2/z1 of this pair, would have the tip of wheel
// 2 beyond T1. With the ratio u, and h m the tip of wheel 2 beyond its pitch circle, T1's distance from O2 equals the
// tip radius when
//   z1² sin²α (2u + 1) - 4 h u z1 - 4 h² = 0   external,      z1² sin²α (2u - 1) - 4 h u z1 + 4 h² = 0   internal,
//   z1 sin²α = 2 h                               rack.
// Throws Impossible when the shifts do not add to zero: then α_w changes with the number of teeth.
template <class T>
T interference_limit_teeth(const PairData& of) {
  if (shift_per_tooth(of) != 0)
    throw Impossible(
        "the working pressure angle changes with the number of teeth: only whole numbers are compared",
        "l'angolo di pressione di lavoro cambia con il numero di denti: si confrontano solo numeri interi");
  const T sine_squared = square(sine<T>(of.alpha));
  if (of.kind == PairKind::rack) return quotient(from_rational<T>(2 * (of.ha - of.k - of.x1)), sine_squared);
  const int outwards = of.kind == PairKind::internal ? -1 : 1;
  const Rational u = Rational(of.z2) / Rational(of.z1), h = of.ha - of.k + outwards * of.x2;
  if (h <= 0) return T(0);  // wheel 2 does not reach beyond its pitch circle: no number of teeth is too small
  const T divisor = from_rational<T>(2 * u + outwards) * sine_squared;
  const T spread = root(from_rational<T>(u * u) + from_rational<T>(Rational(outwards)) * divisor);
  return quotient(from_rational<T>(2 * h) * (from_rational<T>(u) + spread), divisor);
}
// The smallest whole number of teeth, at least 1, of wheel 1 whose mate in the ratio z2/z1 of this pair (z2 then need
// not be whole) does not interfere; the shifts and all else as given. Throws Undecided when no number can tell.
long minimum_teeth_of_pinion(const PairData& of);

// Positive when A lies between T1 and P0 or later, zero when it is T1, negative when wheel 2's tips interfere with
// the roots of wheel 1 in the approach.
Decision room_in_approach(const PairData& of);
// The same of E and T2 in the recess. Always positive for a ring and a rack, whose involutes have no end there.
Decision room_in_recess(const PairData& of);

}  // namespace epure::geometry
