// Deep: a ball (midpoint ± radius) of the Arb library that contains the true value, worked with as many bits as the
// innermost Arithmetic<Deep> scope of the thread says. Never NaN, never infinite: what would be throws Undecided.
//
// In a scope in doubles it is an interval of twice the digits of a double instead, so that Arb need not be there. It
// answers all that a ball would, or throws TooCoarse: so what is found in doubles is what is found with many bits.
#pragma once

#include "geometry/numbers/doubled.h"
#include "geometry/numbers/flint.h"
#include "geometry/numbers/number.h"

namespace epure::geometry {

// Thrown where the doubles of Arithmetic<Deep>(in_doubles) do not suffice: a sign that they leave open, a value asked
// for that they hold too coarsely, a function that is Arb's alone. Not an Undecided: nobody may take it for an answer
// but who opened the scope, and opens another with more bits.
struct TooCoarse {};

// For Arithmetic<Deep>: enclosures of two doubles' digits in place of balls.
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

  // Made in doubles: then it is this, and no ball.
  bool is_in_doubles() const { return is_in_doubles_; }
  const Doubled& doubled() const;
  static Deep from_doubled(const Doubled& value) { return Deep(value); }

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
  explicit Deep(const Doubled& value) : doubled_(value), is_in_doubles_(true) {}

  union {
    Doubled doubled_;
    arb_t ball_;
  };
  bool is_in_doubles_;
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

// While one lives, doubles_first of this thread begins with bits: what is found in doubles is held against that.
class WithBits {
 public:
  WithBits() { is_on_ = true; }
  ~WithBits() { is_on_ = false; }
  WithBits(const WithBits&) = delete;
  WithBits& operator=(const WithBits&) = delete;
  static bool is_on() { return is_on_; }

 private:
  inline static thread_local bool is_on_ = false;
};

// Runs `find`, which works on Deep, in doubles, and where these do not suffice with so many bits. So it may run
// twice.
template <class Find>
auto doubles_first(long bits, const Find& find) {
  if (!WithBits::is_on()) try {
      const Arithmetic<Deep> doubles(in_doubles);
      return find();
    } catch (const TooCoarse&) {
    }
  const Arithmetic<Deep> scope(bits);
  return find();
}

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
