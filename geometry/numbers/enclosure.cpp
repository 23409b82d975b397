#include "geometry/numbers/enclosure.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/bounded.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epure::geometry {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

// Bits to which an end of a ball is rounded outwards before it becomes a double. More than the deepest rung of the
// climb has, so that the first rounding takes nothing from what the ball says: a value close to the middle of two
// doubles is certain only beyond that many bits. (The bits an end does not need cost nothing.)
constexpr long end_bits = 4096;

struct Ends {
  Float lower, upper;
  explicit Ends(const Deep& x) {
    arb_get_lbound_arf(lower.value, x.ball(), end_bits);
    arb_get_ubound_arf(upper.value, x.ball(), end_bits);
  }
};

template <class Number>
const Number& certain(const std::optional<Number>& found) {
  if (!found) throw TooCoarse{};
  return *found;
}

double without_sign_of_zero(double x) { return x == 0 ? 0.0 : x; }

// Halves before adding, so that no finite interval overflows.
double midpoint(double lower, double upper) {
  if (lower == upper) return lower;
  if (std::isinf(lower) && std::isinf(upper)) return 0;
  if (std::isinf(lower)) return upper;
  if (std::isinf(upper)) return lower;
  return std::clamp(lower / 2 + upper / 2, lower, upper);
}

}  // namespace

Enclosure enclosure(const Bounded& x) {
  const double lower = std::isnan(x.inf()) ? -infinity : without_sign_of_zero(x.inf());
  const double upper = std::isnan(x.sup()) ? infinity : without_sign_of_zero(x.sup());
  return {lower, midpoint(lower, upper), upper};
}

Bounded midpoint(const Bounded& x) { return midpoint(x.inf(), x.sup()); }

Deep midpoint(const Deep& x) {
  if (x.is_in_doubles()) return Deep::from_double(x.doubled().near());
  Ball point;
  arb_get_mid_arb(point.value, x.ball());
  return Deep::from_ball(point.value);
}

Bounded widened(const Bounded& x, const Bounded& by) { return x + Bounded(-by.sup(), by.sup()); }

Deep widened(const Deep& x, const Deep& by) {
  if (x.is_in_doubles()) {
    const Arithmetic<Bounded> rounding;
    return Deep::from_doubled(widened(x.doubled(), by.doubled()));
  }
  Ball wide;
  arb_set(wide.value, x.ball());
  arb_add_error(wide.value, by.ball());
  return Deep::from_ball(wide.value);
}

Bounded to_bounded(const Deep& x) {
  if (x.is_in_doubles()) {
    const Arithmetic<Bounded> rounding;
    return certain(x.doubled().certain_bounds());
  }
  const Ends ends(x);
  // A magnitude beyond the doubles lies between the largest double and infinity.
  const double lower = std::min(arf_get_d(ends.lower.value, ARF_RND_FLOOR), largest);
  const double upper = std::max(arf_get_d(ends.upper.value, ARF_RND_CEIL), -largest);
  return {without_sign_of_zero(lower), without_sign_of_zero(upper)};
}

Bounded loose_bounds(const Deep& x) {
  if (!x.is_in_doubles()) return to_bounded(x);
  const Arithmetic<Bounded> rounding;
  return x.doubled().value();
}

Enclosure enclosure(const Deep& x) {
  Enclosure result = enclosure(to_bounded(x));
  const std::optional<double> nearest = certain_double(x);
  const double value = nearest ? *nearest : arf_get_d(arb_midref(x.ball()), ARF_RND_NEAR);
  result.value = std::clamp(without_sign_of_zero(value), result.lower, result.upper);
  return result;
}

std::optional<double> certain_double(const Deep& x) {
  if (x.is_in_doubles()) {
    const Arithmetic<Bounded> rounding;
    return certain(x.doubled().certain_double());
  }
  const Ends ends(x);
  const double lower = arf_get_d(ends.lower.value, ARF_RND_NEAR);
  const double upper = arf_get_d(ends.upper.value, ARF_RND_NEAR);
  if (lower != upper || std::isinf(lower)) return std::nullopt;
  return without_sign_of_zero(lower);
}

}  // namespace epure::geometry
