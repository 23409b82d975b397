// What a tower of roots asks of the rational numbers (see tower.h).
#pragma once

#include "geometry/numbers/number.h"
#include "geometry/numbers/surd.h"

#include <gmp.h>

#include <optional>

namespace epure::geometry {

template <>
struct FieldOf<Rational> {
  static bool is_zero(const Rational& x) { return CGAL::is_zero(x); }

  static std::optional<Rational> root(const Rational& x) {
    const auto numerator = x.numerator();
    const auto denominator = x.denominator();
    if (!mpz_perfect_square_p(numerator.mpz()) || !mpz_perfect_square_p(denominator.mpz())) return std::nullopt;
    CGAL::Gmpz n, d;
    mpz_sqrt(n.mpz(), numerator.mpz());
    mpz_sqrt(d.mpz(), denominator.mpz());
    return Rational(n, d);
  }
};

}  // namespace epure::geometry
