#include "geometry/numbers/calcium.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/calcium_bridge.h"
#include "geometry/numbers/round_to_nearest.h"
#include "geometry/numbers/turn.h"

#include <cassert>
#include <numeric>
#include <utility>

namespace epure::geometry {

namespace {

thread_local epure_calcium_context* innermost_context = nullptr;

epure_calcium_context* current() {
  assert(innermost_context && "Calcium is used without an Arithmetic<Calcium> scope");
  return innermost_context;
}

// The budget, counted and not timed, so that the same question gets the same answer everywhere. What is worth a proof
// stays at some thousand terms. Products of terms are looked at beforehand, since one multiplication may already take
// too long.
constexpr long most_products_in_all = 20000000;

void require_small_result(const epure_calcium_number* x, epure_calcium_context* context) {
  constexpr long most_terms = 5000;
  if (epure_calcium_terms(x, context) > most_terms)
    throw Undecided("an exact number grew beyond 5000 terms", "un numero esatto ha superato 5000 termini");
}
void require_small_task(const epure_calcium_number* a, const epure_calcium_number* b,
                        epure_calcium_context* context) {
  constexpr long most_products = 1000000;
  const long products = epure_calcium_terms(a, context) * epure_calcium_terms(b, context);
  if (products > most_products)
    throw Undecided("exact numbers grew beyond 1000000 products of terms",
                    "numeri esatti hanno superato 1000000 di prodotti di termini");
  if (!epure_calcium_spend(products, context))
    throw Undecided("an exact proof grew beyond 20000000 products of terms",
                    "una dimostrazione esatta ha superato 20000000 di prodotti di termini");
}

// Every number of a scene lives over the field of its directions, and costs the more the higher its degree.
// Directions of a higher one than this are special by no accident that lengths of a few digits could bring about.
constexpr long highest_degree = 20;

// The degree of exp(iπ half_turns) over the rational numbers: Euler's φ of its order, and at least √(order/2).
bool is_of_low_degree(const Rational& half_turns) {
  constexpr long highest_order = 2 * highest_degree * highest_degree;
  const Rational denominator(half_turns.denominator());
  if (denominator > highest_order) return false;
  const long q = static_cast<long>(denominator.to_double());
  const long order = mpz_even_p(half_turns.numerator().mpz()) != 0 ? q : 2 * q;
  long degree = 0;
  for (long k = 1; k <= order; ++k) degree += std::gcd(k, order) == 1 ? 1 : 0;
  return degree <= highest_degree;
}

}  // namespace

Arithmetic<Calcium>::Arithmetic()
    : context_(epure_calcium_open(most_products_in_all)), outer_(std::exchange(innermost_context, context_)) {}

Arithmetic<Calcium>::~Arithmetic() {
  innermost_context = outer_;
  epure_calcium_close(context_);
}

Calcium::Calcium() : context_(current()), number_(epure_calcium_new(context_)) {}
Calcium::Calcium(int value) : Calcium(Rational(value)) {}
Calcium::Calcium(const Rational& value) : Calcium() { epure_calcium_set_rational(number_, value.mpq(), context_); }
Calcium::Calcium(const Calcium& other) : context_(other.context_), number_(epure_calcium_new(context_)) {
  epure_calcium_set(number_, other.number_, context_);
}
Calcium::Calcium(Calcium&& other) noexcept
    : context_(other.context_), number_(std::exchange(other.number_, nullptr)) {}
Calcium& Calcium::operator=(Calcium other) noexcept {
  std::swap(context_, other.context_);
  std::swap(number_, other.number_);
  return *this;
}
Calcium::~Calcium() {
  if (number_) epure_calcium_free(number_, context_);
}

Calcium operator+(const Calcium& a, const Calcium& b) {
  const RoundToNearest rounding;
  assert(a.context_ == b.context_ && "numbers of two Arithmetic<Calcium> scopes");
  Calcium result;
  require_small_task(a.number_, b.number_, a.context_);
  epure_calcium_add(result.number_, a.number_, b.number_, a.context_);
  require_small_result(result.number_, a.context_);
  return result;
}

Calcium operator-(const Calcium& a, const Calcium& b) {
  const RoundToNearest rounding;
  assert(a.context_ == b.context_ && "numbers of two Arithmetic<Calcium> scopes");
  Calcium result;
  require_small_task(a.number_, b.number_, a.context_);
  epure_calcium_subtract(result.number_, a.number_, b.number_, a.context_);
  require_small_result(result.number_, a.context_);
  return result;
}

Calcium operator*(const Calcium& a, const Calcium& b) {
  const RoundToNearest rounding;
  assert(a.context_ == b.context_ && "numbers of two Arithmetic<Calcium> scopes");
  Calcium result;
  require_small_task(a.number_, b.number_, a.context_);
  epure_calcium_multiply(result.number_, a.number_, b.number_, a.context_);
  require_small_result(result.number_, a.context_);
  return result;
}

Calcium operator/(const Calcium& a, const Calcium& b) {
  const RoundToNearest rounding;
  assert(a.context_ == b.context_ && "numbers of two Arithmetic<Calcium> scopes");
  const Sign divisor = sign(b);
  if (divisor == Sign::zero)
    throw Undecided("division by a quantity that is proved to be zero",
                    "divisione per una grandezza che è zero, come è dimostrato");
  if (divisor == Sign::undecided)
    throw Undecided("division by a quantity that may be zero", "divisione per una grandezza che può essere zero");
  Calcium result;
  require_small_task(a.number_, b.number_, a.context_);
  epure_calcium_divide(result.number_, a.number_, b.number_, a.context_);
  require_small_result(result.number_, a.context_);
  return result;
}

Calcium Calcium::operator-() const {
  const RoundToNearest rounding;
  Calcium result;
  epure_calcium_negate(result.number_, number_, context_);
  return result;
}

Deep to_deep(const Calcium& x) {
  const RoundToNearest rounding;
  Ball ball;
  epure_calcium_enclose(ball.value, x.number_, Arithmetic<Deep>::bits(), x.context_);
  return Deep::from_ball(ball.value);
}

namespace {

// What balls of up to so many bits say; a number without bounds counts as undecided.
Sign sign_by_balls(const Calcium& x, long from_bits, long to_bits) {
  for (long bits = from_bits; bits <= to_bits; bits *= 2) {
    const Arithmetic<Deep> scope(bits);
    try {
      if (const Sign found = sign(to_deep(x)); found == Sign::positive || found == Sign::negative) return found;
    } catch (const Undecided&) {
      // a wider ball than the doubling can help with yet: the next precision may bound it
    }
  }
  return Sign::undecided;
}

}  // namespace

// Every number here is real (made from rationals, real roots, cosines and pi), so the real part carries the sign. A
// ball answers most questions in microseconds; the proof of zero is asked only when it does not.
Sign sign(const Calcium& x) {
  const RoundToNearest rounding;
  if (const Sign found = sign_by_balls(x, 64, 128); found != Sign::undecided) return found;
  switch (epure_calcium_is_zero(x.number_, x.context_)) {
    case EPURE_CALCIUM_YES:
      return Sign::zero;
    case EPURE_CALCIUM_NO:
      return sign_by_balls(x, 256, 16384);
    default:
      return Sign::undecided;
  }
}

Calcium root(const Calcium& x) {
  const RoundToNearest rounding;
  assert(sign(x) != Sign::negative && "root of a number proved negative");
  Calcium result;
  epure_calcium_root(result.number_, x.number_, x.context_);
  return result;
}

Calcium Calcium::pi() {
  Calcium result;
  epure_calcium_set_pi(result.number_, result.context_);
  return result;
}

Calcium Calcium::cosine(const Turn& turn) {
  const RoundToNearest rounding;
  if (const auto known = rational_cosine(turn)) return Calcium(*known);
  const Rational half_turns = Rational(2) * within_one_turn(turn).fraction;
  if (!is_of_low_degree(half_turns))
    throw Undecided("a direction of more than degree 20 in an exact number",
                    "una direzione di grado maggiore di 20 in un numero esatto");
  Calcium result;
  epure_calcium_set_cosine(result.number_, half_turns.mpq(), result.context_);
  return result;
}

template <>
Calcium cosine<Calcium>(const Turn& turn) {
  return Calcium::cosine(turn);
}

template <>
Calcium sine<Calcium>(const Turn& turn) {
  return Calcium::cosine(turn_for_sine(turn));
}

}  // namespace epure::geometry
