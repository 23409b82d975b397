// Exact: an element of a tower of real quadratic fields, Q in Q(√a) in Q(√a)(√b) ..., at most five high.
//
// The tower (tower.h) belongs to the innermost Arithmetic<Exact> scope of the thread and starts as Q. root(x) first
// decides whether x already has its root in the tower and only otherwise adds a storey.
// The sign of a nonzero number is read from a ball around it, narrowed until it leaves zero: that ends, because the
// number is not zero.
#pragma once

#include "geometry/numbers/deep.h"
#include "geometry/numbers/number.h"
#include "geometry/numbers/rational_field.h"
#include "geometry/numbers/surd.h"

#include <memory>
#include <utility>

namespace epure::geometry {

class Exact {
 public:
  Exact() : Exact(Rational(0)) {}
  Exact(int value) : Exact(Rational(value)) {}
  explicit Exact(const Rational& value) : surd_(value) {}

  Exact& operator+=(const Exact& other) { return *this = *this + other; }
  Exact& operator-=(const Exact& other) { return *this = *this - other; }
  Exact& operator*=(const Exact& other) { return *this = *this * other; }
  Exact& operator/=(const Exact& other) { return *this = *this / other; }

  friend Exact operator+(const Exact& a, const Exact& b);
  friend Exact operator-(const Exact& a, const Exact& b);
  friend Exact operator*(const Exact& a, const Exact& b);
  friend Exact operator/(const Exact& a, const Exact& b);  // b = 0 is a caller's mistake
  Exact operator-() const;

  bool is_zero() const { return surd_.is_zero(); }
  bool is_rational() const { return surd_.is_in_field(); }
  const Rational& rational() const { return surd_.in_field(); }  // asking an irrational number is a caller's mistake

  // The lowest storey the number lives on: 0 is Q, k is the field with the first k roots.
  int storey() const { return surd_.storey(); }

 private:
  friend Sign sign(const Exact& x);
  friend Exact root(const Exact& x);
  friend Deep to_deep(const Exact& x);
  explicit Exact(Surd<Rational> surd) : surd_(std::move(surd)) {}

  Surd<Rational> surd_;
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
  std::unique_ptr<Tower<Rational>> tower_;
  Tower<Rational>* outer_;
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
