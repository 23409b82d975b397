#include "geometry/numbers/exact.h"

#include "geometry/numbers/tower.h"
#include "geometry/numbers/turn.h"

#include <cassert>
#include <utility>

namespace epure::geometry {

namespace {

thread_local Tower<Rational>* innermost_tower = nullptr;

Tower<Rational>& current_tower() {
  assert(innermost_tower && "Exact is used without an Arithmetic<Exact> scope");
  return *innermost_tower;
}

Deep ball_around(const Tower<Rational>& tower, const Surd<Rational>& x) {
  return tower.to_deep(x, [](const Rational& value) { return from_rational<Deep>(value); });
}

Sign sign_in(const Tower<Rational>& tower, const Surd<Rational>& x) {
  if (x.is_in_field()) return static_cast<Sign>(static_cast<int>(CGAL::sign(x.in_field())));
  for (long bits = 64;; bits *= 2) {
    const Arithmetic<Deep> scope(bits);
    if (const Sign found = sign(ball_around(tower, x)); found != Sign::undecided) return found;
  }
}

}  // namespace

// No square of a real field is negative.
Arithmetic<Exact>::Arithmetic()
    : tower_(std::make_unique<Tower<Rational>>(
          [this](const Surd<Rational>& x) { return sign_in(*tower_, x) == Sign::negative; })),
      outer_(std::exchange(innermost_tower, tower_.get())) {}
Arithmetic<Exact>::~Arithmetic() { innermost_tower = outer_; }

int Arithmetic<Exact>::storeys() { return current_tower().storeys(); }

Exact operator+(const Exact& a, const Exact& b) { return Exact(current_tower().add(a.surd_, b.surd_)); }
Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
Exact operator*(const Exact& a, const Exact& b) { return Exact(current_tower().multiply(a.surd_, b.surd_)); }

Exact operator/(const Exact& a, const Exact& b) {
  assert(!b.is_zero() && "exact division by zero");
  return Exact(current_tower().multiply(a.surd_, current_tower().inverse(b.surd_)));
}

Exact Exact::operator-() const { return Exact(-surd_); }

Deep to_deep(const Exact& x) { return ball_around(current_tower(), x.surd_); }

Sign sign(const Exact& x) { return sign_in(current_tower(), x.surd_); }

Exact root(const Exact& x) {
  if (x.is_zero()) return 0;
  assert(sign(x) == Sign::positive && "root of a negative number");
  Tower<Rational>& tower = current_tower();
  if (const auto found = tower.root_within(x.surd_))
    return Exact(sign_in(tower, *found) == Sign::negative ? -*found : *found);
  if (tower.storeys() == Arithmetic<Exact>::highest_storey)
    throw LeavesTheTower("more than five independent roots", "più di cinque radici indipendenti");
  return Exact(tower.adjoin(x.surd_));
}

Exact quotient(const Exact& a, const Exact& b) {
  if (b.is_zero())
    throw Undecided("division by a quantity that is proved to be zero",
                    "divisione per una grandezza che è zero, come è dimostrato");
  return a / b;
}

template <>
Exact pi<Exact>() {
  throw LeavesTheTower("pi is not the root of a polynomial", "pi greco non è radice di un polinomio");
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
  if (fifteens.denominator() != 1)
    throw LeavesTheTower("a direction that is no multiple of 15 degrees",
                         "una direzione che non è multipla di 15 gradi");
  int n = static_cast<int>(fifteens.to_double());
  if (n > 12) n = 24 - n;
  return n <= 6 ? cosine_in_quadrant(n) : -cosine_in_quadrant(12 - n);
}

template <>
Exact sine<Exact>(const Turn& turn) {
  return cosine<Exact>(turn_for_sine(turn));
}

}  // namespace epure::geometry
