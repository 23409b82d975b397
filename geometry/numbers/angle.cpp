#include "geometry/numbers/angle.h"

#include <gmp.h>

#include <numbers>

namespace epure::geometry {

namespace {

Rational floor_of(const Rational& x) {
  const CGAL::Gmpz numerator = x.numerator(), denominator = x.denominator();
  CGAL::Gmpz whole;
  mpz_fdiv_q(whole.mpz(), numerator.mpz(), denominator.mpz());
  return Rational(whole);
}

}  // namespace

int sign_of(const Angle& angle) {
  if (angle.turns == 0) return static_cast<int>(CGAL::sign(angle.radians));
  if (angle.radians == 0) return static_cast<int>(CGAL::sign(angle.turns));
  {
    const Arithmetic<Bounded> scope;
    if (const Sign decided = sign(radians<Bounded>(angle)); decided != Sign::undecided)
      return static_cast<int>(decided);
  }
  // Not zero, because π is irrational: some number of bits tells.
  for (long bits = 128;; bits *= 2) {
    const Arithmetic<Deep> scope(bits);
    const Sign decided = sign(radians<Deep>(angle));
    if (decided != Sign::undecided) return static_cast<int>(decided);
  }
}

Rational whole_turns(const Angle& angle) {
  // 2π lies between 6 and 7: a guess that is off by part of the radians, then by bisection between two whole numbers
  // of which the angle is certainly between.
  Rational below = floor_of(angle.turns + angle.radians * (angle.radians < 0 ? Rational(1, 6) : Rational(1, 7)));
  Rational above = floor_of(angle.turns + angle.radians * (angle.radians < 0 ? Rational(1, 7) : Rational(1, 6))) + 1;
  while (above - below > 1) {
    const Rational middle = floor_of((below + above) / 2);
    (sign_of(angle - Angle{middle}) < 0 ? above : below) = middle;
  }
  return below;
}

std::optional<Rational> ratio(const Angle& a, const Angle& b) {
  if (a.radians == 0 && b.radians == 0) return a.turns / b.turns;
  if (a.turns == 0 && b.turns == 0) return a.radians / b.radians;
  if (is_zero(a)) return 0;
  return std::nullopt;
}

double degrees(const Angle& angle) {
  return 360 * CGAL::to_double(angle.turns) + CGAL::to_double(angle.radians) * 180 / std::numbers::pi;
}

double to_double(const Angle& angle) {
  return CGAL::to_double(angle.radians) + 2 * CGAL::to_double(angle.turns) * std::numbers::pi;
}

FromRightAngle from_right_angle(const Angle& angle) {
  const Rational nearest = floor_of(Rational(4) * angle.turns + Rational(1, 2));
  const Rational in_turn = nearest - Rational(4) * floor_of(nearest / 4);
  return {static_cast<int>(in_turn.to_double()), angle - Angle{nearest / 4}};
}

}  // namespace epure::geometry
