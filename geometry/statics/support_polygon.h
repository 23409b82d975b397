// The reactions of a hinge and a roller by one funicular polygon. Of the hinge's force only a point is known, the
// hinge: so the first string runs through it. The last one ends on the line of the roller's force, and the closing
// line joins its end with the hinge. The ray parallel to that line meets, in the force polygon, the roller's force
// drawn from the end of the loads: so far reaches the roller's force, and the hinge's closes. Nothing has to meet
// that is parallel: loads parallel to the roller's force, or in equilibrium, are found as all others are.
#pragma once

#include <vector>

#include "geometry/statics/free_bodies.h"

namespace epure::geometry {

template <class T>
struct ForceAt {
  Point<T> at;
  Vector<T> f;
};

template <class T>
struct SupportPolygon {
  Point<T> pole;
  std::vector<Point<T>> corners;   // of the loads laid end to end, from (0, 0); one more than loads
  std::vector<Point<T>> vertices;  // of the funicular polygon: on the loads' lines, the last on the roller's
  Point<T> between;  // the roller's force comes to here from the last corner, the hinge's goes to the first
};

// `pole`: in line with no load, nor from the last corner along the roller's force: the strings there would be
// parallel to the line that they are to meet, and Impossible or Undecided is thrown; so it is when the roller's line
// passes through the hinge A.
template <class T>
SupportPolygon<T> support_polygon(const std::vector<ForceAt<T>>& loads, const Point<T>& A,
                                  const LineOfAction<T>& roller, const Point<T>& pole) {
  SupportPolygon<T> polygon{pole, {{T(0), T(0)}}, {}, {}};
  Point<T> from = A;
  const auto draw_string = [&](const Line<T>& until) {
    from = finite(meet(line(from, polygon.corners.back() - pole), until));
    polygon.vertices.push_back(from);
  };
  for (const ForceAt<T>& load : loads) {
    draw_string(line(load.at, load.f));
    polygon.corners.push_back(polygon.corners.back() + load.f);
  }
  draw_string(roller.unit());
  polygon.between = finite(meet(line(pole, from - A), line(polygon.corners.back(), roller.along)));
  return polygon;
}

}  // namespace epure::geometry
