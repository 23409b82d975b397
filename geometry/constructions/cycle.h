// A circle that may have become a line: k (x² + y²) + l x + m y + n = 0. A line when k = 0.
#pragma once

#include "geometry/constructions/circle.h"

namespace epure::geometry {

// |x|. Throws Undecided when the sign is. (Not called magnitude: CGAL has a function of that name, which argument
// lookup prefers for intervals, and which returns only the far end.)
template <class T>
T absolute(const T& x) {
  switch (sign(x)) {
    case Sign::negative:
      return -x;
    case Sign::undecided:
      throw Undecided("the sign of a length", "il segno di una lunghezza");
    default:
      return x;
  }
}

template <class T>
struct Cycle {
  T k, l, m, n;

  // At infinity (w = 0), in the direction of the normal, when the cycle is a line.
  ProjectivePoint<T> centre() const { return {-l, -m, T(2) * k}; }
  // Throws Undecided unless k is proved different from zero.
  T radius() const { return quotient(root(square(l) + square(m) - T(4) * k * n), T(2) * absolute(k)); }
  // The line, when k = 0.
  Line<T> straight() const { return {l, m, n}; }
  // Zero when P lies on the cycle.
  T power(const Point<T>& P) const { return k * (square(P.x) + square(P.y)) + l * P.x + m * P.y + n; }
};

// The cycle k|X - A|² + linear . (X - A) + constant = 0 written for the origin.
template <class T>
Cycle<T> cycle_about(const Point<T>& A, const T& k, const Vector<T>& linear, const T& constant) {
  return {k, linear.x - T(2) * k * A.x, linear.y - T(2) * k * A.y,
          k * (square(A.x) + square(A.y)) - linear.x * A.x - linear.y * A.y + constant};
}

// Through three points; a line when they are in line (k = 0).
template <class T>
Cycle<T> cycle_through(const Point<T>& P, const Point<T>& Q, const Point<T>& R) {
  const Vector<T> q = Q - P, r = R - P;
  const T q2 = length_squared(q), r2 = length_squared(r);
  return cycle_about(P, cross(q, r), Vector<T>{q.y * r2 - r.y * q2, r.x * q2 - q.x * r2}, T(0));
}

}  // namespace epure::geometry
