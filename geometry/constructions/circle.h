// What compasses do: circles with lines and with circles, and the division of a circle.
#pragma once

#include "geometry/constructions/plane.h"
#include "geometry/numbers/angle.h"

namespace epure::geometry {

template <class T>
struct Circle {
  Point<T> centre;
  T radius;
};

// A circle meets a directed line ahead of or behind the foot of the perpendicular from its centre.
enum class Along { ahead, behind };

// A second circle meets the first on the left or right of the line from the first centre to the second.
enum class Side { left, right };

constexpr Side opposite(Side side) { return side == Side::left ? Side::right : Side::left; }

// The point of l and the circle that lies `which` of the foot. At contact both are the foot.
// Throws Impossible when they do not meet, Undecided when the number at hand cannot tell.
template <class T>
Point<T> meet(const Circle<T>& circle, const Line<T>& l, Along which) {
  const Point<T> F = foot(circle.centre, l);
  const T half_chord_squared = square(circle.radius) - length_squared(F - circle.centre);
  const Sign decided = sign(half_chord_squared);
  if (decided == Sign::undecided)
    throw Undecided("whether a circle reaches a line", "se una circonferenza raggiunga una retta");
  if (decided == Sign::negative)
    throw Impossible("the circle does not reach the line", "la circonferenza non raggiunge la retta");
  const Vector<T> d = l.direction();
  const T step = root(quotient(half_chord_squared, length_squared(d)));
  return which == Along::ahead ? F + step * d : F + (-step) * d;
}

// The point of both circles on the named side of the line of centres. At contact both are the point of contact.
// Throws Impossible when the circles lie apart, one inside the other, or are concentric; Undecided as above.
template <class T>
Point<T> meet(const Circle<T>& first, const Circle<T>& second, Side which) {
  const Vector<T> d = second.centre - first.centre;
  const T d2 = length_squared(d);
  if (sign(d2) == Sign::zero) throw Impossible("the circles are concentric", "le circonferenze sono concentriche");
  // Along the line of centres by the radical line; across it by Heron's formula for the triangle of both radii and
  // the distance, which loses fewer digits than what is left of a radius where the triangle is flat.
  const T twice_along = d2 + square(first.radius) - square(second.radius);
  const T across_squared = (d2 - square(first.radius - second.radius)) * (square(first.radius + second.radius) - d2);
  const Sign decided = sign(across_squared);
  if (decided == Sign::undecided) throw Undecided("whether two circles meet", "se due circonferenze si incontrino");
  if (decided == Sign::negative) throw Impossible("the circles do not meet", "le circonferenze non si incontrano");
  const T across = root(across_squared);
  const Vector<T> n = quarter_turn(d);
  const T twice_d2 = T(2) * d2;
  const T along_share = quotient(twice_along, twice_d2), across_share = quotient(across, twice_d2);
  return first.centre + (along_share * d + (which == Side::left ? across_share : -across_share) * n);
}

// `start` turned about `centre` by an angle, counter-clockwise: one point of the division of a circle.
template <class T>
Point<T> turned(const Point<T>& start, const Point<T>& centre, const Angle& angle) {
  const Vector<T> r = start - centre;
  return centre + (cosine<T>(angle) * r + sine<T>(angle) * quarter_turn(r));
}

}  // namespace epure::geometry
