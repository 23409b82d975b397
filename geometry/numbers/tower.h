// A tower of quadratic extensions over a field F: its radicands and the arithmetic modulo their roots.
//
// A root is adjoined only when its radicand has none in the tower already, so that every storey is a true field
// extension. Two things follow, and everything on top rests on them:
//   - the coefficients of an element are unique, so it is zero exactly when all of them are (no bound, no search);
//   - division is safe: no conjugate of a nonzero element vanishes.
#pragma once

#include "geometry/numbers/rational_field.h"
#include "geometry/numbers/rational_function.h"

#include <functional>
#include <optional>
#include <vector>

namespace epure::geometry {

template <class Field>
class Tower {
 public:
  using Element = Surd<Field>;
  using Coefficients = std::vector<Field>;

  // `is_no_square` may know of some elements, at little cost, that they have no root in the tower.
  explicit Tower(std::function<bool(const Element&)> is_no_square);

  int storeys() const { return static_cast<int>(radicands_.size()); }

  Element add(const Element& a, const Element& b) const;
  Element multiply(const Element& a, const Element& b) const;
  Element inverse(const Element& a) const;  // a is not zero

  // The root of x within the tower, of either sign, if it is there.
  std::optional<Element> root_within(const Element& x) const { return root_within(x, storeys()); }
  // Adds the storey of √x, which must have no root within, and returns √x.
  Element adjoin(const Element& x);

  // A ball around an element, every root being the positive one; `ball` makes one of an element of F. The radicands
  // must not be negative there.
  template <class BallOfField>
  Deep to_deep(const Element& x, const BallOfField& ball) const {
    require_ours(x);
    if (x.is_in_field()) return ball(x.in_field());
    const auto [a, b] = halves(x, x.storey());
    const Deep radicand = to_deep(this->radicand(x.storey()), ball);
    return to_deep(a, ball) + to_deep(b, ball) * epure::geometry::root(radicand);
  }

 private:
  Element number(Coefficients coefficients) const;
  void require_ours(const Element& x) const;
  const Element& radicand(int storey) const { return radicands_[static_cast<std::size_t>(storey - 1)]; }

  // x = lower + upper·√(radicand of the storey), both on the storey below.
  struct Halves {
    Element lower, upper;
  };
  Halves halves(const Element& x, int storey) const;
  Element join(const Element& lower, const Element& upper, int storey) const;

  std::optional<Element> root_within(const Element& x, int storey) const;
  std::optional<Element> root_of_lower(const Element& x, int storey) const;
  std::optional<Element> root_of_mixed(const Halves& x, int storey) const;

  std::function<bool(const Element&)> is_no_square_;
  std::uint64_t serial_;
  std::vector<Element> radicands_;  // radicand k lives on storey k, its root on storey k + 1
};

template <>
Surd<Rational> Tower<Rational>::multiply(const Element& a, const Element& b) const;  // without fractions on the way
extern template class Tower<Rational>;
extern template class Tower<RationalFunction>;

}  // namespace epure::geometry
