// The numbers a construction runs on, and the few functions every one of them has.
//
//   Fast     double: sampling for the eye. Decides by the computed value, so it proves nothing.
//   Bounded  interval of doubles: contains the true value.
//   Deep     Arb ball with as many bits as its Arithmetic scope says: contains the true value.
//   Exact    element of a tower of quadratic fields over the rationals; the tower grows as the scene takes roots.
//   Generic  the same with directions left open: what is zero for every direction is proved zero, the rest is a ball.
//   Calcium  exact number of the Calcium library: any rational fraction of a turn, π, roots at any depth.
//
// Each works only while an Arithmetic<T> is alive in the thread; scopes of different numbers may nest.
//   Arithmetic<Fast> scope;          nothing to set: there so that one template can open any scope
//   Arithmetic<Bounded> scope;       rounding mode upwards (and the old one restored)
//   Arithmetic<Deep> scope(128);     bits
//   Arithmetic<Exact> scope;         a fresh tower
//   Arithmetic<Generic> scope;       fresh indeterminates
//   Arithmetic<Calcium> scope;       a fresh context
// Of these only Bounded touches the rounding mode of the processor, and the others are right under any mode: so a
// Bounded may be used while a Deep scope is open inside the Bounded scope, and the other way round. A number with
// roots in it does not outlive its scope (Exact asserts it), and scopes close in the reverse order they opened.
//
// Include numbers.h: a template must see the functions of all six numbers.
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include "words/words.h"

namespace epure::geometry {

using Rational = CGAL::Gmpq;
using Fast = double;
using Bounded = CGAL::Interval_nt<false>;

enum class Sign { negative = -1, zero = 0, positive = 1, undecided = 2 };

// The answer to a question that one arithmetic may leave open.
enum class Truth { no, yes, undecided };

// Thrown by a construction when the number at hand cannot decide what the construction turns on. The climb answers
// it with the next number.
struct Undecided : Told {
  using Told::Told;
};
// Thrown by Exact when the scene leaves the tower: more than five roots, a direction that is no multiple of 15°, or
// π. The climb answers it with Generic, then with Calcium.
struct LeavesTheTower : Told {
  using Told::Told;
};
// Thrown when what was asked for does not exist (a linkage that does not close); the message is meant for the user.
struct Impossible : Told {
  using Told::Told;
};

template <class T>
class Arithmetic;

// A fraction of a full turn, counter-clockwise.
struct Turn {
  Rational fraction;
};

// Every number T has: + - * /, unary -, += -= *= /=, construction from int and
//   T     from_rational<T>(const Rational&)   Fast: the nearest double; Bounded, Deep: a tight enclosure
//   T     quotient(a, b)        a/b for any b: throws Undecided when b is zero or not proved different from zero.
//                               Constructions use it for every divisor that is not proved nonzero beforehand.
//   T     a / b                 Deep, Generic, Calcium: as quotient. Exact: zero is a caller's mistake (assertion).
//                               Fast, Bounded: the plain operator of double and of CGAL, which makes infinities;
//                               only for a divisor known to be nonzero.
//   T     root(const T& x)      square root of x >= 0; a proved negative x is a caller's mistake (assertion). An
//                               enclosure that reaches below zero is cut at zero, because x >= 0 is the caller's
//                               promise. Fast: noise below zero cannot be told from a negative number, gives 0.
//   T     square(const T&)      never negative
//   Sign  sign(const T&)        Fast: of the computed value; Bounded, Deep: undecided when zero is inside and the
//                               enclosure is not the point zero; Exact: always decided; Generic, Calcium: may be
//                               undecided
//   T     pi<T>()               Exact: throws LeavesTheTower
//   T     cosine<T>(Turn), sine<T>(Turn)    exactly 0, ±1/2, ±1 where that is the value. Exact: multiples of 15°
//                               (one root for 30°s and 45°s), else LeavesTheTower
// and, for the enclosing numbers and Fast only (not Exact, Generic, Calcium):
//   T     arc_tangent(y, x)     in (-pi, pi], angle of the direction (x, y); throws Undecided when (x, y) may be
//                               (0, 0) or the enclosures reach across the cut y = 0, x < 0. A y that is exactly zero
//                               with x < 0 is pi.
//   T     cosine_of_angle(x), sine_of_angle(x)    of an angle in radians. An enclosure of a wide angle is valid but
//   not
//                               the narrowest.
template <class T>
T from_rational(const Rational& value);
template <class T>
T pi();
template <class T>
T cosine(const Turn& turn);
template <class T>
T sine(const Turn& turn);

}  // namespace epure::geometry
