// Calcium: an exact real number of the Calcium library. Any rational turn, π, roots at any depth; decisions are yes,
// no or undecided, and may take milliseconds to seconds. For decisions and identities only, never for a reported
// value. A number that becomes too large to go on with is given up: + - * / throw Undecided then.
#pragma once

#include "geometry/numbers/deep.h"
#include "geometry/numbers/number.h"

struct epure_calcium_context;
struct epure_calcium_number;

namespace epure::geometry {

class Calcium {
 public:
  Calcium();
  Calcium(int value);
  explicit Calcium(const Rational& value);
  Calcium(const Calcium& other);
  Calcium(Calcium&& other) noexcept;  // leaves the other fit only to be assigned or destroyed
  Calcium& operator=(Calcium other) noexcept;
  ~Calcium();

  Calcium& operator+=(const Calcium& other) { return *this = *this + other; }
  Calcium& operator-=(const Calcium& other) { return *this = *this - other; }
  Calcium& operator*=(const Calcium& other) { return *this = *this * other; }
  Calcium& operator/=(const Calcium& other) { return *this = *this / other; }

  friend Calcium operator+(const Calcium& a, const Calcium& b);
  friend Calcium operator-(const Calcium& a, const Calcium& b);
  friend Calcium operator*(const Calcium& a, const Calcium& b);
  friend Calcium operator/(const Calcium& a, const Calcium& b);  // throws Undecided when b is not proved nonzero
  Calcium operator-() const;

  friend Sign sign(const Calcium& x);
  friend Calcium root(const Calcium& x);
  friend Deep to_deep(const Calcium& x);  // in the precision of the Deep scope; throws Undecided without bounds
  static Calcium pi();
  static Calcium cosine(const Turn& turn);

 private:
  epure_calcium_context* context_;
  epure_calcium_number* number_;
};

// A fresh context while alive; the one before comes back, also when an exception passes. Every number made in it must
// be gone before.
template <>
class Arithmetic<Calcium> {
 public:
  Arithmetic();
  ~Arithmetic();
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

 private:
  epure_calcium_context* context_;
  epure_calcium_context* outer_;
};

Sign sign(const Calcium& x);
Calcium root(const Calcium& x);
Deep to_deep(const Calcium& x);
inline Calcium square(const Calcium& x) { return x * x; }
inline Calcium quotient(const Calcium& a, const Calcium& b) { return a / b; }

template <>
inline Calcium from_rational<Calcium>(const Rational& value) {
  return Calcium(value);
}
template <>
inline Calcium pi<Calcium>() {
  return Calcium::pi();
}
template <>
Calcium cosine<Calcium>(const Turn& turn);
template <>
Calcium sine<Calcium>(const Turn& turn);

}  // namespace epure::geometry
