#include "geometry/numbers/turn.h"

#include <gmp.h>

namespace epure::geometry {

Turn within_one_turn(const Turn& turn) {
  const CGAL::Gmpz numerator = turn.fraction.numerator();
  const CGAL::Gmpz denominator = turn.fraction.denominator();
  CGAL::Gmpz remainder;
  mpz_fdiv_r(remainder.mpz(), numerator.mpz(), denominator.mpz());
  return {Rational(remainder, denominator)};
}

Turn turn_for_sine(const Turn& turn) { return {turn.fraction - Rational(1, 4)}; }

std::optional<Rational> rational_cosine(const Turn& turn) {
  const Rational twelfths = Rational(12) * within_one_turn(turn).fraction;
  if (twelfths.denominator() != 1) return std::nullopt;
  switch (static_cast<int>(twelfths.to_double())) {
    case 0:
      return Rational(1);
    case 2:
    case 10:
      return Rational(1, 2);
    case 3:
    case 9:
      return Rational(0);
    case 4:
    case 8:
      return Rational(-1, 2);
    case 6:
      return Rational(-1);
    default:
      return std::nullopt;
  }
}

}  // namespace epure::geometry
