#include "geometry/numbers/direction.h"

#include "geometry/numbers/round_to_nearest.h"
#include "geometry/numbers/turn.h"

#include <array>
#include <cmath>

namespace epure::geometry {

namespace {

// π/2 = 1.921fb54442d18 469898cc51701b839a25... in hexadecimal: the double below it, and an enclosure of the rest.
constexpr double half_pi = 0x1.921fb54442d18p+0;
Bounded rest_of_half_pi() { return {0x1.1a62633145c06p-54, 0x1.1a62633145c07p-54}; }

// What -n half_pi lacks to n right angles less than zero: with more digits of the rest, which here is all there is.
Split beside_right_angles(double n) {
  constexpr double rest = 0x1.1a62633145c07p-54, rest_of_rest = -0x1.f1976b7ed8fbcp-110;  // at most half an ulp off
  const double near = -n * rest;
  return {near, Bounded(std::fma(-n, rest, -near)) +
                    Bounded(-n) * Bounded(std::nextafter(rest_of_rest, -1.0), std::nextafter(rest_of_rest, 0.0))};
}

// Squares and products of such numbers neither overflow nor lose digits below the smallest double, and neither do the
// errors of these, which fma then gives exactly, whatever the rounding mode.
bool is_handy(double x) { return std::abs(x) > 0x1p-300 && std::abs(x) < 0x1p300; }

// 1 - z/(n(n+1)) (1 - z/((n+2)(n+3)) (...)) for 0 <= z < 1: each bracket lies between 0 and 1, since its terms
// alternate and decrease; that is what is known of the last.
Bounded alternating(const Bounded& z, int n) {
  constexpr int most = 24;  // z^11/22! is below 2^-69
  static const std::array<Bounded, most> over = [] {
    std::array<Bounded, most> reciprocals;
    for (int i = 1; i < most; ++i) reciprocals[static_cast<std::size_t>(i)] = Bounded(1) / Bounded(i * (i + 1));
    return reciprocals;
  }();
  Bounded sum(0, 1);
  for (int i = n + (most - 2 - n) / 2 * 2; i >= n; i -= 2)
    sum = Bounded(1) - z * over[static_cast<std::size_t>(i)] * sum;
  return sum;
}

Bounded widened_by(const Bounded& x, const Bounded& small) {
  const double by = std::max(-small.inf(), small.sup());
  return x + Bounded(-by, by);
}

// Within an eighth of a turn: of near by the series, then of near + rest by the mean value theorem.
SplitDirection in_octant(const Split& angle) {
  const double x = angle.near, squared = x * x, half = squared / 2;
  const Bounded z = square(Bounded(x));
  // sin x = x - x z/6 (1 - z/20 (...)); cos x = 1 - z/2 + z²/24 (1 - z/30 (...)), where 1 - half is w and what w
  // lacks, and z is `squared` and what that lacks.
  const double w = 1 - half;
  const Bounded lacks = (Bounded(1) - Bounded(w) - Bounded(half)) - Bounded(std::fma(x, x, -squared)) / Bounded(2);
  Split sine{x, -(Bounded(x) * (z / Bounded(6) * alternating(z, 4)))};
  Split cosine{w, lacks + square(z) / Bounded(24) * alternating(z, 5)};
  const Bounded all_cosines = widened_by(cosine.value(), angle.rest),
                all_sines = widened_by(sine.value(), angle.rest);
  sine.rest += angle.rest * all_cosines;
  cosine.rest -= angle.rest * all_sines;
  return {cosine, sine};
}

}  // namespace

std::optional<SplitAngle> split_angle(double radians) {
  // So that n half_pi, of 20 and 53 bits, less the angle, which is as large, is a multiple of 2^-53 below 1: exact.
  if (!(std::abs(radians) < 0x1p20)) return {};
  const double n = std::floor(radians * (2 / 3.141592653589793) + 0.5);
  const double near = std::fma(-n, half_pi, radians);
  if (near == 0 && n != 0) return SplitAngle{static_cast<long>(n), beside_right_angles(n)};
  if (near != 0 && !is_handy(near)) return {};
  return SplitAngle{static_cast<long>(n), {near, Bounded(-n) * rest_of_half_pi()}};
}

std::optional<SplitAngle> split_angle(const Turn& turn) {
  const Rational quarters = Rational(4) * within_one_turn(turn).fraction;
  const double n = std::floor(quarters.to_double() + 0.5);
  const Rational half_turns = (quarters - Rational(n)) / Rational(2);
  const double part = half_turns.to_double(), near = part * (2 * half_pi);
  if (half_turns == 0) return SplitAngle{static_cast<long>(n), {}};
  if (!is_handy(part)) return {};
  const Bounded lacks = from_rational<Bounded>(half_turns - Rational(part));
  return SplitAngle{static_cast<long>(n),
                    {near, Bounded(std::fma(part, 2 * half_pi, -near)) +
                               Bounded(2) * (Bounded(part) * rest_of_half_pi() + lacks * right_angle())}};
}

SplitDirection direction(const SplitAngle& angle) {
  const auto [cosine, sine] = in_octant(angle.left);
  switch (angle.right_angles & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

// From an angle that the standard library gives, of which nothing is believed: seen from its direction, (x, y) lies
// in another one, whose angle is small.
std::optional<Bounded> split_arc_tangent(double y, double x) {
  if (y == 0) return x > 0 ? Bounded(0) : Bounded(2) * right_angle();
  if (x == 0) return y > 0 ? right_angle() : -right_angle();
  if (!is_handy(x) || !is_handy(y)) return {};
  const double about = [&] {
    const RoundToNearest rounding;
    return std::atan2(y, x);
  }();
  const std::optional<SplitAngle> angle = split_angle(about);
  if (!angle) return {};
  const auto [c, s] = direction(*angle);
  const double yc = y * c.near, xs = x * s.near;
  const Bounded aside = (Bounded(yc) - Bounded(xs)) +
                        (Bounded(std::fma(y, c.near, -yc)) - Bounded(std::fma(x, s.near, -xs))) +
                        (Bounded(y) * c.rest - Bounded(x) * s.rest);
  const Bounded along = Bounded(x) * c.value() + Bounded(y) * s.value();
  const Bounded t = aside / along;  // along is nearly the distance of (x, y)
  constexpr double small = 0x1p-27;
  if (!(along.inf() > 0 && t.inf() > -small && t.sup() < small)) return {};
  // arctan t lies between t and t - t³/3, and t²/3 below 2^-54.
  return Bounded(about) + t * Bounded(1 - 0x1p-53, 1);
}

Bounded right_angle() { return {half_pi, std::nextafter(half_pi, 2.0)}; }

}  // namespace epure::geometry
