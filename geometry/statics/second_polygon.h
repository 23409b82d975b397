// Mohr's second funicular polygon of a chain of bars at right angles: the elastic weights of each bar's diagram of
// bending are strung on its axis, and what torsion adds is carried round the corners. Its outer strings are the
// tangents at the bar's ends, and its vertices with the ends the control points of the elastic line, a cubic.
#pragma once

#include <array>

#include "geometry/statics/frame_across.h"
#include "geometry/statics/funicular.h"

namespace epure::geometry {

// Of a section: how far it has risen, how steeply the axis rises beyond it, and how it has turned about the axis.
template <class T>
struct BarState {
  T rise, slope, turn;

  // In a bar that sets off to the left.
  BarState round_the_corner() const { return {rise, turn, -slope}; }
  // As a vector in the plane.
  Vector<T> rotation(const FrameBar& bar) const {
    return turn * in_number<T>(bar.along) - slope * in_number<T>(bar.across());
  }
};

template <class T>
struct StrungBar {
  std::array<Point<T>, 4> corners;  // along the bar and upwards: its beginning, the strings' meetings, its end
  BarState<T> end;
};

// The rays have the slopes of the elastic line when the pole is at the distance 1.
template <class T>
StrungBar<T> string_bar(const CutBar& cut, const BarState<T>& start, const BarStiffness<T>& stiffness) {
  const Rational& length = cut.bar.length;
  const auto weight = [&](const Rational& moment, const Rational& at) {
    const T area = from_rational<T>(moment * length / 2);
    return VerticalForce<T>{from_rational<T>(at), quotient(area, stiffness.bending)};
  };
  const Point<T> begin{T(0), start.rise};
  const FunicularPolygon<T> polygon = funicular<T>(
      {weight(cut.start.bending, length / 3), weight(cut.end.bending, 2 * length / 3)}, {T(1), -start.slope}, begin);
  const T end = from_rational<T>(length);
  const Point<T> last{end, ordinate(polygon.strings.back(), end)};
  const T twist = quotient(from_rational<T>(cut.start.torsion * length), stiffness.torsion);
  return {{begin, polygon.vertices[0], polygon.vertices[1], last},
          {last.y, polygon.slope(polygon.strings.back()), start.turn - twist}};
}

}  // namespace epure::geometry
