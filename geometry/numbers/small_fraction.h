// Rational numbers of two small whole ones, as nearly all givens are: one division gives the number, rounded as
// wanted.
#pragma once

#include "geometry/numbers/number.h"

#include <gmp.h>

#include <optional>

namespace epure::geometry {

struct SmallFraction {
  double numerator, denominator;
};

// None when a double does not hold both.
inline std::optional<SmallFraction> small_fraction(const Rational& value) {
  const mpz_srcptr numerator = mpq_numref(value.mpq()), denominator = mpq_denref(value.mpq());
  constexpr std::size_t digits = 53;
  if (mpz_sizeinbase(numerator, 2) > digits || mpz_sizeinbase(denominator, 2) > digits) return {};
  return SmallFraction{mpz_get_d(numerator), mpz_get_d(denominator)};
}

}  // namespace epure::geometry
