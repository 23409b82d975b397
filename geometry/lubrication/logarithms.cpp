#include "geometry/lubrication/logarithms.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/growing.h"

namespace epure::geometry {
namespace {

// ln n = log1p(n - 1), times `times`, less `less` (n - 1).
void times_logarithm(arb_t result, const arb_t n, const arb_t times, const arb_t less, long bits) {
  Ball beyond, rest;
  arb_sub_si(beyond.value, n, 1, bits);
  arb_mul(rest.value, beyond.value, less, bits);
  arb_log1p(result, beyond.value, bits);
  arb_mul(result, result, times, bits);
  arb_sub(result, result, rest.value, bits);
}

void plain(arb_t result, const arb_t n, long bits) {
  Ball times, less;
  arb_one(times.value);
  times_logarithm(result, n, times.value, less.value, bits);
}

void drag(arb_t result, const arb_t n, long bits) {
  Ball times, less;
  arb_add_si(times.value, n, 1, bits);
  arb_mul_2exp_si(times.value, times.value, 1);
  arb_set_si(less.value, 3);
  times_logarithm(result, n, times.value, less.value, bits);
}

void load(arb_t result, const arb_t n, long bits) {
  Ball times, less;
  arb_add_si(times.value, n, 1, bits);
  arb_set_si(less.value, 2);
  times_logarithm(result, n, times.value, less.value, bits);
}

// n² - 1 = (n + 1)(n - 1).
void couple(arb_t result, const arb_t n, long bits) {
  Ball times, less;
  arb_add_si(times.value, n, 4, bits);
  arb_mul(times.value, times.value, n, bits);
  arb_add_si(times.value, times.value, 1, bits);
  arb_add_si(less.value, n, 1, bits);
  arb_mul_si(less.value, less.value, 3, bits);
  times_logarithm(result, n, times.value, less.value, bits);
}

BallFunction function(Logarithms which) {
  switch (which) {
    case Logarithms::plain:
      return plain;
    case Logarithms::drag:
      return drag;
    case Logarithms::load:
      return load;
    case Logarithms::couple:
      break;
  }
  return couple;
}

}  // namespace

Fast logarithms(Logarithms which, Fast n) {
  if (!(n > 0))
    throw Undecided("the logarithm of a computed number that is not positive",
                    "il logaritmo di un numero calcolato non positivo");
  const Fast ln = std::log(n);
  switch (which) {
    case Logarithms::plain:
      return ln;
    case Logarithms::drag:
      return 2 * (n + 1) * ln - 3 * (n - 1);
    case Logarithms::load:
      return (n + 1) * ln - 2 * (n - 1);
    case Logarithms::couple:
      break;
  }
  return (n * n + 4 * n + 1) * ln - 3 * (n * n - 1);
}

Deep logarithms(Logarithms which, const Deep& n) {
  if (sign(n) != Sign::positive)
    throw Undecided("whether a number that has a logarithm is positive",
                    "se un numero di cui si prende il logaritmo sia positivo");
  return growing(function(which), n, 1, 0);
}

Bounded logarithms(Logarithms which, const Bounded& n) {
  return in_doubles([&] { return logarithms(which, ball(n)); });
}

}  // namespace epure::geometry
