// Closed formulas for what the constructions do with ruler and compass: the second route, for tests.
// Lengths in metres (any one unit will do), everything else without unit. Undecided signs throw Undecided.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/analytic/decide.h"

#include <optional>

namespace epure::geometry::analytic {

// Foot of the perpendicular from z on the line through `on` with direction `along`, by projection.
// Throws Undecided when the direction is zero or may be.
template <class T>
Complex<T> foot(const Complex<T>& z, const Complex<T>& on, const Complex<T>& along) {
  return on + quotient(dot(along, z - on), squared_modulus(along)) * along;
}

// The factors of a closed polygon  known + first * u + second * v = 0.
template <class T>
struct TwoMagnitudes {
  T first, second;
};

// A polygon of vectors with two unknown magnitudes along the directions u and v, by Cramer's rule on real and
// imaginary part. The factors are signed and multiply u and v as given (unit vectors make them magnitudes). Empty
// when u and v are parallel or one is zero: then there is no solution or a line of them.
template <class T>
std::optional<TwoMagnitudes<T>> close_polygon(const Complex<T>& known, const Complex<T>& u, const Complex<T>& v) {
  const T determinant = cross(u, v);
  if (is_zero(determinant, {"whether the two directions are parallel", "se le due direzioni siano parallele"}))
    return {};
  return TwoMagnitudes<T>{-quotient(cross(known, v), determinant), -quotient(cross(u, known), determinant)};
}

// Meet of the line through p with direction u and the line through q with direction v, by Cramer's rule. Empty when
// they are parallel or the same.
template <class T>
std::optional<Complex<T>> meet_of_lines(const Complex<T>& p, const Complex<T>& u, const Complex<T>& q,
                                        const Complex<T>& v) {
  const auto along = close_polygon(p - q, u, v);
  if (!along) return {};
  return p + along->first * u;
}

// Where a directed line meets a circle; the same point twice where it touches.
template <class T>
struct Crossings {
  Complex<T> entering, leaving;  // in the order in which the line's direction meets them
};

// Line through p with direction u (not zero) and the circle about `centre` with the given radius >= 0, by the
// quadratic formula for |p + t u - centre|² = radius². Empty when the line misses.
template <class T>
std::optional<Crossings<T>> meet_of_line_and_circle(const Complex<T>& p, const Complex<T>& u,
                                                    const Complex<T>& centre, const T& radius) {
  const Complex<T> from = p - centre;
  const T a = squared_modulus(u), half_b = dot(u, from), c = squared_modulus(from) - square(radius);
  const T discriminant = square(half_b) - a * c;
  if (decided_sign(discriminant, {"whether the line reaches the circle", "se la retta raggiunga la circonferenza"}) ==
      Sign::negative)
    return {};
  const T spread = root(discriminant);
  return Crossings<T>{p + quotient(-half_b - spread, a) * u, p + quotient(-half_b + spread, a) * u};
}

// Where two circles meet, named by the side of the directed line from the first centre to the second; the same point
// twice where they touch.
template <class T>
struct CirclesMeet {
  Complex<T> left, right;
};

// Circles about p and q with radii >= 0: along pq by the radical line, square to it by Heron's formula for the
// triangle of both radii and the distance. Empty when they do not meet. Throws Impossible when the centres coincide.
template <class T>
std::optional<CirclesMeet<T>> meet_of_circles(const Complex<T>& p, const T& p_radius, const Complex<T>& q,
                                              const T& q_radius) {
  const Complex<T> d = q - p;
  const T d2 = squared_modulus(d);
  if (is_zero(d2, {"whether the circles are concentric", "se le circonferenze siano concentriche"}))
    throw Impossible("concentric circles: no meets, or all points",
                     "circonferenze concentriche: nessun punto comune, o tutti");
  // 16 area² = (d² - (R - r)²) ((R + r)² - d²)
  const T sixteen_areas_squared = (d2 - square(p_radius - q_radius)) * (square(p_radius + q_radius) - d2);
  if (decided_sign(sixteen_areas_squared, {"whether the circles meet", "se le circonferenze si incontrino"}) ==
      Sign::negative)
    return {};
  const T two_d2 = T(2) * d2;
  const T along = quotient(d2 + square(p_radius) - square(q_radius), two_d2);
  const T aside = quotient(root(sixteen_areas_squared), two_d2);
  return CirclesMeet<T>{p + Complex<T>{along, aside} * d, p + Complex<T>{along, -aside} * d};
}

}  // namespace epure::geometry::analytic
