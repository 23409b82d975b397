// An angle that may be a number of turns, a number of radians, or both: 30 deg is a twelfth of a turn, "2 rad" is no
// rational part of one. Kept exactly, so that what depends on the angle alone can be decided.
#pragma once

#include "geometry/numbers/numbers.h"

#include <optional>
#include <type_traits>

namespace epure::geometry {

// 2π turns + radians, counter-clockwise. Zero only when both are, π being irrational. An angular velocity is kept as
// the angle of one second, an angular acceleration likewise.
struct Angle {
  Rational turns = 0;
  Rational radians = 0;
  bool operator==(const Angle&) const = default;
};

inline bool is_zero(const Angle& a) { return a.turns == 0 && a.radians == 0; }

inline Angle operator+(const Angle& a, const Angle& b) { return {a.turns + b.turns, a.radians + b.radians}; }
inline Angle operator-(const Angle& a, const Angle& b) { return {a.turns - b.turns, a.radians - b.radians}; }
inline Angle operator-(const Angle& a) { return {-a.turns, -a.radians}; }
inline Angle operator*(const Rational& s, const Angle& a) { return {s * a.turns, s * a.radians}; }

// The greatest whole number of turns that is not above the angle.
Rational whole_turns(const Angle& angle);

// The same direction, from 0 to less than a turn.
inline Angle within_one_turn(const Angle& a) { return a - Angle{whole_turns(a)}; }

// A whole number of turns, decided exactly.
inline bool is_whole_turns(const Angle& a) { return a.radians == 0 && a.turns.denominator() == 1; }

// -1, 0 or 1, decided exactly.
int sign_of(const Angle& angle);

// In radians. Exact: throws LeavesTheTower when there are turns in it.
template <class T>
T radians(const Angle& angle) {
  const T rest = from_rational<T>(angle.radians);
  if (angle.turns == 0) return rest;
  return from_rational<T>(Rational(2) * angle.turns) * pi<T>() + rest;
}

// a / b, b not zero; none where no fraction says it, one having turns in it and the other radians.
std::optional<Rational> ratio(const Angle& a, const Angle& b);
// a / b, b not zero.
template <class T>
T quotient_of(const Angle& a, const Angle& b) {
  if (const auto exact = ratio(a, b)) return from_rational<T>(*exact);
  return quotient(radians<T>(a), radians<T>(b));
}

// To the nearest double, or beside it.
double degrees(const Angle& angle);
double to_double(const Angle& angle);  // radians

// The angle by the right angle nearest to its turns: `right_angles` (0 to 3, whole turns left out) and what is left.
struct FromRightAngle {
  int right_angles;
  Angle rest;  // turns from -1/8 to 1/8
};
FromRightAngle from_right_angle(const Angle& angle);

// Of a rational number of turns as sine<T>(Turn) has it, exact values included. Otherwise sine and cosine are
// transcendental (Lindemann and Weierstrass), so no exact number holds them, and they never take the algebraic value
// of a special position: Exact throws LeavesTheTower, Calcium Undecided, Generic leaves the angle open. An angle
// beside a multiple of a right angle by a few radians of any smallness keeps its relative accuracy.
template <class T>
T sine(const Angle& angle) {
  if (angle.radians == 0) return sine<T>(Turn{angle.turns});
  if constexpr (NumberWithAngles<T>) {
    const FromRightAngle from = from_right_angle(angle);
    const T rest = radians<T>(from.rest),
            value = from.right_angles % 2 == 0 ? sine_of_angle(rest) : cosine_of_angle(rest);
    return from.right_angles < 2 ? value : -value;
  } else if constexpr (std::is_same_v<T, Generic>) {
    return Generic::cosine(angle.turns - Rational(1, 4), angle.radians);
  } else if constexpr (std::is_same_v<T, Exact>) {
    throw LeavesTheTower("a cosine or sine of an angle in radians", "un coseno o seno di un angolo in radianti");
  } else {
    throw Undecided("a cosine or sine of an angle in radians is transcendental",
                    "un coseno o seno di un angolo in radianti è trascendente");
  }
}
template <class T>
T cosine(const Angle& angle) {
  return sine<T>(angle + Angle{Rational(1, 4)});
}

// An angle of which only the number is known: where a curve is traced, say, over an interval of angles.
template <class T>
struct Radians {
  T value;
};

template <class T>
Radians<T> operator*(const Rational& s, const Radians<T>& a) {
  return {from_rational<T>(s) * a.value};
}
template <class T>
T radians(const Radians<T>& angle) {
  return angle.value;
}
template <class T>
T cosine(const Radians<T>& angle) {
  return cosine_of_angle(angle.value);
}
template <class T>
T sine(const Radians<T>& angle) {
  return sine_of_angle(angle.value);
}

}  // namespace epure::geometry
