// Deep: a ball (midpoint ± radius) of the Arb library that contains the true value, worked with as many bits as the
// innermost Arithmetic<Deep> scope of the thread says. Never NaN, never infinite: what would be throws Undecided.
//
// In a scope in doubles it is an interval of doubles instead, so that Arb need not be there. It answers all that a
// ball would, or throws TooCoarse: so what is found in doubles is what is found with many bits, for less work.
#pragma once

#include "geometry/numbers/flint.h"
#include "geometry/numbers/number.h"

namespace epure::geometry {

// Thrown where the doubles of Arithmetic<Deep>(in_doubles) do not suffice: a sign that they leave open, a value asked
// for that they hold too coarsely, a function that is Arb's alone. Not an Undecided: nobody may take it for an answer
// but who opened the scope, and opens another with more bits.
struct TooCoarse {};

// For Arithmetic<Deep>: intervals of doubles in place of balls.
struct InDoubles {};
inline constexpr InDoubles in_doubles;

class Deep {
 public:
  Deep() : Deep(0) {}
  Deep(int value);
  Deep(const Deep& other);
  Deep(Deep&& other) noexcept;
  Deep& operator=(const Deep& other);
  Deep& operator=(Deep&& other) noexcept;
  ~Deep();

  // Exactly this double, which must be finite.
  static Deep from_double(double value);
  // A ball around the interval, whose ends must be finite.
  static Deep from_bounded(const Bounded& value);
  // A ball made with Arb's own functions (logarithms, elliptic integrals); throws Undecided when it is not finite.
  static Deep from_ball(const arb_t ball);

  // For Arb's own functions. Their precision argument is Arithmetic<Deep>::bits().
  const arb_struct* ball() const;

  // Made in doubles: then it is this interval, and no ball.
  bool is_interval() const { return is_interval_; }
  const Bounded& interval() const;

  // All that is known does not exclude it. For choices that no answer depends on: in doubles, a sign that is open is
  // refused.
  bool may_be_zero() const;

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
  explicit Deep(const Bounded& interval) : interval_(interval), is_interval_(true) {}

  union {
    Bounded interval_;
    arb_t ball_;
  };
  bool is_interval_;
};

// The working precision of this thread while alive; the one before comes back, also when an exception passes.
template <>
class Arithmetic<Deep> {
 public:
  explicit Arithmetic(long bits);
  explicit Arithmetic(InDoubles);
  ~Arithmetic();
  Arithmetic(const Arithmetic&) = delete;
  Arithmetic& operator=(const Arithmetic&) = delete;

  // Of the innermost scope; asking without one is a caller's mistake. In doubles: throws TooCoarse.
  static long bits();
  static bool is_in_doubles();

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
