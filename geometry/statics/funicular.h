// Parallel forces by the funicular polygon: their resultant's line, the reactions of two supports, bending moments;
// and, with areas of the diagram of moments as forces (Mohr), the tangents of the elastic line.
//
// The forces are laid end to end on the load line x = 0 of a plane of their own, upwards positive, from (0, 0). The
// rays from a pole left of it to the corners between them have the directions of the strings, of which each joins the
// lines of action of two neighbours. Lines of action are x = at; the order of the forces is free.
#pragma once

#include <vector>

#include "geometry/constructions/ordinate.h"

namespace epure::geometry {

template <class T>
struct VerticalForce {
  T at, up;
};

// `distance` > 0 from the load line, in the unit of the forces.
template <class T>
struct Pole {
  T distance, height;
};

template <class T>
struct FunicularPolygon {
  Pole<T> pole;
  std::vector<T> corners;          // of the load line, one more than forces
  std::vector<Line<T>> strings;    // as many as corners
  std::vector<Point<T>> vertices;  // on the lines of action

  Vector<T> ray(const T& corner) const { return {pole.distance, corner - pole.height}; }
  // The rise of a string over a unit of length.
  static T slope(const Line<T>& string) {
    const Vector<T> along = string.direction();
    return quotient(along.y, along.x);
  }
};

// `start` is a point of the first string.
template <class T>
FunicularPolygon<T> funicular(const std::vector<VerticalForce<T>>& forces, const Pole<T>& pole,
                              const Point<T>& start) {
  FunicularPolygon<T> polygon{pole, {T(0)}, {}, {}};
  polygon.strings.push_back(line(start, polygon.ray(T(0))));
  for (const VerticalForce<T>& force : forces) {
    polygon.vertices.push_back({force.at, ordinate(polygon.strings.back(), force.at)});
    polygon.corners.push_back(polygon.corners.back() + force.up);
    polygon.strings.push_back(line(polygon.vertices.back(), polygon.ray(polygon.corners.back())));
  }
  return polygon;
}

// The loads of `polygon` on two supports: the closing line joins the first string on the first support with the last
// string on the last one, and the ray parallel to it parts the load line into the reactions, upwards positive.
template <class T>
struct TwoSupports {
  Line<T> closing;
  T corner;  // of its ray
  T first, last;
};
template <class T>
TwoSupports<T> on_two_supports(const FunicularPolygon<T>& polygon, const T& first, const T& last) {
  const Point<T> A{first, ordinate(polygon.strings.front(), first)}, B{last, ordinate(polygon.strings.back(), last)};
  const Line<T> closing = line(A, B);
  const Point<T> pole{-polygon.pole.distance, polygon.pole.height};
  const T corner = ordinate(parallel(closing, pole), T(0));
  return {closing, corner, polygon.corners.front() - corner, corner - polygon.corners.back()};
}

}  // namespace epure::geometry
