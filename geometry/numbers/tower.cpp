#include "geometry/numbers/tower.h"

#include <gmp.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>

namespace epure::geometry {

namespace {

thread_local Tower* innermost_tower = nullptr;

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

std::optional<Rational> rational_root(const Rational& x) {
  const auto numerator = x.numerator();
  const auto denominator = x.denominator();
  if (!mpz_perfect_square_p(numerator.mpz()) || !mpz_perfect_square_p(denominator.mpz())) return std::nullopt;
  CGAL::Gmpz n, d;
  mpz_sqrt(n.mpz(), numerator.mpz());
  mpz_sqrt(d.mpz(), denominator.mpz());
  return Rational(n, d);
}

}  // namespace

Arithmetic<Exact>::Arithmetic()
    : tower_(std::make_unique<Tower>()), outer_(std::exchange(innermost_tower, tower_.get())) {}
Arithmetic<Exact>::~Arithmetic() { innermost_tower = outer_; }

Tower::Tower() : serial_(next_serial()) {}

Tower& Tower::current() {
  assert(innermost_tower && "Exact is used without an Arithmetic<Exact> scope");
  return *innermost_tower;
}

void Tower::require_ours(const Exact& x) const {
  assert((x.tower_ == 0 || x.tower_ == serial_) && "a number from another Arithmetic<Exact> scope");
}

// Drops upper halves that are zero, so that the number lives on the lowest storey it can.
Exact Tower::number(Coefficients coefficients) const {
  const auto is_zero = [](const Rational& c) { return CGAL::is_zero(c); };
  while (coefficients.size() > 1) {
    const auto middle = coefficients.begin() + static_cast<std::ptrdiff_t>(coefficients.size() / 2);
    if (!std::all_of(middle, coefficients.end(), is_zero)) break;
    coefficients.erase(middle, coefficients.end());
  }
  Exact result;
  result.coefficients_ = std::move(coefficients);
  result.tower_ = result.is_rational() ? 0 : serial_;
  return result;
}

Tower::Halves Tower::halves(const Exact& x, int storey) const {
  if (x.storey() < storey) return {x, 0};
  const auto middle = x.coefficients_.begin() + static_cast<std::ptrdiff_t>(x.coefficients_.size() / 2);
  return {number(Coefficients(x.coefficients_.begin(), middle)), number(Coefficients(middle, x.coefficients_.end()))};
}

Exact Tower::join(const Exact& lower, const Exact& upper, int storey) const {
  const std::size_t half = std::size_t{1} << (storey - 1);
  Coefficients coefficients(2 * half, Rational(0));
  std::copy(lower.coefficients_.begin(), lower.coefficients_.end(), coefficients.begin());
  std::copy(upper.coefficients_.begin(), upper.coefficients_.end(),
            coefficients.begin() + static_cast<std::ptrdiff_t>(half));
  return number(std::move(coefficients));
}

Exact Tower::add(const Exact& a, const Exact& b) const {
  require_ours(a);
  require_ours(b);
  const bool a_is_higher = a.storey() >= b.storey();
  Coefficients sum = (a_is_higher ? a : b).coefficients_;
  const Coefficients& other = (a_is_higher ? b : a).coefficients_;
  for (std::size_t i = 0; i < other.size(); ++i) sum[i] += other[i];
  return number(std::move(sum));
}

Exact Tower::multiply(const Exact& a, const Exact& b) const {
  require_ours(a);
  require_ours(b);
  if (a.is_zero() || b.is_zero()) return 0;
  if (a.is_rational() && b.is_rational()) return Exact(a.rational() * b.rational());
  const int storey = std::max(a.storey(), b.storey());
  const auto [a0, a1] = halves(a, storey);
  const auto [b0, b1] = halves(b, storey);
  if (a1.is_zero()) return join(multiply(a0, b0), multiply(a0, b1), storey);
  if (b1.is_zero()) return join(multiply(a0, b0), multiply(a1, b0), storey);
  const Exact& radicand = radicands_[static_cast<std::size_t>(storey - 1)];
  return join(add(multiply(a0, b0), multiply(multiply(a1, b1), radicand)), add(multiply(a0, b1), multiply(a1, b0)),
              storey);
}

// 1/(a + b√d) = (a - b√d)/(a² - b²d); the norm is not zero because d has no root on the storey below.
Exact Tower::inverse(const Exact& x) const {
  require_ours(x);
  if (x.is_rational()) return Exact(Rational(1) / x.rational());
  const int storey = x.storey();
  const auto [a, b] = halves(x, storey);
  const Exact& radicand = radicands_[static_cast<std::size_t>(storey - 1)];
  const Exact norm = add(multiply(a, a), -multiply(multiply(b, b), radicand));
  const Exact scale = inverse(norm);
  return join(multiply(a, scale), -multiply(b, scale), storey);
}

// Decides x = y² for y in the field of this storey, by descent to rational numbers.
std::optional<Exact> Tower::root_within(const Exact& x, int storey) const {
  if (x.is_zero()) return x;
  if (sign(x) == Sign::negative) return std::nullopt;  // no square in a real field: saves the descent
  if (storey == 0) {
    const auto found = rational_root(x.rational());
    return found ? std::optional(Exact(*found)) : std::nullopt;
  }
  const Halves parts = halves(x, storey);
  return parts.upper.is_zero() ? root_of_lower(parts.lower, storey) : root_of_mixed(parts, storey);
}

// (p + q√d)² has no √d exactly when p or q is zero: x = p² or x = q²d.
std::optional<Exact> Tower::root_of_lower(const Exact& x, int storey) const {
  if (auto found = root_within(x, storey - 1)) return found;
  const Exact& radicand = radicands_[static_cast<std::size_t>(storey - 1)];
  const auto factor = root_within(multiply(x, inverse(radicand)), storey - 1);
  return factor ? std::optional(join(0, *factor, storey)) : std::nullopt;
}

// (p + q√d)² = a + b√d with b ≠ 0: the norm a² - b²d = (p² - q²d)² must be a square s², and then p² = (a ± s)/2,
// q = b/2p. (p = 0 would make b = 0.)
std::optional<Exact> Tower::root_of_mixed(const Halves& x, int storey) const {
  const auto& [a, b] = x;
  const Exact& radicand = radicands_[static_cast<std::size_t>(storey - 1)];
  const auto s = root_within(add(multiply(a, a), -multiply(multiply(b, b), radicand)), storey - 1);
  if (!s) return std::nullopt;
  const Exact half(Rational(1, 2));
  for (const Exact& p_squared : {multiply(add(a, *s), half), multiply(add(a, -*s), half)}) {
    const auto p = root_within(p_squared, storey - 1);
    if (p) return join(*p, multiply(multiply(b, half), inverse(*p)), storey);
  }
  return std::nullopt;
}

Exact Tower::adjoin(const Exact& x) {
  require_ours(x);
  radicands_.push_back(x);
  return join(0, 1, storeys());
}

Deep Tower::to_deep(const Exact& x) const {
  require_ours(x);
  if (x.is_rational()) return from_rational<Deep>(x.rational());
  const auto [a, b] = halves(x, x.storey());
  const Deep radicand = to_deep(radicands_[static_cast<std::size_t>(x.storey() - 1)]);
  return to_deep(a) + to_deep(b) * epure::geometry::root(radicand);
}

}  // namespace epure::geometry
