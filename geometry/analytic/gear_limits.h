// The least numbers of teeth by closed formulas.
#pragma once

#include "geometry/analytic/gear_formulas.h"
#include "geometry/numbers/climb.h"

#include <algorithm>
#include <cmath>

namespace epure::geometry::analytic {

// Not rounded: 2 (ha - x1)/sin²α, below which the rack undercuts wheel 1.
template <class T>
T undercut_limit_teeth(const Gears& of) {
  return quotient(from_rational<T>(2 * (of.ha - of.x1)), square(sine<T>(of.alpha)));
}

// Not rounded: the z1 of a pair in the ratio u = z2/z1 whose wheel 2, with the addendum h m, reaches T1:
//   external  2 h / (√(u² + (2u + 1) sin²α) - u),   ring  2 h / (u - √(u² - (2u - 1) sin²α)),   rack  2 h / sin²α.
// Throws Impossible when the shifts change α_w.
template <class T>
T interference_limit_teeth(const Gears& of) {
  if (of.is_shifted())
    throw Impossible(
        "the working pressure angle changes with the number of teeth: only whole numbers are compared",
        "l'angolo di pressione di lavoro cambia con il numero di denti: si confrontano solo numeri interi");
  const T sine_squared = square(sine<T>(of.alpha));
  if (of.mate == Mate::rack) return quotient(from_rational<T>(2 * (of.ha - of.k - of.x1)), sine_squared);
  const Rational u = of.z2 / of.z1, h = of.ha - of.k + of.s() * of.x2;
  if (h <= 0) return T(0);
  const T hypotenuse = root(from_rational<T>(u * u) + from_rational<T>(of.s() * (2 * u + of.s())) * sine_squared);
  return quotient(from_rational<T>(2 * of.s() * h), hypotenuse - from_rational<T>(u));
}

// The smallest whole number >= 1 that the limit does not exceed; the limit is a scene as decide takes it. Throws
// Undecided when no number can tell.
template <class Limit>
long least_whole(const Limit& limit) {
  const auto is_reached = [&](long n) {
    const Decision left =
        decide([&]<class T>() -> T { return from_rational<T>(Rational(n)) - limit.template operator()<T>(); });
    if (left.sign == Sign::undecided) throw Undecided(left.reason);
    return left.sign != Sign::negative;
  };
  const Arithmetic<Fast> scope;
  const double about = std::ceil(limit.template operator()<Fast>());
  if (about > 1e15) throw Undecided("more than 10¹⁵ teeth", "più di 10¹⁵ denti");
  long n = std::max(1L, static_cast<long>(about));
  while (!is_reached(n)) ++n;
  while (n > 1 && is_reached(n - 1)) --n;
  return n;
}

inline long minimum_teeth_against_rack(const Gears& of) {
  return least_whole([&]<class T>() -> T { return undercut_limit_teeth<T>(of); });
}

// Whether wheel 1 with z teeth lets its mate in the same ratio pass: g_f <= r_b1 tan α_w.
inline bool clears_its_mate(Gears of, const Rational& z) {
  of.z2 *= z / of.z1;
  of.z1 = z;
  try {
    const Decision room = decide([&]<class T>() -> T {
      const GearFormulas<T> pair = gear_formulas<T>(of);
      if (sign(pair.r_tip(2) - pair.r_b(2)) == Sign::negative) return T(of.s());  // nothing reaches the base circle
      return pair.limit_of_path(1) - pair.path_of_approach();
    });
    if (room.sign == Sign::undecided) throw Undecided(room.reason);
    return room.sign != Sign::negative;
  } catch (const Impossible&) {  // no working pressure angle
    return false;
  }
}

// With shifts α_w changes from number to number: searched around the limit without shifts. (That every number above
// the least one clears its mate is shown at the construction's search.)
inline long minimum_teeth_of_pinion(const Gears& of) {
  if (!of.is_shifted()) return least_whole([&]<class T>() -> T { return interference_limit_teeth<T>(of); });
  Gears unshifted = of;
  unshifted.x1 = unshifted.x2 = 0;
  long clear = least_whole([&]<class T>() -> T { return interference_limit_teeth<T>(unshifted); });
  while (!clears_its_mate(of, clear)) clear *= 2;
  long jams = 0;  // or no wheel
  for (long step = 1; clear - step > 0; step *= 2) {
    if (!clears_its_mate(of, clear - step)) {
      jams = clear - step;
      break;
    }
    clear -= step;
  }
  while (clear - jams > 1) {
    const long middle = jams + (clear - jams) / 2;
    (clears_its_mate(of, middle) ? clear : jams) = middle;
  }
  return clear;
}

}  // namespace epure::geometry::analytic
