// TwoBounded: Bounded, for two positions of a sweep at a time. Each lane of two vector registers is one interval of
// doubles, and every operation gives in each lane the same enclosure as Bounded (the tests compare the bits).
//
// An interval of its own is a pair of ends that are treated alike, exchanged and compared: shuffles and branches.
// Here ends of the same kind lie side by side, so that nothing is shuffled, in vectors that GCC and Clang know on
// every machine. Measured on the second-order analysis of a four-bar and a slider-crank: 2.1 and 2.9 times the time
// of the same loop on doubles, where Bounded takes 3.7 and 5.2 times. (A number of value and running error bound, two
// at a time, was no faster, and its bounds were four times as wide.)
//
// WHY THE ENCLOSURES HOLD. The processor rounds upwards (an Arithmetic<Bounded> scope must be open). Kept are the
// upper end and the negated lower end, so both round outwards when they round up. Write u(x) for x rounded up: the
// least double >= x, also among the subnormals; beyond the largest double +infinity. Then
//   sum           a + b <= u(upper + upper), and the same for the negated ends; a difference is a sum with -b, which
//                 exchanges the ends without rounding.
//   product       largest where both factors are at ends (it is linear in each): the greatest of the four u(corner);
//                 its negative has the greatest of the four negated corners. For a first factor >= 0 two of the four
//                 are enough, with the end of b that counts; one <= 0 is turned first, a b = (-a)(-b).
//   square        of the greatest and of the least distance from zero, the latter 0 when zero is inside.
//   quotient      for a divisor > 0: upper / (lower end of the divisor when upper > 0, else its upper end), and the
//                 negated lower end alike. Lanes whose divisor is negative are turned first: a/b = (-a)/(-b).
//   root          u(√upper). For the lower end r = u(√lower): when u(r²) = lower, then r² <= lower, and r >= √lower,
//                 so r is the root. Else r > √lower, and the double before r is not above √lower, for no double lies
//                 between √lower and r; minus that double is u(2^-1074 - r).
//   sign          decided only when it is the same in both lanes; so a construction takes the same way in both.
// An end that has overflowed is +infinity and still an upper bound. What could spoil a bound is only a NaN, from 0 ∞,
// ∞ - ∞ or ∞ / ∞, for `larger` may drop it; each raises the processor's flag for an invalid operation. Who uses this
// number looks at that flag after some work, before believing it (second_order_sweep.cpp does, row by row).
// Subnormals must be kept: a small bound flushed to zero would be none. -frounding-math keeps the compiler from
// evaluating or rearranging where that depends on the rounding mode: -(a b) rounds the other way than (-a) b.
#pragma once

#include "geometry/numbers/bounded.h"

#include <bit>
#include <cassert>
#include <cfloat>
#include <cmath>
#include <cstdint>

namespace epure::geometry {

static_assert(FLT_EVAL_METHOD == 0, "every operation on doubles must round to a double");

using Lanes [[gnu::vector_size(16)]] = double;

struct TwoBounded {
  Lanes minus_lower = {}, upper = {};

  TwoBounded() = default;  // zero
  TwoBounded(const Lanes& of_minus_lower, const Lanes& of_upper) : minus_lower(of_minus_lower), upper(of_upper) {}
  TwoBounded(const Bounded& first, const Bounded& second)
      : minus_lower{-first.inf(), -second.inf()}, upper{first.sup(), second.sup()} {}
  explicit TwoBounded(const Bounded& both) : TwoBounded(both, both) {}
  explicit TwoBounded(int both) : TwoBounded(Bounded(both)) {}

  Bounded lane(int i) const { return {-minus_lower[i], upper[i], Bounded::no_check_t()}; }

  TwoBounded operator-() const { return {upper, minus_lower}; }
};

template <>
inline TwoBounded from_rational<TwoBounded>(const Rational& value) {
  return TwoBounded(from_rational<Bounded>(value));
}

namespace lanes {

inline Lanes larger(const Lanes& x, const Lanes& y) { return x > y ? x : y; }
inline Lanes root(const Lanes& x) { return Lanes{std::sqrt(x[0]), std::sqrt(x[1])}; }
inline bool all_negative(const Lanes& x) { return x[0] < 0 && x[1] < 0; }
// By the sign bits, which is quicker; so false may also be said of zeros.
inline bool none_positive(const Lanes& x) {
  using Bits [[gnu::vector_size(16)]] = std::int64_t;
  const auto bits = std::bit_cast<Bits>(x);
  return (bits[0] & bits[1]) < 0;
}
inline bool all_zero(const Lanes& x) { return x[0] == 0 && x[1] == 0; }

}  // namespace lanes

inline TwoBounded operator+(const TwoBounded& a, const TwoBounded& b) {
  return {a.minus_lower + b.minus_lower, a.upper + b.upper};
}
inline TwoBounded operator-(const TwoBounded& a, const TwoBounded& b) { return a + -b; }
inline TwoBounded& operator+=(TwoBounded& a, const TwoBounded& b) { return a = a + b; }

namespace lanes {

// [lower, upper] · b for lower >= 0: two corners for each end instead of four.
inline TwoBounded product(const Lanes& lower, const Lanes& upper, const TwoBounded& b) {
  return {larger(upper * b.minus_lower, lower * b.minus_lower), larger(upper * b.upper, lower * b.upper)};
}

}  // namespace lanes

// Along a sweep signs seldom change, so the branches cost nothing and spare half of the work.
inline TwoBounded operator*(const TwoBounded& a, const TwoBounded& b) {
  const Lanes lower = -a.minus_lower, minus_upper = -a.upper, b_lower = -b.minus_lower;
  if (lanes::none_positive(a.minus_lower)) return lanes::product(lower, a.upper, b);
  if (lanes::none_positive(a.upper)) return lanes::product(minus_upper, a.minus_lower, -b);
  using lanes::larger;
  return {
      larger(larger(lower * b.minus_lower, a.minus_lower * b.upper),
             larger(a.upper * b.minus_lower, minus_upper * b.upper)),
      larger(larger(a.minus_lower * b.minus_lower, lower * b.upper), larger(a.upper * b_lower, a.upper * b.upper))};
}

inline TwoBounded square(const TwoBounded& a) {
  const Lanes farthest = lanes::larger(a.minus_lower, a.upper);
  const Lanes nearest = lanes::larger(Lanes{}, lanes::larger(-a.minus_lower, -a.upper));
  return {-nearest * nearest, farthest * farthest};
}

inline Sign sign(const TwoBounded& a) {
  if (lanes::all_negative(a.minus_lower)) return Sign::positive;
  if (lanes::all_negative(a.upper)) return Sign::negative;
  return lanes::all_zero(a.minus_lower) && lanes::all_zero(a.upper) ? Sign::zero : Sign::undecided;
}

// Throws Undecided when the divisor may be zero in a lane; its sign need not be the same in both.
inline TwoBounded quotient(const TwoBounded& a, const TwoBounded& b) {
  const auto is_proved = [&](int i) { return b.minus_lower[i] < 0 || b.upper[i] < 0; };
  if (!is_proved(0) || !is_proved(1))
    throw Undecided("division by an interval that contains zero", "divisione per un intervallo che contiene lo zero");
  const auto is_turned = b.upper < 0;
  const Lanes least = is_turned ? -b.upper : -b.minus_lower, most = is_turned ? b.minus_lower : b.upper;
  const Lanes minus_lower = is_turned ? a.upper : a.minus_lower, upper = is_turned ? a.minus_lower : a.upper;
  return {minus_lower / (minus_lower > 0 ? least : most), upper / (upper > 0 ? least : most)};
}

inline TwoBounded operator/(const TwoBounded& a, const TwoBounded& b) { return quotient(a, b); }

// Of a >= 0 in both lanes: an enclosure that reaches below zero is cut there, as Bounded's is.
inline TwoBounded root(const TwoBounded& a) {
  assert(!(a.upper[0] < 0 || a.upper[1] < 0) && "root of a number proved negative");
  const Lanes lower = lanes::larger(Lanes{}, -a.minus_lower), above = lanes::root(lower);
  const Lanes smallest = Lanes{} + 0x1p-1074;
  return {above * above == lower ? -above : smallest - above, lanes::root(a.upper)};
}

}  // namespace epure::geometry
