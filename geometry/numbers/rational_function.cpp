#include "geometry/numbers/rational_function.h"

#include "geometry/numbers/ball.h"
#include "geometry/numbers/round_to_nearest.h"

#include <limits>
#include <utility>

namespace epure::geometry {

namespace {

const epure_function_ring* ring() {
  static const epure_function_ring* const shared = epure_function_open();
  return shared;
}

thread_local long products_left = std::numeric_limits<long>::max();

// The greatest common divisor that follows every operation costs as a few of them.
void spend(const epure_function* a, const epure_function* b) {
  const long products = epure_function_size(a, ring()) * epure_function_size(b, ring());
  if (products > products_left) {
    products_left = 0;
    throw Undecided("a proof for every direction of the links grew too long",
                    "una dimostrazione per ogni direzione dei membri è diventata troppo lunga");
  }
  products_left -= products;
}

}  // namespace

FunctionBudget::FunctionBudget(long products) : outer_(std::exchange(products_left, products)) {}
FunctionBudget::~FunctionBudget() { products_left = outer_; }

void RationalFunction::Free::operator()(epure_function* x) const { epure_function_free(x, ring()); }

template <class Make>
RationalFunction RationalFunction::made(const Make& make) {
  const RoundToNearest rounding;
  std::unique_ptr<epure_function, Free> result(epure_function_new(ring()));
  make(result.get());
  return RationalFunction(std::shared_ptr<const epure_function>(std::move(result)));
}

RationalFunction::RationalFunction(const Rational& value)
    : RationalFunction(
          made([&](epure_function* result) { epure_function_set_rational(result, value.mpq(), ring()); })) {}

RationalFunction RationalFunction::variable(int number) {
  return made([&](epure_function* result) { epure_function_set_variable(result, number, ring()); });
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  spend(a.value_.get(), b.value_.get());
  return RationalFunction::made(
      [&](epure_function* result) { epure_function_add(result, a.value_.get(), b.value_.get(), ring()); });
}

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  if (a.is_zero()) return a;
  if (b.is_zero()) return b;
  spend(a.value_.get(), b.value_.get());
  return RationalFunction::made(
      [&](epure_function* result) { epure_function_multiply(result, a.value_.get(), b.value_.get(), ring()); });
}

RationalFunction operator/(const RationalFunction& a, const RationalFunction& b) {
  spend(a.value_.get(), b.value_.get());
  return RationalFunction::made(
      [&](epure_function* result) { epure_function_divide(result, a.value_.get(), b.value_.get(), ring()); });
}

RationalFunction RationalFunction::operator-() const {
  return made([&](epure_function* result) { epure_function_negate(result, value_.get(), ring()); });
}

bool RationalFunction::is_zero() const { return epure_function_is_zero(value_.get(), ring()) != 0; }

std::optional<RationalFunction> RationalFunction::root() const {
  spend(value_.get(), value_.get());
  bool is_square = false;
  RationalFunction found =
      made([&](epure_function* result) { is_square = epure_function_root(result, value_.get(), ring()) != 0; });
  return is_square ? std::optional(std::move(found)) : std::nullopt;
}

Deep RationalFunction::at(const std::array<Deep, variables>& values) const {
  const RoundToNearest rounding;
  std::array<arb_struct, variables> balls;  // borrowed
  for (std::size_t i = 0; i < balls.size(); ++i) balls[i] = *values[i].ball();
  Ball result;
  epure_function_enclose(result.value, value_.get(), balls.data(), Arithmetic<Deep>::bits(), ring());
  return Deep::from_ball(result.value);
}

}  // namespace epure::geometry
