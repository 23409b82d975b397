// A formula on Deep that loses digits on the way, on the numbers that report it.
#pragma once

#include "geometry/numbers/ball.h"
#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// The formula, run with more and more bits until as many as the scope asks for are left.
template <class Formula>
Deep accurately(const Formula& formula) {
  const long bits = Arithmetic<Deep>::bits();
  for (long working = bits + 32; working <= 16 * (bits + 64); working *= 2) {
    const Arithmetic<Deep> scope(working);
    const Deep found = formula();
    if (arb_rel_accuracy_bits(found.ball()) >= bits) return found;
  }
  throw Undecided("a formula that cancels beyond all bits", "una formula che si cancella oltre ogni bit");
}

// The same of a value that only balls enclose: the doubles around it; on Fast the one next to it; undecided on the
// exact numbers, to which no such value belongs.
template <class T, class Formula>
T on_balls(const Formula& formula) {
  if constexpr (std::is_same_v<T, Deep>) {
    return accurately(formula);
  } else if constexpr (std::is_same_v<T, Bounded>) {
    const Arithmetic<Deep> scope(80);
    return to_bounded(accurately(formula));
  } else if constexpr (std::is_same_v<T, Fast>) {
    const Arithmetic<Deep> scope(64);
    return enclosure(accurately(formula)).value;
  } else {
    throw Undecided("a transcendental number", "un numero trascendente");
  }
}

}  // namespace epure::geometry
