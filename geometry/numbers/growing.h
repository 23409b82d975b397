// Growing functions of which the terms nearly cancel, on enclosures, with the relative accuracy that was asked for:
// their values at the ends bound them, and at a point Arb's functions run with more and more bits until what is left
// after cancelling has as many as asked.
#pragma once

#include <cmath>

#include "geometry/numbers/enclosure.h"

namespace epure::geometry {

using BallFunction = void (*)(arb_t result, const arb_t x, long bits);

// `at_zero` is where the function has the value `there` and may not be computed.
Deep growing(BallFunction function, const Deep& x, int at_zero, int there);

// What is computed on Deep with a few bits more than doubles have.
template <class Computation>
Bounded in_doubles(const Computation& computation) {
  constexpr long bits_for_doubles = 80;
  const Arithmetic<Deep> scope(bits_for_doubles);
  return to_bounded(computation());
}

// Throws Undecided for an infinite end.
inline Deep ball(const Bounded& x) {
  if (!std::isfinite(x.inf()) || !std::isfinite(x.sup()))
    throw Undecided("a number without bounds", "un numero senza limiti");
  return Deep::from_bounded(x);
}

}  // namespace epure::geometry
