// What links are placed with: unit vectors of directions, and two circles by the squares of their radii.
#pragma once

#include <cstdlib>

#include "geometry/linkages/linkage.h"
#include "geometry/linkages/linkage_at_place.h"
#include "geometry/mechanisms/dyad.h"
#include "geometry/numbers/rational_field.h"

namespace epure::geometry {

namespace linkages {

// What does not change while a drive moves: of a series it is made of its coefficients (every_place.h).
template <class T>
struct Constant {
  static Vector<T> direction(const Angle& angle) { return {cosine<T>(angle), sine<T>(angle)}; }
};

// The unit vector of a direction: without a root where the vector has a rational length.
template <class T>
Vector<T> unit_vector(const Direction& direction) {
  if (const auto* angle = std::get_if<Angle>(&direction)) return Constant<T>::direction(*angle);
  const auto& [x, y] = std::get<Own>(direction);
  const Rational squared = x * x + y * y;
  if (const auto length = FieldOf<Rational>::root(squared))
    return {from_rational<T>(x / *length), from_rational<T>(y / *length)};
  const T over = quotient(T(1), root(from_rational<T>(squared)));
  return {from_rational<T>(x) * over, from_rational<T>(y) * over};
}

// A unit vector turned from +x by so many times its angle.
template <class T>
Vector<T> turned_times(const Vector<T>& direction, int times) {
  const Vector<T> each = times < 0 ? Vector<T>{direction.x, -direction.y} : direction;
  if (times == 0) return {T(1), T(0)};
  Vector<T> all = each;
  for (int i = std::abs(times); i > 1; --i) all = linkages::times(all, each);
  return all;
}

template <class T>
T positive_or_zero(const T& squared, const Words& whether, const Words& impossible) {
  const Sign decided = sign(squared);
  if (decided == Sign::negative) throw Impossible(impossible);
  if (decided == Sign::undecided) throw Undecided(whether);
  return squared;
}

// P and so far along d and to a side of it: both are twice these lengths, times that of d.
template <class T>
Point<T> beside(const Point<T>& P, const Vector<T>& d, const T& twice_along, const T& twice_across, Side side) {
  const T twice = T(2) * length_squared(d), along = quotient(twice_along, twice),
          across = quotient(twice_across, twice);
  return P + (along * d + (side == Side::left ? across : -across) * quarter_turn(d));
}

// The point at the distances from P and Q of which the squares are given (r2, and by how much it is greater than the
// other), on the named side of P -> Q: circles whose radii need no root. Errors as in circle.h.
template <class T>
Point<T> meet_by_squares(const Point<T>& P, const T& r2, const Point<T>& Q, const T& greater, Side side) {
  const Vector<T> d = Q - P;
  const T d2 = length_squared(d);
  if (sign(d2) == Sign::zero) throw Impossible("the circles are concentric", "le circonferenze sono concentriche");
  const T twice_along = d2 + greater;
  const T across = root(positive_or_zero(T(4) * d2 * r2 - square(twice_along),
                                         {"whether two circles meet", "se due circonferenze si incontrino"},
                                         {"the circles do not meet", "le circonferenze non si incontrano"}));
  return beside(P, d, twice_along, across, side);
}
}  // namespace linkages

}  // namespace epure::geometry
