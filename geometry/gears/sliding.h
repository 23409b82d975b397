// How the flanks slide on each other where they touch.
//
// The common tangent of the flanks is square to the line of action. Along it the point of either flank moves with the
// component of its wheel's velocity there; the components along the line of action are equal.
#pragma once

#include "geometry/gears/gear_pair.h"

namespace epure::geometry {

// rad/s, counter-clockwise positive; a rack has the velocity ω1 r_w1 towards -x instead, and ω2 = 0.
template <class T>
struct PairSpeeds {
  T omega_1, omega_2;
  T relative() const { return omega_1 - omega_2; }
};

// The pitch point has the same velocity on both wheels.
template <class T>
PairSpeeds<T> pair_speeds(const GearPair<T>& pair, const T& omega_1) {
  if (!pair.O2) return {omega_1, T(0)};
  const Vector<T> v = omega_1 * quarter_turn(pair.P0 - pair.O1), arm = quarter_turn(pair.P0 - *pair.O2);
  return {omega_1, quotient(dot(v, arm), length_squared(arm))};
}

// m/s, along the common tangent, positive in the sense in which wheel 1's flank moves in P0: towards its tip.
template <class T>
struct FlankVelocities {
  T of_1, of_2;
  // The velocity of flank 1 on flank 2; positive after P0, where both slide towards tip 1.
  T sliding() const { return of_1 - of_2; }
  // Over the flank's own velocity: 1 means pure sliding of the other. Throw Impossible where that velocity is zero
  // (in T1, T2), Undecided when that cannot be told.
  T specific_1() const {
    return over(of_1 - of_2, of_1,
                {"flank 1 has no velocity along itself there: contact is at T1",
                 "lì il fianco 1 non ha velocità lungo sé stesso: il contatto è in T1"});
  }
  T specific_2() const {
    return over(of_2 - of_1, of_2,
                {"flank 2 has no velocity along itself there: contact is at T2",
                 "lì il fianco 2 non ha velocità lungo sé stesso: il contatto è in T2"});
  }

 private:
  static T over(const T& sliding, const T& own, const Phrase& when_zero) {
    if (sign(own) == Sign::zero) throw Impossible(when_zero);
    return quotient(sliding, own);
  }
};

// At a point of the line of action.
template <class T>
FlankVelocities<T> flank_velocities(const GearPair<T>& pair, const T& omega_1, const Point<T>& at) {
  const Vector<T> tangent = quarter_turn(pair.line_of_action.direction());
  const Vector<T> v1 = omega_1 * quarter_turn(at - pair.O1);
  const Vector<T> v2 = pair.O2 ? pair_speeds(pair, omega_1).omega_2 * quarter_turn(at - *pair.O2)
                               : omega_1 * quarter_turn(pair.P0 - pair.O1);
  return {dot(v1, tangent), dot(v2, tangent)};
}

}  // namespace epure::geometry
