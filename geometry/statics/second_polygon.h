// Mohr's second funicular polygon of a chain of bars at right angles: the elastic weights of each bar's diagram of
// bending are strung on its axis, and what torsion adds is carried round the corners. Its outer strings are the
// tangents at the bar's ends, and its vertices with the ends the control points of the elastic line, a cubic.
#pragma once

#include <array>

#include "geometry/statics/frame_across.h"

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

template <class T>
StrungBar<T> string_bar(const FrameBar& bar, const BarState<T>& start, const SectionMoment& first,
                        const SectionMoment& last, const BarStiffness<T>& stiffness) {
  const auto weight = [&](const Rational& moment) {
    return quotient(from_rational<T>(moment * bar.length / 2), stiffness.bending);
  };
  const T third = from_rational<T>(bar.length / 3);
  std::array<T, 3> slopes{start.slope, start.slope, start.slope};
  slopes[1] += weight(first.bending);
  slopes[2] = slopes[1] + weight(last.bending);
  StrungBar<T> strung{{Point<T>{T(0), start.rise}, {}, {}, {}}, start};
  for (int i = 0; i < 3; ++i) strung.corners[i + 1] = strung.corners[i] + third * Vector<T>{T(1), slopes[i]};
  strung.end.rise = strung.corners[3].y;
  strung.end.slope = slopes[2];
  strung.end.turn = start.turn - quotient(from_rational<T>(first.torsion * bar.length), stiffness.torsion);
  return strung;
}

}  // namespace epure::geometry
