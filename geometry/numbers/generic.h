// Generic: a number in which directions are left open. What is zero here is zero for every direction of the links,
// and so for the one they have: ω₃ of a parallelogram at 23°, which no ruler constructs, is proved without a word of
// 23°.
//
// A number remembers how it was made. Its sign is read from a ball around it, with more and more bits. Where these
// leave it open, the number is made once more, with tan θ/2 of each direction and π as indeterminates, in a tower of
// roots over the rational functions of them (tower.h). That number is zero or it is not, decided exactly. If it is,
// so is ours: every divisor and every radicand on the way was proved not to vanish at the directions themselves, so
// that putting them in place of the indeterminates is a homomorphism; a root that is found in the tower takes the
// sign that it has there, and one that is adjoined is the positive one. If it is not zero, only a ball can tell the
// sign, since directions like 20° may be special after all.
//
// Directions that differ by small multiples of each other, or of 15°, are known to do so; others count as
// independent. A proof that grows too long is given up: sign then says undecided, and division throws Undecided.
#pragma once

#include "geometry/numbers/deep.h"
#include "geometry/numbers/number.h"

#include <memory>

namespace epure::geometry {

struct GenericNode;
class GenericContext;

class Generic {
 public:
  Generic() : Generic(0) {}
  Generic(int value) : Generic(Rational(value)) {}
  explicit Generic(const Rational& value);
  static Generic pi();
  // Of the angle 2π turns + radians.
  static Generic cosine(const Rational& turns, const Rational& radians);

  Generic& operator+=(const Generic& other) { return *this = *this + other; }
  Generic& operator-=(const Generic& other) { return *this = *this - other; }
  Generic& operator*=(const Generic& other) { return *this = *this * other; }
  Generic& operator/=(const Generic& other) { return *this = *this / other; }

  friend Generic operator+(const Generic& a, const Generic& b);
  friend Generic operator-(const Generic& a, const Generic& b);
  friend Generic operator*(const Generic& a, const Generic& b);
  friend Generic operator/(const Generic& a, const Generic& b);  // throws Undecided when b is not proved nonzero
  Generic operator-() const;

  friend Sign sign(const Generic& x);
  friend Generic root(const Generic& x);
  friend Deep to_deep(const Generic& x);

 private:
  explicit Generic(std::shared_ptr<GenericNode> node) : node_(std::move(node)) {}
  std::shared_ptr<GenericNode> node_;
};

// Fresh indeterminates while alive; those before come back, also when an exception passes. Every number made in it
// must be gone before.
template <>
class Arithmetic<Generic> {
 public:
  Arithmetic();
  ~Arithmetic();
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

 private:
  std::unique_ptr<GenericContext> context_;
  GenericContext* outer_;
};

Sign sign(const Generic& x);
Generic root(const Generic& x);  // throws Undecided where x may be zero but is not for every direction
Deep to_deep(const Generic& x);  // in the precision of the Deep scope; throws Undecided without bounds
inline Generic square(const Generic& x) { return x * x; }
inline Generic quotient(const Generic& a, const Generic& b) { return a / b; }

template <>
inline Generic from_rational<Generic>(const Rational& value) {
  return Generic(value);
}
template <>
inline Generic pi<Generic>() {
  return Generic::pi();
}
template <>
Generic cosine<Generic>(const Turn& turn);
template <>
Generic sine<Generic>(const Turn& turn);

}  // namespace epure::geometry
