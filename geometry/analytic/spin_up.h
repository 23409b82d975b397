// A wheel at rest set turning by the friction of the ground on which its load slides: constant forces, and some that
// grow with the square of the speed v,
//   v' = -(A + B v²)        ω' = C + D v²        A, C > 0, B and D of any sign.
// In closed form, by tan or tanh of √|AB| t, or polynomials where B = 0; and by power series of the same equations,
// term by term, with what is left out bounded: these share nothing.
//
// The closed form divides differences by B: beside B = 0 they cancel, and it asks for more bits (accurate.h).
#pragma once

#include "geometry/numbers/deep.h"

namespace epure::geometry::analytic {

struct SpinUp {
  Rational A, B, C, D;
  Rational v_0, omega_0, R;  // R ω_0 < v_0, and ω' > 0 from v_0 down to 0
};

// After a time t. The integrals run from 0 to t.
struct SpinState {
  Deep t, v, omega;
  Deep path;      // of v
  Deep angle;     // of ω
  Deep cubes;     // of v³
  Deep of_wheel;  // of ω' ω
  Deep of_load;   // of ω' v
};

// t >= 0, before the load stands still.
SpinState spun_up(const SpinUp& of, const Deep& t);
SpinState spun_up_by_series(const SpinUp& of, const Deep& t);
// The same, going on from a state it was in before t.
SpinState spun_up_by_series(const SpinUp& of, const SpinState& from, const Deep& t);

// When R ω = v: the root proved by the signs of v - R ω, which falls, on both sides.
SpinState end_of_slip(const SpinUp& of);
SpinState end_of_slip_by_series(const SpinUp& of);

}  // namespace epure::geometry::analytic
