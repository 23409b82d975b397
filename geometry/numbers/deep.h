// Deep: a ball (midpoint ± radius) of the Arb library that contains the true value, worked with as many bits as the
// innermost Arithmetic<Deep> scope of the thread says. Never NaN, never infinite: what would be throws Undecided.
#pragma once

#include "geometry/numbers/flint.h"
#include "geometry/numbers/number.h"

namespace epure::geometry {

class Deep {
 public:
  Deep() { arb_init(ball_); }
  Deep(int value) : Deep() { arb_set_si(ball_, value); }
  Deep(const Deep& other) : Deep() { arb_set(ball_, other.ball_); }
  Deep(Deep&& other) noexcept : Deep() { arb_swap(ball_, other.ball_); }
  Deep& operator=(const Deep& other) { return arb_set(ball_, other.ball_), *this; }
  Deep& operator=(Deep&& other) noexcept { return arb_swap(ball_, other.ball_), *this; }
  ~Deep() { arb_clear(ball_); }

  // Exactly this double, which must be finite.
  static Deep from_double(double value);
  // A ball around the interval, whose ends must be finite.
  static Deep from_bounded(const Bounded& value);
  // A ball made with Arb's own functions (logarithms, elliptic integrals); throws Undecided when it is not finite.
  static Deep from_ball(const arb_t ball);

  // For Arb's own functions. Their precision argument is Arithmetic<Deep>::bits().
  const arb_struct* ball() const { return ball_; }

  Deep& operator+=(const Deep& other);
  Deep& operator-=(const Deep& other);
  Deep& operator*=(const Deep& other);
  Deep& operator/=(const Deep& other);

  friend Deep operator+(Deep a, const Deep& b) { return a += b; }
  friend Deep operator-(Deep a, const Deep& b) { return a -= b; }
  friend Deep operator*(Deep a, const Deep& b) { return a *= b; }
  friend Deep operator/(Deep a, const Deep& b) { return a /= b; }
  Deep operator-() const;

 private:
  arb_t ball_;
};

// The working precision of this thread while alive; the one before comes back, also when an exception passes.
template <>
class Arithmetic<Deep> {
 public:
  explicit Arithmetic(long bits);
  ~Arithmetic();
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

  // Of the innermost scope; asking without one is a caller's mistake.
  static long bits();

 private:
  long outer_bits_;
};

Sign sign(const Deep& x);
Deep root(const Deep& x);
Deep square(const Deep& x);
inline Deep quotient(const Deep& a, const Deep& b) { return a / b; }
Deep arc_tangent(const Deep& y, const Deep& x);
Deep cosine_of_angle(const Deep& angle);
Deep sine_of_angle(const Deep& angle);

template <>
Deep from_rational<Deep>(const Rational& value);
template <>
Deep pi<Deep>();
// Relative accuracy of as many bits as the scope has but a few, also where the value is nearly zero.
template <>
Deep cosine<Deep>(const Turn& turn);
template <>
Deep sine<Deep>(const Turn& turn);

}  // namespace epure::geometry
