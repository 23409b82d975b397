// Bounded: interval of doubles. Every result contains the true value; ends may be infinite after an overflow, never
// NaN as long as divisions that may meet zero go through quotient.
#pragma once

#include "geometry/numbers/number.h"

#include <cassert>

namespace epure::geometry {

// Rounding upwards while alive; the mode found is restored, also when an exception passes.
template <>
class Arithmetic<Bounded> {
 public:
  Arithmetic() = default;
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

 private:
  Bounded::Protector rounding_;
};

inline Sign sign(const Bounded& x) {
  if (x.inf() > 0) return Sign::positive;
  if (x.sup() < 0) return Sign::negative;
  return x.inf() == 0 && x.sup() == 0 ? Sign::zero : Sign::undecided;
}

// The narrowest interval of doubles.
template <>
Bounded from_rational<Bounded>(const Rational& value);

inline Bounded root(const Bounded& x) {
  assert(sign(x) != Sign::negative && "root of a number proved negative");
  return CGAL::sqrt(x);
}
inline Bounded square(const Bounded& x) { return CGAL::square(x); }

inline Bounded quotient(const Bounded& a, const Bounded& b) {
  const Sign divisor = sign(b);
  if (divisor == Sign::zero || divisor == Sign::undecided)
    throw Undecided("division by an interval that contains zero", "divisione per un intervallo che contiene lo zero");
  return a / b;
}

// At most 2 ulp wide, and a point where the value is rational.
template <>
Bounded pi<Bounded>();
template <>
Bounded cosine<Bounded>(const Turn& turn);
template <>
Bounded sine<Bounded>(const Turn& turn);

// The hull of the angles of the box, at most 1 ulp beyond each end. Throws Undecided also for an infinite end.
Bounded arc_tangent(const Bounded& y, const Bounded& x);

// At most 2 ulp wide for an angle that is a point, never beyond [-1, 1]. Throw Undecided for an infinite end.
Bounded cosine_of_angle(const Bounded& angle);
Bounded sine_of_angle(const Bounded& angle);

}  // namespace epure::geometry
