#include "geometry/numbers/deep.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/bounded.h"
#include "geometry/numbers/round_to_nearest.h"
#include "geometry/numbers/turn.h"

#include <cassert>
#include <cmath>
#include <new>
#include <utility>

namespace epure::geometry {

namespace {

thread_local long working_bits = 0;  // 0: no scope is open
constexpr long doubles = -1;

void require_finite(const arb_t ball) {
  if (!arb_is_finite(ball)) throw Undecided("a ball without bounds", "un numero con raggio d'errore infinito");
}

// What doubles leave open takes more bits.
template <class Function>
Doubled doubled_of(const Function& function) {
  const Arithmetic<Bounded> rounding;
  try {
    return function();
  } catch (const Undecided&) {
    throw TooCoarse{};
  }
}

}  // namespace

Arithmetic<Deep>::Arithmetic(long bits) : outer_bits_(working_bits) {
  assert(bits >= 2 && "precision of a ball");
  working_bits = bits;
}

Arithmetic<Deep>::Arithmetic(InDoubles) : outer_bits_(working_bits) { working_bits = doubles; }

Arithmetic<Deep>::~Arithmetic() { working_bits = outer_bits_; }

bool Arithmetic<Deep>::is_in_doubles() { return working_bits == doubles; }

long Arithmetic<Deep>::bits() {
  assert(working_bits != 0 && "Deep is used without an Arithmetic<Deep> scope");
  if (is_in_doubles()) throw TooCoarse{};
  return working_bits;
}

Deep::Deep(int value) : doubled_(value), is_in_doubles_(Arithmetic<Deep>::is_in_doubles()) {
  if (is_in_doubles_) return;
  arb_init(ball_);
  if (value != 0) arb_set_si(ball_, value);
}

Deep::Deep(const Deep& other)
    : doubled_(other.is_in_doubles_ ? other.doubled_ : 0), is_in_doubles_(other.is_in_doubles_) {
  if (is_in_doubles_) return;
  arb_init(ball_);
  arb_set(ball_, other.ball_);
}

Deep::Deep(Deep&& other) noexcept
    : doubled_(other.is_in_doubles_ ? other.doubled_ : 0), is_in_doubles_(other.is_in_doubles_) {
  if (is_in_doubles_) return;
  arb_init(ball_);
  arb_swap(ball_, other.ball_);
}

Deep& Deep::operator=(const Deep& other) { return *this = Deep(other); }

Deep& Deep::operator=(Deep&& other) noexcept {
  if (!is_in_doubles_ && !other.is_in_doubles_) {
    arb_swap(ball_, other.ball_);
  } else if (this != &other) {
    this->~Deep();
    new (this) Deep(std::move(other));
  }
  return *this;
}

Deep::~Deep() {
  if (!is_in_doubles_) arb_clear(ball_);
}

const arb_struct* Deep::ball() const {
  if (is_in_doubles_) throw TooCoarse{};
  return ball_;
}

const Doubled& Deep::doubled() const {
  if (!is_in_doubles_) throw TooCoarse{};
  return doubled_;
}

bool Deep::may_be_zero() const {
  if (!is_in_doubles_) return arb_contains_zero(ball_) != 0;
  const Arithmetic<Bounded> rounding;
  const Sign known = geometry::sign(doubled_);
  return known == Sign::undecided || known == Sign::zero;
}

Deep Deep::from_double(double value) {
  assert(std::isfinite(value));
  if (Arithmetic<Deep>::is_in_doubles()) return Deep(Doubled(value));
  Deep result;
  arb_set_d(result.ball_, value);
  return result;
}

Deep Deep::from_bounded(const Bounded& value) {
  assert(std::isfinite(value.inf()) && std::isfinite(value.sup()));
  if (Arithmetic<Deep>::is_in_doubles()) return Deep(doubled_of([&] { return Doubled(value); }));
  Deep result;
  Float lower, upper;
  arf_set_d(lower.value, value.inf());
  arf_set_d(upper.value, value.sup());
  arb_set_interval_arf(result.ball_, lower.value, upper.value, Arithmetic<Deep>::bits());
  return result;
}

Deep Deep::from_ball(const arb_t ball) {
  require_finite(ball);
  if (Arithmetic<Deep>::is_in_doubles()) throw TooCoarse{};
  Deep result;
  arb_set(result.ball_, ball);
  return result;
}

Deep& Deep::operator+=(const Deep& other) {
  if (is_in_doubles_)
    doubled_ = doubled_of([&] { return doubled_ + other.doubled(); });
  else
    arb_add(ball_, ball_, other.ball(), Arithmetic<Deep>::bits());
  return *this;
}

Deep& Deep::operator-=(const Deep& other) {
  if (is_in_doubles_)
    doubled_ = doubled_of([&] { return doubled_ - other.doubled(); });
  else
    arb_sub(ball_, ball_, other.ball(), Arithmetic<Deep>::bits());
  return *this;
}

Deep& Deep::operator*=(const Deep& other) {
  if (is_in_doubles_)
    doubled_ = doubled_of([&] { return doubled_ * other.doubled(); });
  else
    arb_mul(ball_, ball_, other.ball(), Arithmetic<Deep>::bits());
  return *this;
}

Deep& Deep::operator/=(const Deep& other) {
  if (is_in_doubles_) {
    doubled_ = doubled_of([&] { return doubled_ / other.doubled(); });
    return *this;
  }
  if (arb_contains_zero(other.ball()))
    throw Undecided("division by a ball that contains zero", "divisione per un intervallo che contiene lo zero");
  arb_div(ball_, ball_, other.ball(), Arithmetic<Deep>::bits());
  require_finite(ball_);
  return *this;
}

Deep Deep::operator-() const {
  if (is_in_doubles_) return Deep(-doubled_);
  Deep result;
  arb_neg(result.ball_, ball_);
  return result;
}

Sign sign(const Deep& x) {
  if (x.is_in_doubles()) {
    const Arithmetic<Bounded> rounding;
    const Sign decided = sign(x.doubled());
    if (decided == Sign::undecided) throw TooCoarse{};
    return decided;
  }
  if (arb_is_positive(x.ball())) return Sign::positive;
  if (arb_is_negative(x.ball())) return Sign::negative;
  return arb_is_zero(x.ball()) ? Sign::zero : Sign::undecided;
}

namespace {

template <class Function>
Deep in_two_doubles(const Function& function) {
  return Deep::from_doubled(doubled_of(function));
}

// Runs one of Arb's functions on a fresh ball, rounding to nearest, and takes the result.
template <class Function>
Deep compute(const Function& function) {
  const RoundToNearest rounding;
  Ball result;
  function(result.value);
  return Deep::from_ball(result.value);
}

// Arb reduces the angle exactly before it computes, so the accuracy is relative also next to a right angle.
void cosine_of_half_turns(arb_t result, const Rational& half_turns) {
  fmpq_t multiple_of_pi;
  fmpq_init(multiple_of_pi);
  fmpq_set_mpq(multiple_of_pi, half_turns.mpq());
  arb_cos_pi_fmpq(result, multiple_of_pi, Arithmetic<Deep>::bits());
  fmpq_clear(multiple_of_pi);
}

}  // namespace

Deep root(const Deep& x) {
  if (x.is_in_doubles()) return in_two_doubles([&] { return root(x.doubled()); });
  assert(sign(x) != Sign::negative && "root of a number proved negative");
  return compute([&](arb_t result) { arb_sqrtpos(result, x.ball(), Arithmetic<Deep>::bits()); });
}

Deep square(const Deep& x) {
  if (x.is_in_doubles()) return in_two_doubles([&] { return square(x.doubled()); });
  return compute([&](arb_t result) {
    arb_sqr(result, x.ball(), Arithmetic<Deep>::bits());
    arb_nonnegative_part(result, result);
  });
}

Deep arc_tangent(const Deep& y, const Deep& x) {
  if (y.is_in_doubles()) return in_two_doubles([&] { return arc_tangent(y.doubled(), x.doubled()); });
  const Sign side = sign(y);
  const bool on_the_axis = side == Sign::zero && sign(x) == Sign::negative;
  const bool may_reach_the_cut = side == Sign::undecided || side == Sign::zero;
  if (may_reach_the_cut && !on_the_axis && sign(x) != Sign::positive)
    throw Undecided(
        "direction that may be a zero vector or lie on either side of 180 degrees",
        "una direzione che può essere di un vettore nullo o stare da una o dall'altra parte di 180 gradi");
  return compute([&](arb_t result) { arb_atan2(result, y.ball(), x.ball(), Arithmetic<Deep>::bits()); });
}

Deep cosine_of_angle(const Deep& angle) {
  if (angle.is_in_doubles()) return in_two_doubles([&] { return cosine_of_angle(angle.doubled()); });
  return compute([&](arb_t result) { arb_cos(result, angle.ball(), Arithmetic<Deep>::bits()); });
}

Deep sine_of_angle(const Deep& angle) {
  if (angle.is_in_doubles()) return in_two_doubles([&] { return sine_of_angle(angle.doubled()); });
  return compute([&](arb_t result) { arb_sin(result, angle.ball(), Arithmetic<Deep>::bits()); });
}

template <>
Deep from_rational<Deep>(const Rational& value) {
  if (Arithmetic<Deep>::is_in_doubles()) return in_two_doubles([&] { return doubled(value); });
  return compute([&](arb_t result) {
    fmpq_t fraction;
    fmpq_init(fraction);
    fmpq_set_mpq(fraction, value.mpq());
    arb_set_fmpq(result, fraction, Arithmetic<Deep>::bits());
    fmpq_clear(fraction);
  });
}

template <>
Deep pi<Deep>() {
  if (Arithmetic<Deep>::is_in_doubles()) return in_two_doubles([] { return doubled_pi(); });
  return compute([](arb_t result) { arb_const_pi(result, Arithmetic<Deep>::bits()); });
}

template <>
Deep cosine<Deep>(const Turn& turn) {
  if (Arithmetic<Deep>::is_in_doubles()) return in_two_doubles([&] { return doubled_cosine(turn); });
  if (const auto known = rational_cosine(turn)) return from_rational<Deep>(*known);
  const Rational half_turns = Rational(2) * within_one_turn(turn).fraction;
  return compute([&](arb_t result) { cosine_of_half_turns(result, half_turns); });
}

template <>
Deep sine<Deep>(const Turn& turn) {
  return cosine<Deep>(turn_for_sine(turn));
}

}  // namespace epure::geometry
