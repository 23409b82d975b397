// Graphical integration, as drawn by hand: the mean ordinate of each strip is carried to the axis of ordinates, a ray
// from the pole on the axis of abscissae, left of the origin, goes there, and over the strip the integral polygon
// runs parallel to the ray.
//
//   const auto v = graphical_integral<T>(ends, accelerations_in_the_middles, scales.pole_distance());
//   const auto s = graphical_integral<T>(ends, v.middles(), ...);     // the polygon integrated once more
//
// Over a strip of width w the polygon rises by w y/H. With abscissae and ordinates in the units of the diagram, H = 1
// gives the integral itself; with all three in metres of paper, H of the scales gives it at the scale that is wanted.
//
// With ordinates read in the middles the polygon's corners are off by Σ w³ y''/24 (y'' somewhere in each strip); with
// the means of those at the ends (Bezout's formula) by -Σ w³ y''/12. Between corners it is a chord, not a tangent.
#pragma once

#include <cassert>
#include <vector>

#include "geometry/constructions/ordinate.h"

namespace epure::geometry {

// What a metre of paper is worth along each axis of the diagram, and along the ordinates of its integral.
template <class T>
struct IntegrationScales {
  T abscissa, ordinate, integral;
  // On paper, in metres. Throws Undecided unless the first two are proved different from zero.
  T pole_distance() const { return quotient(integral, abscissa * ordinate); }
};

template <class T>
struct IntegralPolygon {
  T pole_distance;
  std::vector<T> carried;         // from the strips to the axis of ordinates
  std::vector<Line<T>> strings;   // as many
  std::vector<Point<T>> corners;  // above the strips' ends: one more

  Point<T> pole() const { return {-pole_distance, T(0)}; }
  Vector<T> ray(std::size_t strip) const { return Point<T>{T(0), carried[strip]} - pole(); }
  // Over an abscissa of this strip.
  T at(std::size_t strip, const T& x) const { return ordinate(strings[strip], x); }
  // Its ordinates in the middles of the strips, to be integrated once more.
  std::vector<T> middles() const {
    std::vector<T> all;
    for (std::size_t i = 0; i < strings.size(); ++i) all.push_back(midpoint(corners[i], corners[i + 1]).y);
    return all;
  }
  // By how much its corners lie above an integral of which the ordinates at the strips' ends are known.
  std::vector<T> off_from(const std::vector<T>& integral) const {
    assert(integral.size() == corners.size());
    std::vector<T> all;
    for (std::size_t i = 0; i < corners.size(); ++i) all.push_back(corners[i].y - integral[i]);
    return all;
  }
};

// Strip i runs from ends[i] to ends[i + 1], its mean ordinate is means[i]; the polygon begins at the ordinate
// `start`.
template <class T>
IntegralPolygon<T> graphical_integral(const std::vector<T>& ends, const std::vector<T>& means, const T& pole_distance,
                                      const T& start = T(0)) {
  assert(ends.size() == means.size() + 1);
  IntegralPolygon<T> polygon{pole_distance, means, {}, {{ends.front(), start}}};
  for (std::size_t i = 0; i < means.size(); ++i) {
    polygon.strings.push_back(line(polygon.corners.back(), polygon.ray(i)));
    polygon.corners.push_back({ends[i + 1], polygon.at(i, ends[i + 1])});
  }
  return polygon;
}

// The mean ordinates of strips whose curve is taken for its chord: of its ordinates at their ends.
template <class T>
std::vector<T> means_of_ends(const std::vector<T>& ordinates) {
  std::vector<T> all;
  for (std::size_t i = 1; i < ordinates.size(); ++i) all.push_back(quotient(ordinates[i - 1] + ordinates[i], T(2)));
  return all;
}

// Of a diagram integrated twice: its area from the first abscissa to the second has its centroid under the point
// where the tangents of the second integral at both meet. Parallel tangents meet at infinity: the area is zero.
template <class T>
ProjectivePoint<T> over_centroid(const Line<T>& first_tangent, const Line<T>& last_tangent) {
  return meet(first_tangent, last_tangent);
}

}  // namespace epure::geometry
