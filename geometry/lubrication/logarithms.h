// The combinations of ln n that a film between flat walls is made of, n > 0. All grow with n, from zero at n = 1:
//
//   plain    ln n                                            ≈ n - 1          derivative 1/n
//   drag     2 (n + 1) ln n - 3 (n - 1)                      ≈ n - 1          2 ln n - 1 + 2/n >= 1
//   load     (n + 1) ln n - 2 (n - 1)                        ≈ (n - 1)³/6     ln n - 1 + 1/n >= 0
//   couple   (n² + 4 n + 1) ln n - 3 (n² - 1)                ≈ (n - 1)⁵/30    third derivative 2 (n - 1)²/n³ >= 0
//
// Beside n = 1 their terms cancel. Fast computes them as they stand, Bounded and Deep keep their relative accuracy.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry {

enum class Logarithms { plain, drag, load, couple };

// Throws Undecided unless n is proved positive.
Fast logarithms(Logarithms which, Fast n);
Bounded logarithms(Logarithms which, const Bounded& n);
Deep logarithms(Logarithms which, const Deep& n);

// The logarithm of an algebraic number other than 1 is transcendental (Lindemann): no exact number holds it.
template <class T>
requires(!NumberWithAngles<T>) T logarithms(Logarithms, const T&) {
  throw Undecided("a logarithm is transcendental", "un logaritmo è trascendente");
}

}  // namespace epure::geometry
