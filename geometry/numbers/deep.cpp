#include "geometry/numbers/deep.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/round_to_nearest.h"
#include "geometry/numbers/turn.h"

#include <cassert>
#include <cmath>

namespace epure::geometry {

namespace {

thread_local long working_bits = 0;  // 0: no scope is open

void require_finite(const arb_t ball) {
  if (!arb_is_finite(ball)) throw Undecided("a ball without bounds", "un numero con raggio d'errore infinito");
}

}  // namespace

Arithmetic<Deep>::Arithmetic(long bits) : outer_bits_(working_bits) {
  assert(bits >= 2 && "precision of a ball");
  working_bits = bits;
}

Arithmetic<Deep>::~Arithmetic() { working_bits = outer_bits_; }

long Arithmetic<Deep>::bits() {
  assert(working_bits > 0 && "Deep is used without an Arithmetic<Deep> scope");
  return working_bits;
}

Deep Deep::from_double(double value) {
  assert(std::isfinite(value));
  Deep result;
  arb_set_d(result.ball_, value);
  return result;
}

Deep Deep::from_bounded(const Bounded& value) {
  assert(std::isfinite(value.inf()) && std::isfinite(value.sup()));
  Deep result;
  Float lower, upper;
  arf_set_d(lower.value, value.inf());
  arf_set_d(upper.value, value.sup());
  arb_set_interval_arf(result.ball_, lower.value, upper.value, Arithmetic<Deep>::bits());
  return result;
}

Deep Deep::from_ball(const arb_t ball) {
  require_finite(ball);
  Deep result;
  arb_set(result.ball_, ball);
  return result;
}

Deep& Deep::operator+=(const Deep& other) {
  arb_add(ball_, ball_, other.ball_, Arithmetic<Deep>::bits());
  return *this;
}

Deep& Deep::operator-=(const Deep& other) {
  arb_sub(ball_, ball_, other.ball_, Arithmetic<Deep>::bits());
  return *this;
}

Deep& Deep::operator*=(const Deep& other) {
  arb_mul(ball_, ball_, other.ball_, Arithmetic<Deep>::bits());
  return *this;
}

Deep& Deep::operator/=(const Deep& other) {
  if (arb_contains_zero(other.ball_))
    throw Undecided("division by a number that cannot be told from zero",
                    "divisione per un numero che non si distingue da zero");
  arb_div(ball_, ball_, other.ball_, Arithmetic<Deep>::bits());
  require_finite(ball_);
  return *this;
}

Deep Deep::operator-() const {
  Deep result;
  arb_neg(result.ball_, ball_);
  return result;
}

Sign sign(const Deep& x) {
  if (arb_is_positive(x.ball())) return Sign::positive;
  if (arb_is_negative(x.ball())) return Sign::negative;
  return arb_is_zero(x.ball()) ? Sign::zero : Sign::undecided;
}

namespace {

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
  assert(sign(x) != Sign::negative && "root of a number proved negative");
  return compute([&](arb_t result) { arb_sqrtpos(result, x.ball(), Arithmetic<Deep>::bits()); });
}

Deep square(const Deep& x) {
  return compute([&](arb_t result) {
    arb_sqr(result, x.ball(), Arithmetic<Deep>::bits());
    arb_nonnegative_part(result, result);
  });
}

Deep arc_tangent(const Deep& y, const Deep& x) {
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
  return compute([&](arb_t result) { arb_cos(result, angle.ball(), Arithmetic<Deep>::bits()); });
}

Deep sine_of_angle(const Deep& angle) {
  return compute([&](arb_t result) { arb_sin(result, angle.ball(), Arithmetic<Deep>::bits()); });
}

template <>
Deep from_rational<Deep>(const Rational& value) {
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
  return compute([](arb_t result) { arb_const_pi(result, Arithmetic<Deep>::bits()); });
}

template <>
Deep cosine<Deep>(const Turn& turn) {
  if (const auto known = rational_cosine(turn)) return from_rational<Deep>(*known);
  const Rational half_turns = Rational(2) * within_one_turn(turn).fraction;
  return compute([&](arb_t result) { cosine_of_half_turns(result, half_turns); });
}

template <>
Deep sine<Deep>(const Turn& turn) {
  return cosine<Deep>(turn_for_sine(turn));
}

}  // namespace epure::geometry
