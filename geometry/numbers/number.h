// The numbers a construction runs on, and the few functions every one of them has.
//
//   Fast     double: sampling for the eye. Decides by the computed value, so it proves nothing.
//   Bounded  interval of doubles: contains the true value.
//   Deep     Arb ball with as many bits as its Arithmetic scope says: contains the true value.
//   Exact    element of a tower of quadratic fields over the rationals; the tower grows as the scene takes roots.
//   Calcium  exact number of the Calcium library: any rational fraction of a turn, π, roots at any depth.
//
// Each works only while an Arithmetic<T> is alive in the thread; scopes of different numbers may nest.
//   Arithmetic<Bounded> scope;       rounding mode upwards (and the old one restored)
//   Arithmetic<Deep> scope(128);     bits
//   Arithmetic<Exact> scope;         a fresh tower
//   Arithmetic<Calcium> scope;       a fresh context
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace epure::geometry {

using Rational = CGAL::Gmpq;
using Fast = double;
using Bounded = CGAL::Interval_nt<false>;

enum class Sign { negative = -1, zero = 0, positive = 1, undecided = 2 };

// Thrown by a construction when the number at hand cannot decide what the construction turns on. The climb answers
// it with the next number.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};
// Thrown by Exact when the scene leaves the tower: more than five roots, a direction that is no multiple of 15°, or
// π. The climb answers it with Calcium.
struct LeavesTheTower : std::runtime_error {
  using std::runtime_error::runtime_error;
};
// Thrown when what was asked for does not exist (a linkage that does not close); the message is meant for the user.
struct Impossible : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
class Arithmetic;

// A fraction of a full turn, counter-clockwise.
struct Turn {
  Rational fraction;
};

// Every number T has: + - * / (division by a number not proved different from zero throws Undecided for Deep,
// Calcium; for Exact it is a caller's mistake), unary -, construction from int and
//   T     from_rational<T>(const Rational&)
//   T     root(const T& x)      square root of x >= 0; a proved negative x is a caller's mistake. An enclosure that
//                               reaches below zero is cut at zero, because x >= 0 is the caller's promise.
//   T     square(const T&)      never negative
//   Sign  sign(const T&)        Fast: of the computed value; Bounded, Deep: undecided when zero is inside and the
//                               enclosure is not the point zero; Exact: always decided; Calcium: may be undecided
//   T     pi<T>()               Exact: throws LeavesTheTower
//   T     cosine<T>(Turn), sine<T>(Turn)    Exact: multiples of 15° (one root for 30°s and 45°s), else LeavesTheTower
// and, for the enclosing numbers and Fast only (not Exact, not Calcium):
//   T     arc_tangent(y, x)     in (-pi, pi], angle of the direction (x, y); throws Undecided at the cut and at (0,0)

}  // namespace epure::geometry
