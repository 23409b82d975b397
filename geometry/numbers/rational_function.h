// A rational function of a few indeterminates with rational coefficients, in lowest terms: what a tower of roots
// stands on when directions are left open.
#pragma once

#include "geometry/numbers/deep.h"
#include "geometry/numbers/rational_function_bridge.h"
#include "geometry/numbers/surd.h"

#include <array>
#include <memory>
#include <optional>

namespace epure::geometry {

class RationalFunction {
 public:
  static constexpr int variables = EPURE_FUNCTION_VARIABLES;

  RationalFunction() : RationalFunction(0) {}
  RationalFunction(int value) : RationalFunction(Rational(value)) {}
  explicit RationalFunction(const Rational& value);
  // The indeterminate of this number, from 0.
  static RationalFunction variable(int number);

  friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator/(const RationalFunction& a, const RationalFunction& b);  // b is not zero
  RationalFunction operator-() const;

  bool is_zero() const;
  // The rational function of which this is the square, of either sign, if there is one.
  std::optional<RationalFunction> root() const;

  // Where the indeterminates have these values. Throws Undecided where the denominator may vanish.
  Deep at(const std::array<Deep, variables>& values) const;

 private:
  struct Free {
    void operator()(epure_function* x) const;
  };
  // Never changed once made, so that copies share it.
  std::shared_ptr<const epure_function> value_;

  explicit RationalFunction(std::shared_ptr<const epure_function> value) : value_(std::move(value)) {}
  template <class Make>
  static RationalFunction made(const Make& make);
};

template <>
struct FieldOf<RationalFunction> {
  static bool is_zero(const RationalFunction& x) { return x.is_zero(); }
  static std::optional<RationalFunction> root(const RationalFunction& x) { return x.root(); }
};

// How much may still be computed with rational functions in this thread, in products of one word of a coefficient
// with another: so long a computation takes the same answers on every machine. While alive; the one before comes
// back. An operation that would go beyond throws Undecided.
class FunctionBudget {
 public:
  explicit FunctionBudget(long products);
  ~FunctionBudget();
  FunctionBudget(const FunctionBudget&) = delete;
  FunctionBudget& operator=(const FunctionBudget&) = delete;

 private:
  long outer_;
};

}  // namespace epure::geometry
