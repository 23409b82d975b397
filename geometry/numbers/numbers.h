// All six numbers. A template on the number must see the functions of all of them (double and CGAL's interval live
// in other namespaces, so their functions are found only when declared before the template).
#pragma once

#include "geometry/numbers/bounded.h"
#include "geometry/numbers/calcium.h"
#include "geometry/numbers/deep.h"
#include "geometry/numbers/exact.h"
#include "geometry/numbers/fast.h"
#include "geometry/numbers/generic.h"
#include "geometry/numbers/number.h"

#include <concepts>

namespace epure::geometry {

// What a construction may ask of a number (see number.h).
template <class T>
concept Number = std::constructible_from<T, int> &&
    requires(const T a, const T b, const Turn turn, const Rational q) {
  { a + b } -> std::convertible_to<T>;
  { a - b } -> std::convertible_to<T>;
  { a* b } -> std::convertible_to<T>;
  { a / b } -> std::convertible_to<T>;
  { -a } -> std::convertible_to<T>;
  { quotient(a, b) } -> std::same_as<T>;
  { root(a) } -> std::same_as<T>;
  { square(a) } -> std::same_as<T>;
  { sign(a) } -> std::same_as<Sign>;
  { from_rational<T>(q) } -> std::same_as<T>;
  { pi<T>() } -> std::same_as<T>;
  { cosine<T>(turn) } -> std::same_as<T>;
  { sine<T>(turn) } -> std::same_as<T>;
};

// The numbers that also have arc_tangent.
template <class T>
concept NumberWithAngles = Number<T> && requires(const T y, const T x) {
  { arc_tangent(y, x) } -> std::same_as<T>;
};

}  // namespace epure::geometry
