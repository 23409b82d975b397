// Angles of directions, for a ledger: what the exact numbers are asked of them is only whether they are zero.
#pragma once

#include "exercises/kit/proof/ledger.h"
#include "geometry/analytic/complex.h"

namespace epure {

namespace angles {

// For the exact numbers: zero when v points along +x, else something that is not.
template <class T>
T zero_along_x(const geometry::Vector<T>& v) {
  return geometry::sign(v.x) == geometry::Sign::positive ? v.y : T(1);
}

}  // namespace angles

// In (-π, π], counter-clockwise from +x. Throws Undecided when v may be zero, or cannot be told from the direction
// -x.
template <class T>
T angle_of(const geometry::Vector<T>& v) {
  if constexpr (signs_only<T>) {
    return angles::zero_along_x(v);
  } else {
    return geometry::arc_tangent(v.y, v.x);
  }
}

// In [0, 2π), counter-clockwise from +x. Throws Undecided when v may be zero, or cannot be told from the direction
// +x.
template <class T>
T angle_within_turn(const geometry::Vector<T>& v) {
  if constexpr (signs_only<T>) {
    return angles::zero_along_x(v);
  } else {
    const geometry::Sign up = geometry::sign(v.y);
    if (up == geometry::Sign::positive || up == geometry::Sign::zero) return geometry::arc_tangent(v.y, v.x);
    // Below the axis, or about it: measured from -x, where there is no cut.
    if (up == geometry::Sign::undecided && geometry::sign(v.x) != geometry::Sign::negative)
      throw geometry::Undecided("whether a direction lies before or behind +x",
                                "se una direzione stia prima o dopo +x");
    return geometry::pi<T>() + geometry::arc_tangent(T(-v.y), T(-v.x));
  }
}

// The unsigned angle between u and v, in [0, π].
template <class T>
T angle_between(const geometry::Vector<T>& u, const geometry::Vector<T>& v) {
  const T turn = geometry::cross(u, v);
  if constexpr (signs_only<T>) {
    return angles::zero_along_x(geometry::Vector<T>{geometry::dot(u, v), turn});
  } else {
    return geometry::arc_tangent(geometry::root(geometry::square(turn)), geometry::dot(u, v));
  }
}

// 180 / π degrees in a radian; for signs, any positive number.
template <class T>
T in_degrees(const T& radians) {
  if constexpr (signs_only<T>) {
    return radians;
  } else {
    return geometry::quotient(geometry::from_rational<T>(180) * radians, geometry::pi<T>());
  }
}

// The same by the second route, as a part of the turn.
template <class T>
T part_of_turn_in_degrees(const T& radians) {
  if constexpr (signs_only<T>) {
    return radians;
  } else {
    const T turn = T(2) * geometry::pi<T>();
    return geometry::quotient(radians, turn) * geometry::from_rational<T>(360);
  }
}

// A given angle, in degrees.
template <class T>
T given_in_degrees(const geometry::Angle& angle) {
  if (angle.radians == 0) return geometry::from_rational<T>(360 * angle.turns);
  if constexpr (signs_only<T>) {
    return T(sign_of(angle));
  } else {
    return part_of_turn_in_degrees(geometry::radians<T>(angle));
  }
}

// slope_angle by the second route, from the tangent of its half: z in the half plane of positive real parts.
template <class T>
T slope_by_its_half(const geometry::analytic::Complex<T>& z) {
  if constexpr (signs_only<T>) {
    return z.im;
  } else {
    return T(2) * geometry::arc_tangent(z.im, T(z.re + geometry::analytic::modulus(z)));
  }
}

// The nearest whole number of half turns.
inline Rational half_turns(const geometry::Angle& angle) {
  return whole_turns(Rational(2) * angle + geometry::Angle{Rational(1, 2)});
}

// The crank angle as a protractor at A0 shows it, whole turns counted: from the half turn nearest to A, so that the
// angle is never taken at its cut.
template <class T>
T crank_angle_seen(const geometry::Angle& crank, const geometry::Point<T>& A) {
  if constexpr (signs_only<T>) {
    return T(sign_of(crank));
  } else {
    const Rational halves = half_turns(crank);
    const bool even = mpz_even_p(halves.numerator().mpz()) != 0;
    const T angle = even ? geometry::arc_tangent(A.y, A.x) : geometry::arc_tangent(T(-A.y), T(-A.x));
    return angle + geometry::from_rational<T>(halves) * geometry::pi<T>();
  }
}

}  // namespace epure
