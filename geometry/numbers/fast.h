// Fast: double. For sampling curves; its decisions are those of the computed value and prove nothing.
#pragma once

#include "geometry/numbers/number.h"

#include <cmath>

namespace epure::geometry {

template <>
class Arithmetic<Fast> {
 public:
  Arithmetic() {}  // user-provided, so that a scope nobody reads does not count as an unused variable
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;
};

// The double nearest to the rational (ties to even), also under another rounding mode.
template <>
Fast from_rational<Fast>(const Rational& value);

// Noise below zero cannot be told from a negative number here: both give 0.
inline Fast root(Fast x) { return x > 0 ? std::sqrt(x) : 0.0; }
inline Fast square(Fast x) { return x * x; }

inline Sign sign(Fast x) {
  if (x > 0) return Sign::positive;
  if (x < 0) return Sign::negative;
  return x == 0 ? Sign::zero : Sign::undecided;  // undecided: not a number
}

inline Fast quotient(Fast a, Fast b) {
  if (sign(b) == Sign::zero || sign(b) == Sign::undecided)
    throw Undecided("division by a computed zero", "divisione per uno zero calcolato");
  return a / b;
}

template <>
inline Fast pi<Fast>() {
  return 3.14159265358979323846;
}

// Reduced exactly to an eighth of a turn before the library function: within 2 ulp of the true value, also where the
// cosine is nearly zero.
template <>
Fast cosine<Fast>(const Turn& turn);
template <>
Fast sine<Fast>(const Turn& turn);

inline Fast arc_tangent(Fast y, Fast x) {
  if (x == 0 && y == 0) throw Undecided("direction of a zero vector", "la direzione di un vettore nullo");
  return y == 0 ? (x < 0 ? pi<Fast>() : 0.0) : std::atan2(y, x);  // a -0.0 would fall on the wrong side of the cut
}

inline Fast cosine_of_angle(Fast angle) { return std::cos(angle); }
inline Fast sine_of_angle(Fast angle) { return std::sin(angle); }

}  // namespace epure::geometry
