// A bar turns about a hinge O on a body that translates along x. O is the origin; V and a are positive towards +x, θ,
// ω and dω/dt counter-clockwise. Metres, seconds, radians.
#pragma once

#include "exercises/kit/statement/givens.h"

namespace epure::velocity_centre {

struct Instant {
  Rational L;
  Angle angle;  // θ, of OA from +x
  Angle omega, omega_dot;
  Rational V, a;

  explicit Instant(const Givens& givens)
      : L(givens["L"]),
        angle(givens.angle("phi")),
        omega(givens.angle("omega")),
        omega_dot(givens.angle("omega_dot")),
        V(givens["V"]),
        a(givens["a"]) {}

  // Special positions, decided exactly.
  bool turns() const { return !is_zero(omega); }
  // OA square to x: then v_O and v_A are parallel, and one line is normal to both.
  bool is_upright() const {
    const Rational quarters = 4 * angle.turns;
    return angle.radians == 0 && quarters.denominator() == 1 && mpz_odd_p(quarters.numerator().mpz()) != 0;
  }
};

// How the velocity centre is found, or why there is none.
enum class Centre {
  by_two_normals,
  by_the_tips,  // both normals are the line OA: it is met by the line through the tips of v_O and v_A
  is_O,         // O rests
  at_infinity,  // the bar translates
  everywhere    // the bar rests
};
inline Centre centre_of(const Instant& instant) {
  if (!instant.turns()) return instant.V == 0 ? Centre::everywhere : Centre::at_infinity;
  if (instant.V == 0) return Centre::is_O;
  return instant.is_upright() ? Centre::by_the_tips : Centre::by_two_normals;
}

}  // namespace epure::velocity_centre
