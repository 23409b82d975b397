// Exact: an element of a tower of real quadratic fields, Q in Q(√a) in Q(√a)(√b) ..., at most five high.
//
// The tower belongs to the innermost Arithmetic<Exact> scope of the thread and starts as Q. root(x) first decides
// whether x already has its root in the tower and only otherwise adds a storey, so that every storey is a true field
// extension. Two things follow, and everything here rests on them:
//   - the coefficients of a number are unique, so it is zero exactly when all of them are (no bound, no search);
//   - division is safe: no conjugate of a nonzero number vanishes.
// The sign of a nonzero number is read from a ball around it, narrowed until it leaves zero: that ends, because the
// number is not zero.
//
// CGAL::Sqrt_extension nested five deep would store 3^5 rationals in every number and repeat the radicands in each;
// here a number holds the 2^k coefficients of the lowest storey it lives on, and the tower holds the radicands once.
#pragma once

#include "geometry/numbers/deep.h"
#include "geometry/numbers/number.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace epure::geometry {

class Tower;

class Exact {
 public:
  Exact() : Exact(Rational(0)) {}
  Exact(int value) : Exact(Rational(value)) {}
  explicit Exact(const Rational& value) : coefficients_{value} {}

  Exact& operator+=(const Exact& other) { return *this = *this + other; }
  Exact& operator-=(const Exact& other) { return *this = *this - other; }
  Exact& operator*=(const Exact& other) { return *this = *this * other; }
  Exact& operator/=(const Exact& other) { return *this = *this / other; }

  friend Exact operator+(const Exact& a, const Exact& b);
  friend Exact operator-(const Exact& a, const Exact& b);
  friend Exact operator*(const Exact& a, const Exact& b);
  friend Exact operator/(const Exact& a, const Exact& b);  // b = 0 is a caller's mistake
  Exact operator-() const;

  bool is_zero() const;
  bool is_rational() const { return coefficients_.size() == 1; }
  const Rational& rational() const;  // asking an irrational number is a caller's mistake

  // The lowest storey the number lives on: 0 is Q, k is the field with the first k roots.
  int storey() const;

 private:
  friend class Tower;
  // Coefficient i belongs to the product of the roots whose bits are set in i. Of 2^storey numbers; when storey > 0
  // not all of the upper half are zero.
  std::vector<Rational> coefficients_;
  std::uint64_t tower_ = 0;  // which tower the roots belong to; 0 for a rational number, at home in every tower
};

// A fresh tower while alive; the one before comes back, also when an exception passes.
template <>
class Arithmetic<Exact> {
 public:
  Arithmetic();
  ~Arithmetic();
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

  static constexpr int highest_storey = 5;
  // Roots adjoined so far in the innermost scope.
  static int storeys();

 private:
  std::unique_ptr<Tower> tower_;
  Tower* outer_;
};

Sign sign(const Exact& x);   // never undecided
Exact root(const Exact& x);  // throws LeavesTheTower when it would be the sixth storey
inline Exact square(const Exact& x) { return x * x; }
Exact quotient(const Exact& a, const Exact& b);  // throws Undecided when b is (proved) zero

// A ball around the number, in the precision of the Deep scope.
Deep to_deep(const Exact& x);

template <>
inline Exact from_rational<Exact>(const Rational& value) {
  return Exact(value);
}
template <>
Exact pi<Exact>();  // always throws LeavesTheTower
template <>
Exact cosine<Exact>(const Turn& turn);
template <>
Exact sine<Exact>(const Turn& turn);

}  // namespace epure::geometry
