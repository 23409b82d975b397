// The polygon of vectors: a vector equation of the plane solved by drawing it.
#pragma once

#include <utility>

#include "geometry/constructions/plane.h"

namespace epure::geometry {

// Two unknown magnitudes: the x and y of   known + x u = y w.
// The two lines, along u through the tip of `known` and along w through the origin, meet in the answer.
// Throws Impossible when u and w are parallel, Undecided when that cannot be told.
template <class T>
struct TwoMagnitudes {
  T of_first, of_second;
};
template <class T>
TwoMagnitudes<T> close_polygon(const Vector<T>& known, const Vector<T>& u, const Vector<T>& w) {
  const T turn = cross(u, w);
  const Sign decided = sign(turn);
  if (decided == Sign::undecided)
    throw Undecided("whether two sides of a vector polygon are parallel",
                    "se due lati di un poligono vettoriale siano paralleli");
  if (decided == Sign::zero)
    throw Impossible("two sides of the vector polygon are parallel",
                     "due lati del poligono vettoriale sono paralleli");
  return {quotient(cross(w, known), turn), quotient(cross(u, known), turn)};
}

// One vector unknown: what closes   known + ? = sum.
template <class T>
Vector<T> closing_side(const Vector<T>& known, const Vector<T>& sum) {
  return sum - known;
}

}  // namespace epure::geometry
