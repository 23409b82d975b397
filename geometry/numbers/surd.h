// An element of a tower of quadratic extensions, F in F(√a) in F(√a)(√b) ..., over a field F. The tower (tower.h)
// holds the radicands, once for all its elements, and does the arithmetic.
//
// CGAL::Sqrt_extension nested five deep would store 3^5 elements of F in every number and repeat the radicands in
// each; here a number holds the 2^k coefficients of the lowest storey it lives on.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

namespace epure::geometry {

template <class Field>
class Tower;

// What is asked of F beside + - * / and unary -, of an element x of it:
//   static bool is_zero(x)
//   static std::optional<Field> root(x)     a y with y² = x, of either sign, if there is one
template <class Field>
struct FieldOf;

template <class Field>
class Surd {
 public:
  explicit Surd(Field value) : coefficients_{std::move(value)} {}

  bool is_zero() const { return is_in_field() && FieldOf<Field>::is_zero(coefficients_.front()); }
  bool is_in_field() const { return coefficients_.size() == 1; }
  const Field& in_field() const {
    assert(is_in_field());
    return coefficients_.front();
  }

  // The lowest storey it lives on: 0 is F, k is the field with the first k roots.
  int storey() const { return std::countr_zero(coefficients_.size()); }

  Surd operator-() const {
    Surd result = *this;
    for (Field& coefficient : result.coefficients_) coefficient = -coefficient;
    return result;
  }

 private:
  friend class Tower<Field>;
  // Coefficient i belongs to the product of the roots whose bits are set in i. Of 2^storey numbers; when storey > 0
  // not all of the upper half are zero.
  std::vector<Field> coefficients_;
  std::uint64_t tower_ = 0;  // which tower the roots belong to; 0 for an element of F, at home in every tower
};

}  // namespace epure::geometry
