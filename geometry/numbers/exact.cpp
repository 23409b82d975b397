#include "geometry/numbers/exact.h"

#include "geometry/numbers/tower.h"
#include "geometry/numbers/turn.h"

#include <bit>
#include <cassert>

namespace epure::geometry {

Exact operator+(const Exact& a, const Exact& b) { return Tower::current().add(a, b); }
Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
Exact operator*(const Exact& a, const Exact& b) { return Tower::current().multiply(a, b); }

Exact operator/(const Exact& a, const Exact& b) {
  assert(!b.is_zero() && "exact division by zero");
  return a * Tower::current().inverse(b);
}

Exact Exact::operator-() const {
  Exact result = *this;
  for (Rational& coefficient : result.coefficients_) coefficient = -coefficient;
  return result;
}

bool Exact::is_zero() const { return is_rational() && CGAL::is_zero(coefficients_.front()); }

const Rational& Exact::rational() const {
  assert(is_rational());
  return coefficients_.front();
}

int Exact::storey() const { return std::countr_zero(coefficients_.size()); }

int Arithmetic<Exact>::storeys() { return Tower::current().storeys(); }

Deep to_deep(const Exact& x) { return Tower::current().to_deep(x); }

Sign sign(const Exact& x) {
  if (x.is_rational()) return static_cast<Sign>(static_cast<int>(CGAL::sign(x.rational())));
  for (long bits = 64;; bits *= 2) {
    const Arithmetic<Deep> scope(bits);
    if (const Sign found = sign(to_deep(x)); found != Sign::undecided) return found;
  }
}

Exact root(const Exact& x) {
  if (x.is_zero()) return 0;
  assert(sign(x) == Sign::positive && "root of a negative number");
  Tower& tower = Tower::current();
  if (const auto found = tower.root_within(x)) return sign(*found) == Sign::negative ? -*found : *found;
  if (tower.storeys() == Arithmetic<Exact>::highest_storey) throw LeavesTheTower("more than five independent roots");
  return tower.adjoin(x);
}

Exact quotient(const Exact& a, const Exact& b) {
  if (b.is_zero()) throw Undecided("division by a quantity that is proved to be zero");
  return a / b;
}

template <>
Exact pi<Exact>() {
  throw LeavesTheTower("pi is not the root of a polynomial");
}

namespace {

// The cosine of a multiple of 15° between 0 and 90°.
Exact cosine_in_quadrant(int fifteens) {
  switch (fifteens) {
    case 1:
      return root(Exact(2)) * (root(Exact(3)) + 1) / 4;
    case 2:
      return root(Exact(3)) / 2;
    case 3:
      return root(Exact(2)) / 2;
    case 5:
      return root(Exact(2)) * (root(Exact(3)) - 1) / 4;
    default:
      assert(false && "the rational cosines are known before");
      return 0;
  }
}

}  // namespace

template <>
Exact cosine<Exact>(const Turn& turn) {
  if (const auto known = rational_cosine(turn)) return Exact(*known);
  const Rational fifteens = Rational(24) * within_one_turn(turn).fraction;
  if (fifteens.denominator() != 1) throw LeavesTheTower("a direction that is no multiple of 15 degrees");
  int n = static_cast<int>(fifteens.to_double());
  if (n > 12) n = 24 - n;
  return n <= 6 ? cosine_in_quadrant(n) : -cosine_in_quadrant(12 - n);
}

template <>
Exact sine<Exact>(const Turn& turn) {
  return cosine<Exact>(turn_for_sine(turn));
}

}  // namespace epure::geometry
