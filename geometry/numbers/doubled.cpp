#include "geometry/numbers/doubled.h"

#include "geometry/numbers/bounded.h"
#include "geometry/numbers/round_to_nearest.h"
#include "geometry/numbers/small_fraction.h"
#include "geometry/numbers/turn.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace epure::geometry {

namespace {

// All that is made here is rounded upwards.
double down(double a, double b) { return -(-a - b); }

Bounded product(double a, double b, double about) { return {-std::fma(-a, b, about), std::fma(a, b, -about)}; }

[[noreturn]] void leave_open() { throw Undecided("what doubles leave open", "ciò che i double lasciano aperto"); }

}  // namespace

// The double takes the middle of the rest, so that what remains of that is as small as it is known.
Doubled::Doubled(double part, const Bounded& rest)
    : near_(part + (rest.inf() / 2 + rest.sup() / 2)), rest_((Bounded(part) - Bounded(near_)) + rest) {
  if (!std::isfinite(near_) || !std::isfinite(rest_.inf()) || !std::isfinite(rest_.sup())) leave_open();
}

// With room for a ball of 128 bits around the true value, so that it gives the same doubles.
Bounded Doubled::roomy_rest() const {
  if (rest_.is_point() && rest_.inf() == 0) return rest_;
  const double room = std::abs(near_) * 0x1p-100;
  return rest_ + Bounded(-room, room);
}

std::optional<double> Doubled::certain_double() const {
  const Bounded rest = roomy_rest();
  const RoundToNearest rounding;
  const double lower = near_ + rest.inf(), upper = near_ + rest.sup();
  if (lower != upper || !std::isfinite(lower)) return {};
  return lower == 0 ? 0 : lower;
}

std::optional<Bounded> Doubled::certain_bounds() const {
  const Bounded rest = roomy_rest();
  const double below = down(near_, rest.inf()), above = near_ + rest.sup();
  if (below != down(near_, rest.sup()) || above != near_ + rest.inf()) return {};
  return Bounded(below, above);
}

Doubled Doubled::operator-() const {
  Doubled result(-near_);
  result.rest_ = -rest_;
  return result;
}

Doubled operator+(const Doubled& a, const Doubled& b) {
  if (std::abs(a.near_) < std::abs(b.near_)) return b + a;
  const double sum = a.near_ + b.near_;
  return {sum, (Bounded(b.near_) - (Bounded(sum) - Bounded(a.near_))) + (a.rest_ + b.rest_)};
}

Doubled operator*(const Doubled& a, const Doubled& b) {
  const double about = a.near_ * b.near_;
  return {about, product(a.near_, b.near_, about) +
                     (Bounded(a.near_) * b.rest_ + Bounded(b.near_) * a.rest_ + a.rest_ * b.rest_)};
}

Doubled operator/(const Doubled& a, const Doubled& b) {
  if (sign(b) == Sign::undecided || sign(b) == Sign::zero) leave_open();
  const double about = a.near_ / b.near_;
  if (!std::isfinite(about)) leave_open();
  return {about, (a - Doubled(about) * b).value() / b.value()};
}

Doubled square(const Doubled& x) {
  const double about = x.near_ * x.near_;
  return {about, product(x.near_, x.near_, about) + (Bounded(2 * x.near_) * x.rest_ + square(x.rest_))};
}

Doubled root(const Doubled& x) {
  const Sign of = sign(x);
  if (of == Sign::zero) return 0;
  if (of != Sign::positive) return Doubled(root(x.value()));
  const double about = std::sqrt(x.near_);
  return {about, (x - square(Doubled(about))).value() / (root(x.value()) + Bounded(about))};
}

Sign sign(const Doubled& x) { return sign(x.value()); }

Doubled widened(const Doubled& x, const Doubled& by) {
  const double reach = by.value().sup();
  return x + Doubled(Bounded(-reach, reach));
}

Doubled doubled(const Rational& value) {
  if (const auto small = small_fraction(value)) return Doubled(small->numerator) / Doubled(small->denominator);
  const double near = value.to_double();
  if (!std::isfinite(near)) leave_open();
  return {near, from_rational<Bounded>(value - Rational(near))};
}

// π/2 = 1.921fb54442d18 469898cc51701b839a25... in hexadecimal.
Doubled doubled_pi() { return {0x1.921fb54442d18p+1, Bounded(0x1.1a62633145c06p-53, 0x1.1a62633145c07p-53)}; }

namespace {

struct Direction {
  Doubled cosine, sine;
};

constexpr int last_factor = 33;  // z^15/32! is below 2^-117

// 1 - z/(n(n+1)) (1 - z/((n+2)(n+3)) (...)) for 0 <= z < 1: each bracket lies between 0 and 1, since its terms
// alternate and decrease; that is what is known of the last.
Doubled alternating(const Doubled& z, int n) {
  static const std::array<Doubled, last_factor> over = [] {
    std::array<Doubled, last_factor> reciprocals;
    for (int i = 1; i < last_factor; ++i)
      reciprocals[static_cast<std::size_t>(i)] = Doubled(1) / Doubled(static_cast<double>(i * (i + 1)));
    return reciprocals;
  }();
  Doubled sum(Bounded(0, 1));
  for (int i = n + (last_factor - 2 - n) / 2 * 2; i >= n; i -= 2)
    sum = Doubled(1) - z * over[static_cast<std::size_t>(i)] * sum;
  return sum;
}

// Within an eighth of a turn, and a little: sin x = x - x z/6 (1 - z/20 (...)), cos x = 1 - z/2 + z²/24 (1 - z/30
// (...)).
Direction in_octant(const Doubled& x) {
  const Doubled z = square(x);
  if (!(z.value().sup() < 1)) leave_open();
  return {Doubled(1) - z / Doubled(2) + square(z) / Doubled(24) * alternating(z, 5),
          x - x * z / Doubled(6) * alternating(z, 4)};
}

Direction turned(const Direction& d, long right_angles) {
  switch (right_angles & 3) {
    case 0:
      return d;
    case 1:
      return {-d.sine, d.cosine};
    case 2:
      return {-d.cosine, -d.sine};
    default:
      return {d.sine, -d.cosine};
  }
}

Direction direction(const Doubled& angle) {
  const double n = std::floor(angle.near() * (2 / 3.141592653589793) + 0.5);
  if (!(std::abs(n) < 0x1p20)) leave_open();  // of angles so large π does not have enough digits here
  return turned(in_octant(angle - Doubled(n) * doubled_pi() / Doubled(2)), static_cast<long>(n));
}

Direction direction(const Turn& turn) {
  const Rational quarters = Rational(4) * within_one_turn(turn).fraction;
  const double n = std::floor(quarters.to_double() + 0.5);
  return turned(in_octant(doubled((quarters - Rational(n)) / 2) * doubled_pi()), static_cast<long>(n));
}

}  // namespace

Doubled doubled_cosine(const Turn& turn) {
  if (const auto known = rational_cosine(turn)) return doubled(*known);
  return direction(turn).cosine;
}
Doubled doubled_sine(const Turn& turn) { return doubled_cosine(turn_for_sine(turn)); }

Doubled cosine_of_angle(const Doubled& angle) { return direction(angle).cosine; }
Doubled sine_of_angle(const Doubled& angle) { return direction(angle).sine; }

// From an angle that the standard library gives, of which nothing is believed: seen from its direction, (x, y) lies
// in another one, whose angle is small.
Doubled arc_tangent(const Doubled& y, const Doubled& x) {
  const Sign of_y = sign(y), of_x = sign(x);
  if (of_y == Sign::zero && of_x == Sign::negative) return doubled_pi();
  if ((of_y == Sign::zero || of_y == Sign::undecided) && of_x != Sign::positive) leave_open();
  const double about = [&] {
    const RoundToNearest rounding;
    return std::atan2(y.near(), x.near());
  }();
  const auto [c, s] = direction(Doubled(about));
  const Doubled along = x * c + y * s;
  if (sign(along) != Sign::positive) leave_open();
  const Doubled t = (y * c - x * s) / along;
  const double most = std::max(-t.value().inf(), t.value().sup());
  if (!(most < 0x1p-20)) leave_open();
  // arctan t lies between t and t - t³/3.
  const double beyond = most * most * most;
  return Doubled(about) + widened(t, Doubled(beyond));
}

}  // namespace epure::geometry
