#include "geometry/numbers/polynomial.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/round_to_nearest.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace epure::geometry {

Polynomial::Polynomial(const Rational& value) : Polynomial() {
  fmpq_t fraction;
  fmpq_init(fraction);
  fmpq_set_mpq(fraction, value.mpq());
  fmpq_poly_set_fmpq(terms_, fraction);
  fmpq_clear(fraction);
}

Polynomial Polynomial::indeterminate() {
  Polynomial x;
  fmpq_poly_set_coeff_si(x.terms_, 1, 1);
  return x;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial sum;
  fmpq_poly_add(sum.terms_, a.terms_, b.terms_);
  return sum;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial difference;
  fmpq_poly_sub(difference.terms_, a.terms_, b.terms_);
  return difference;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product;
  fmpq_poly_mul(product.terms_, a.terms_, b.terms_);
  return product;
}

struct RealRoot::SquareFree {
  fmpz_poly_t terms;

  explicit SquareFree(const fmpq_poly_t of) {
    fmpz_poly_init(terms);
    fmpz_poly_t repeated;
    fmpz_poly_init(repeated);
    fmpq_poly_get_numerator(terms, of);
    fmpz_poly_derivative(repeated, terms);
    fmpz_poly_gcd(repeated, repeated, terms);
    fmpz_poly_div(terms, terms, repeated);
    fmpz_poly_clear(repeated);
  }
  SquareFree(const SquareFree&) = delete;
  SquareFree& operator=(const SquareFree&) = delete;
  ~SquareFree() { fmpz_poly_clear(terms); }

  // So many that a root times the leading coefficient, which is no greater than twice the greatest coefficient, is
  // known to much less than one.
  long bits_that_tell_a_rational_root() const { return std::abs(fmpz_poly_max_bits(terms)) + 32; }

  // To `bits` of relative accuracy; Arb puts the real ones first, in ascending order.
  std::vector<Deep> real_roots(long bits) const {
    const RoundToNearest rounding;
    const slong degree = fmpz_poly_degree(terms);
    const acb_ptr all = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(all, terms, 0, bits);
    std::vector<Deep> real;
    for (slong i = 0; i < degree && acb_is_real(all + i); ++i) real.push_back(Deep::from_ball(acb_realref(all + i)));
    _acb_vec_clear(all, degree);
    return real;
  }

  // The rational number that the root is, if it is one: times the leading coefficient it then is an integer (Gauss).
  std::optional<Rational> rational(const Deep& root) const {
    fmpq_t candidate;
    fmpq_init(candidate);
    fmpz* const leading = fmpq_denref(candidate);
    fmpz_poly_get_coeff_fmpz(leading, terms, fmpz_poly_degree(terms));
    Ball integer;
    arb_mul_fmpz(integer.value, root.ball(), leading, bits_that_tell_a_rational_root() + 64);
    std::optional<Rational> found;
    if (arb_get_unique_fmpz(fmpq_numref(candidate), integer.value)) {
      fmpq_canonicalise(candidate);
      fmpq_t value;
      fmpq_init(value);
      fmpz_poly_evaluate_fmpq(value, terms, candidate);
      if (fmpq_is_zero(value)) {
        found.emplace();
        fmpq_get_mpq(found->mpq(), candidate);
      }
      fmpq_clear(value);
    }
    fmpq_clear(candidate);
    return found;
  }
};

RealRoot::RealRoot(std::shared_ptr<const SquareFree> of, std::size_t number, Deep found, long bits)
    : of_(std::move(of)), number_(number), found_(std::move(found)), bits_(bits), rational_(of_->rational(found_)) {}

Deep RealRoot::value() const {
  if (rational_) return from_rational<Deep>(*rational_);
  const long bits = Arithmetic<Deep>::bits();
  return bits <= bits_ ? found_ : of_->real_roots(bits).at(number_);
}

std::vector<RealRoot> Polynomial::real_roots() const {
  assert(!fmpq_poly_is_zero(terms_));
  const auto squarefree = std::make_shared<const RealRoot::SquareFree>(terms_);
  const long bits = std::max(512L, squarefree->bits_that_tell_a_rational_root());
  std::vector<RealRoot> roots;
  for (Deep& root : squarefree->real_roots(bits))
    roots.push_back(RealRoot(squarefree, roots.size(), std::move(root), bits));
  return roots;
}

}  // namespace epure::geometry
