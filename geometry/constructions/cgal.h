// The door to CGAL's kernels: a user's points, vectors and lines come in, ours go out. (Why they are not ours
// throughout: geometry/README.md.)
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <sstream>

#include "geometry/constructions/plane.h"

namespace epure::geometry {

// Exactly the same number. `FT`: a kernel's field of doubles, of rationals, or of lazy exact ones; whose rationals
// these are depends on how CGAL was built, but all are written as 3/7.
inline Rational rational_of(double x) { return Rational(x); }
inline Rational rational_of(const Rational& x) { return x; }
template <class FT>
Rational rational_of(const FT& x) {
  std::ostringstream text;
  text << CGAL::exact(x);
  return Rational(text.str());
}

template <class T, class Kernel>
Point<T> from_cgal(const CGAL::Point_2<Kernel>& P) {
  return {from_rational<T>(rational_of(P.x())), from_rational<T>(rational_of(P.y()))};
}
template <class T, class Kernel>
Vector<T> from_cgal(const CGAL::Vector_2<Kernel>& v) {
  return {from_rational<T>(rational_of(v.x())), from_rational<T>(rational_of(v.y()))};
}
// With the same direction and the same left side.
template <class T, class Kernel>
Line<T> from_cgal(const CGAL::Line_2<Kernel>& l) {
  return {from_rational<T>(rational_of(l.a())), from_rational<T>(rational_of(l.b())),
          from_rational<T>(rational_of(l.c()))};
}

// Over the same number: Fast's are doubles, Bounded's CGAL's intervals.
template <class T>
CGAL::Point_2<CGAL::Simple_cartesian<T>> to_cgal(const Point<T>& P) {
  return {P.x, P.y};
}
template <class T>
CGAL::Vector_2<CGAL::Simple_cartesian<T>> to_cgal(const Vector<T>& v) {
  return {v.x, v.y};
}
template <class T>
CGAL::Line_2<CGAL::Simple_cartesian<T>> to_cgal(const Line<T>& l) {
  return {l.a, l.b, l.c};
}

}  // namespace epure::geometry
