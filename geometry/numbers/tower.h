// The tower of quadratic fields behind Exact: its radicands and the arithmetic modulo their roots.
#pragma once

#include "geometry/numbers/exact.h"

#include <optional>
#include <span>
#include <vector>

namespace epure::geometry {

class Tower {
 public:
  using Coefficients = std::vector<Rational>;

  Tower();

  // The tower of the innermost scope; asking without a scope is a caller's mistake.
  static Tower& current();

  int storeys() const { return static_cast<int>(radicands_.size()); }

  Exact add(const Exact& a, const Exact& b) const;
  Exact multiply(const Exact& a, const Exact& b) const;
  Exact inverse(const Exact& a) const;  // a is not zero

  // The root of x within the tower, of either sign, if it is there. x may be negative (then it is not).
  std::optional<Exact> root_within(const Exact& x) const { return root_within(x, storeys()); }
  // Adds the storey of √x, which must be positive and have no root within, and returns √x.
  Exact adjoin(const Exact& x);

  Deep to_deep(const Exact& x) const;

 private:
  Exact number(Coefficients coefficients) const;
  void require_ours(const Exact& x) const;

  // x = lower + upper·√(radicand of the storey), both on the storey below.
  struct Halves {
    Exact lower, upper;
  };
  Halves halves(const Exact& x, int storey) const;
  Exact join(const Exact& lower, const Exact& upper, int storey) const;

  std::optional<Exact> root_within(const Exact& x, int storey) const;
  std::optional<Exact> root_of_lower(const Exact& x, int storey) const;
  std::optional<Exact> root_of_mixed(const Halves& x, int storey) const;

  std::uint64_t serial_;
  std::vector<Exact> radicands_;  // radicand k lives on storey k, its root on storey k + 1
};

}  // namespace epure::geometry
