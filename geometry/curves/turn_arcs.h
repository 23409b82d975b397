// A full turn of a unit vector by rational functions alone, so that interval arithmetic follows it rigorously.
//
// Four arcs, centred on +x, +y, -x, -y. On each, with t from -1 to 1, the direction is the centre turned by
// 2 arctan(t/m):  ((m² - t²)/(m² + t²), 2mt/(m² + t²)),  m = 2 on the x axis, m = 3 on the y axis.
// They meet exactly, without overlap, at the directions (±3/5, ±4/5) of the 3-4-5 triangle; and as they lie evenly
// about both axes, mirroring in an axis only changes the sign of t or swaps two arcs. A binary fraction t is exact.
#pragma once

#include <cmath>

#include "geometry/constructions/plane.h"

namespace epure::geometry {

inline constexpr int turn_arcs = 4;

// The shortest piece of an arc (t from -1 to 1) that is looked at by itself before a gap is stated. Beside a point
// where a root vanishes a curve is missed by about the root of this, 1e-6 of its size, which no drawing shows; and
// pieces of a millionth of it can still be told apart in doubles.
inline constexpr double shortest_piece = 0x1p-40;

// The direction at t on arc 0, 1, 2 or 3. Also right for t somewhat outside [-1, 1], on the neighbouring arc.
template <class X>
Vector<X> direction_on_turn(int arc, const X& t) {
  const int m = arc % 2 == 0 ? 2 : 3;
  const X below = X(m * m) + square(t);
  // The cosine with t in one place only: a narrower interval than (m² - t²)/(m² + t²).
  Vector<X> d{quotient(X(2 * m * m), below) - X(1), quotient(X(2 * m) * t, below)};
  for (int quarter = 0; quarter < arc; ++quarter) d = quarter_turn(d);
  return d;
}

// A direction by its arc and t.
struct TurnPlace {
  int arc;
  double t;
};

// The end of an arc and the beginning of the next are one place; the end and the beginning of the whole turn are two.
inline bool is_same(const TurnPlace& a, const TurnPlace& b) {
  return (a.arc == b.arc && a.t == b.t) || (a.arc + 1 == b.arc && a.t == 1 && b.t == -1);
}

// Rounded.
inline Vector<double> direction_of(const TurnPlace& at) { return direction_on_turn(at.arc, at.t); }

// The angle in (0, 2π] from one place on to the other, in radians and rounded.
inline double turned_between(const TurnPlace& from, const TurnPlace& to) {
  const auto angle = [](const TurnPlace& at) {
    return at.arc * pi<Fast>() / 2 + 2 * std::atan2(at.t, at.arc % 2 == 0 ? 2.0 : 3.0);
  };
  const double turned = angle(to) - angle(from);
  return turned > 0 ? turned : turned + 2 * pi<Fast>();
}

}  // namespace epure::geometry
