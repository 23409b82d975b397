#include "geometry/numbers/tower.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <type_traits>
#include <utility>

namespace epure::geometry {

namespace {

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// --- products of rational elements, without fractions ---
// Each product and sum of fractions would seek a common divisor, which takes most of the time. So an element is told
// by integers over one denominator; a product seeks one divisor for each of its coefficients.
using Integer = CGAL::Gmpz;
using Integers = std::vector<Integer>;  // as Surd's coefficients

Integer common_denominator(const std::vector<Rational>& coefficients) {
  Integer all(1);
  for (const Rational& c : coefficients) {
    const Integer denominator = c.denominator();
    mpz_lcm(all.mpz(), all.mpz(), denominator.mpz());
  }
  return all;
}

Integers over(const Integer& denominator, const std::vector<Rational>& coefficients) {
  Integers numerators;
  for (const Rational& c : coefficients) numerators.push_back(c.numerator() * (denominator / c.denominator()));
  return numerators;
}

bool is_zero(const Integers& x) {
  return std::all_of(x.begin(), x.end(), [](const Integer& c) { return CGAL::is_zero(c); });
}

Integers sum(Integers a, const Integers& b) {
  if (a.size() < b.size()) a.resize(b.size(), Integer(0));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
  return a;
}

Integers difference(Integers a, const Integers& b) {
  if (a.size() < b.size()) a.resize(b.size(), Integer(0));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  return a;
}

Integers joined(Integers lower, const Integers& upper, std::size_t half) {
  lower.resize(2 * half, Integer(0));
  std::copy(upper.begin(), upper.end(), lower.begin() + static_cast<std::ptrdiff_t>(half));
  return lower;
}

// (a0 + a1√d)(b0 + b1√d) by three products (Karatsuba). `radicands`: d of each storey.
Integers product(const Integers& a, const Integers& b, const std::vector<Integers>& radicands) {
  if (a.size() < b.size()) return product(b, a, radicands);
  if (is_zero(a) || is_zero(b)) return {Integer(0)};
  if (a.size() == 1) return {a[0] * b[0]};
  const std::size_t half = a.size() / 2;
  const auto middle = static_cast<std::ptrdiff_t>(half);
  const Integers a0(a.begin(), a.begin() + middle), a1(a.begin() + middle, a.end());
  if (b.size() <= half) return joined(product(a0, b, radicands), product(a1, b, radicands), half);
  const Integers b0(b.begin(), b.begin() + middle), b1(b.begin() + middle, b.end());
  const Integers without = product(a0, b0, radicands), both = product(a1, b1, radicands),
                 all = product(sum(a0, a1), sum(b0, b1), radicands);
  const Integers& d = radicands[static_cast<std::size_t>(std::countr_zero(half))];
  return joined(sum(without, product(both, d, radicands)), difference(difference(all, without), both), half);
}

}  // namespace

template <class Field>
Tower<Field>::Tower(std::function<bool(const Element&)> is_no_square)
    : is_no_square_(std::move(is_no_square)), serial_(next_serial()) {}

template <class Field>
void Tower<Field>::require_ours(const Element& x) const {
  assert((x.tower_ == 0 || x.tower_ == serial_) && "a number from another scope");
}

// Drops upper halves that are zero, so that the number lives on the lowest storey it can.
template <class Field>
Surd<Field> Tower<Field>::number(Coefficients coefficients) const {
  const auto vanishes = [](const Field& c) { return FieldOf<Field>::is_zero(c); };
  while (coefficients.size() > 1) {
    const auto middle = coefficients.begin() + static_cast<std::ptrdiff_t>(coefficients.size() / 2);
    if (!std::all_of(middle, coefficients.end(), vanishes)) break;
    coefficients.erase(middle, coefficients.end());
  }
  Element result(Field(0));
  result.coefficients_ = std::move(coefficients);
  result.tower_ = result.is_in_field() ? 0 : serial_;
  return result;
}

template <class Field>
typename Tower<Field>::Halves Tower<Field>::halves(const Element& x, int storey) const {
  if (x.storey() < storey) return {x, Element(Field(0))};
  const auto middle = x.coefficients_.begin() + static_cast<std::ptrdiff_t>(x.coefficients_.size() / 2);
  return {number(Coefficients(x.coefficients_.begin(), middle)), number(Coefficients(middle, x.coefficients_.end()))};
}

template <class Field>
Surd<Field> Tower<Field>::join(const Element& lower, const Element& upper, int storey) const {
  const std::size_t half = std::size_t{1} << (storey - 1);
  Coefficients coefficients(2 * half, Field(0));
  std::copy(lower.coefficients_.begin(), lower.coefficients_.end(), coefficients.begin());
  std::copy(upper.coefficients_.begin(), upper.coefficients_.end(),
            coefficients.begin() + static_cast<std::ptrdiff_t>(half));
  return number(std::move(coefficients));
}

template <class Field>
Surd<Field> Tower<Field>::add(const Element& a, const Element& b) const {
  require_ours(a);
  require_ours(b);
  const bool a_is_higher = a.storey() >= b.storey();
  Coefficients sum = (a_is_higher ? a : b).coefficients_;
  const Coefficients& other = (a_is_higher ? b : a).coefficients_;
  for (std::size_t i = 0; i < other.size(); ++i) sum[i] = sum[i] + other[i];
  return number(std::move(sum));
}

template <class Field>
Surd<Field> Tower<Field>::multiply(const Element& a, const Element& b) const {
  require_ours(a);
  require_ours(b);
  if (a.is_zero() || b.is_zero()) return Element(Field(0));
  if (a.is_in_field() && b.is_in_field()) return Element(a.in_field() * b.in_field());
  const int storey = std::max(a.storey(), b.storey());
  const auto [a0, a1] = halves(a, storey);
  const auto [b0, b1] = halves(b, storey);
  if (a1.is_zero()) return join(multiply(a0, b0), multiply(a0, b1), storey);
  if (b1.is_zero()) return join(multiply(a0, b0), multiply(a1, b0), storey);
  return join(add(multiply(a0, b0), multiply(multiply(a1, b1), radicand(storey))),
              add(multiply(a0, b1), multiply(a1, b0)), storey);
}

template <>
Surd<Rational> Tower<Rational>::multiply(const Element& a, const Element& b) const {
  require_ours(a);
  require_ours(b);
  if (a.is_in_field() && b.is_in_field()) return Element(a.in_field() * b.in_field());
  std::vector<Integers> radicands;
  for (const Element& d : radicands_) radicands.push_back(over(Integer(1), d.coefficients_));
  const Integer of_a = common_denominator(a.coefficients_), of_b = common_denominator(b.coefficients_),
                of_both = of_a * of_b;
  Coefficients coefficients;
  for (const Integer& c : product(over(of_a, a.coefficients_), over(of_b, b.coefficients_), radicands))
    coefficients.emplace_back(c, of_both);
  return number(std::move(coefficients));
}

// 1/(a + b√d) = (a - b√d)/(a² - b²d); the norm is not zero because d has no root on the storey below.
template <class Field>
Surd<Field> Tower<Field>::inverse(const Element& x) const {
  require_ours(x);
  if (x.is_in_field()) return Element(Field(1) / x.in_field());
  const int storey = x.storey();
  const auto [a, b] = halves(x, storey);
  const Element norm = add(multiply(a, a), -multiply(multiply(b, b), radicand(storey)));
  const Element scale = inverse(norm);
  return join(multiply(a, scale), -multiply(b, scale), storey);
}

// Decides x = y² for y in the field of this storey, by descent to F.
template <class Field>
std::optional<Surd<Field>> Tower<Field>::root_within(const Element& x, int storey) const {
  if (x.is_zero()) return x;
  if (is_no_square_(x)) return std::nullopt;  // saves the descent
  if (storey == 0) {
    const auto found = FieldOf<Field>::root(x.in_field());
    return found ? std::optional(Element(*found)) : std::nullopt;
  }
  const Halves parts = halves(x, storey);
  return parts.upper.is_zero() ? root_of_lower(parts.lower, storey) : root_of_mixed(parts, storey);
}

// (p + q√d)² has no √d exactly when p or q is zero: x = p² or x = q²d.
template <class Field>
std::optional<Surd<Field>> Tower<Field>::root_of_lower(const Element& x, int storey) const {
  if (auto found = root_within(x, storey - 1)) return found;
  const auto factor = root_within(multiply(x, inverse(radicand(storey))), storey - 1);
  return factor ? std::optional(join(Element(Field(0)), *factor, storey)) : std::nullopt;
}

// (p + q√d)² = a + b√d with b ≠ 0: the norm a² - b²d = (p² - q²d)² must be a square s², and then p² = (a ± s)/2,
// q = b/2p. (p = 0 would make b = 0.)
template <class Field>
std::optional<Surd<Field>> Tower<Field>::root_of_mixed(const Halves& x, int storey) const {
  const auto& [a, b] = x;
  const auto s = root_within(add(multiply(a, a), -multiply(multiply(b, b), radicand(storey))), storey - 1);
  if (!s) return std::nullopt;
  const Element half(Field(Rational(1, 2)));
  for (const Element& p_squared : {multiply(add(a, *s), half), multiply(add(a, -*s), half)}) {
    const auto p = root_within(p_squared, storey - 1);
    if (p) return join(*p, multiply(multiply(b, half), inverse(*p)), storey);
  }
  return std::nullopt;
}

// Of rational elements the radicand is made one of integers: √x = √(q²x)/q.
template <class Field>
Surd<Field> Tower<Field>::adjoin(const Element& x) {
  require_ours(x);
  Field q(1);
  if constexpr (std::is_same_v<Field, Rational>) q = Rational(common_denominator(x.coefficients_));
  radicands_.push_back(multiply(x, Element(q * q)));
  return join(Element(Field(0)), Element(Field(1) / q), storeys());
}

template class Tower<Rational>;
template class Tower<RationalFunction>;

}  // namespace epure::geometry
