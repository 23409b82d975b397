// Products, quotients and roots of lengths as ruler and compass make them.
#pragma once

#include "geometry/constructions/circle.h"

namespace epure::geometry {

// The x of  a : b = c : x, by Thales: a and c laid off on one ray, b on the other; the parallel to ab through the end
// of c cuts off x. Throws Undecided unless a is proved different from zero.
template <class T>
T fourth_proportional(const T& a, const T& b, const T& c) {
  const Point<T> O{T(0), T(0)}, A{a, T(0)}, B{T(0), b}, C{c, T(0)};
  return finite(meet(parallel(line(A, B), C), line(O, Vector<T>{T(0), T(1)}))).y;
}

// The x of  a : x = x : b, a and b positive: the height of the semicircle on a + b above where they meet.
template <class T>
T mean_proportional(const T& a, const T& b) {
  const T half = from_rational<T>(Rational(1, 2)), radius = half * (a + b);
  const Circle<T> on_both{{radius, T(0)}, radius};
  return meet(on_both, line(Point<T>{a, T(0)}, Vector<T>{T(0), T(1)}), Along::ahead).y;
}

}  // namespace epure::geometry
