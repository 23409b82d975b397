// A chain of straight bars in a level plane, clamped where it begins and loaded upright where it ends: bending and
// torsion by cutting it, rotations and displacements by Mohr's elastic weights.
//
// A rotation is a vector in the plane, and so is a moment. What a bar gives way by is a rotation about a line of the
// plane; it moves a point as a force along that line has a moment about the point. So each piece of a moment diagram
// is laid off as a force, its elastic weight, and all moments about a point make up how far the point rises.
//
// z upwards, right-handed; seen from above, counter-clockwise positive.
#pragma once

#include <array>
#include <vector>

#include "geometry/statics/force.h"

namespace epure::geometry {

struct FrameBar {
  Point<Rational> from;
  Vector<Rational> along;  // of length 1
  Rational length;

  Vector<Rational> across() const { return quarter_turn(along); }
  Point<Rational> at(const Rational& x) const { return from + x * along; }
  Point<Rational> to() const { return at(length); }
};

// Along the axis and across it, with the signs that bend the bar's end upwards and twist it clockwise, as seen from
// the end.
struct SectionMoment {
  Rational bending, torsion;
};

// The moment of an upright force about a point of the plane.
inline Vector<Rational> moment_of_upright(const Rational& upwards, const Point<Rational>& at,
                                          const Point<Rational>& about) {
  return -(upwards * quarter_turn(at - about));
}

// In the cut at x, from what acts on the piece beyond it: a load downwards in its end.
inline SectionMoment moment_in_cut(const FrameBar& bar, const Rational& x, const Rational& load,
                                   const Point<Rational>& loaded) {
  const Vector<Rational> M = moment_of_upright(-load, loaded, bar.at(x));
  return {-dot(M, bar.across()), -dot(M, bar.along)};
}

struct CutBar {
  FrameBar bar;
  SectionMoment start, middle, end;
};
inline CutBar cut_bar(const FrameBar& bar, const Rational& load, const Point<Rational>& loaded) {
  const auto in_cut = [&](const Rational& x) { return moment_in_cut(bar, x, load, loaded); };
  return {bar, in_cut(0), in_cut(bar.length / 2), in_cut(bar.length)};
}

template <class T>
struct BarStiffness {
  T bending, torsion;  // EJ, GJ_t
};

// A linear diagram is two triangles, each with its centroid at a third of the bar.
template <class T>
struct ElasticWeights {
  std::array<Force<T>, 2> bending;
  Force<T> torsion;
};

template <class T>
Vector<T> in_number(const Vector<Rational>& v) {
  return {from_rational<T>(v.x), from_rational<T>(v.y)};
}

template <class T>
Point<T> in_number(const Point<Rational>& P) {
  return {from_rational<T>(P.x), from_rational<T>(P.y)};
}

// Areas of the bar's diagrams over its stiffness.
template <class T>
ElasticWeights<T> elastic_weights(const CutBar& cut, const BarStiffness<T>& stiffness) {
  const FrameBar& bar = cut.bar;
  const auto weight = [](const Point<Rational>& at, const Rational& area, const Vector<Rational>& axis,
                         const T& over) {
    const Vector<T> turn = in_number<T>(-(area * axis));
    return Force<T>{in_number<T>(at), {quotient(turn.x, over), quotient(turn.y, over)}};
  };
  const auto triangle = [&](const Rational& height, const Rational& x) {
    return weight(bar.at(x), height * bar.length / 2, bar.across(), stiffness.bending);
  };
  return {{triangle(cut.start.bending, bar.length / 3), triangle(cut.end.bending, 2 * bar.length / 3)},
          weight(bar.from, cut.start.torsion * bar.length, bar.along, stiffness.torsion)};
}

// How far X rises by these weights.
template <class T>
T rise(const std::array<Force<T>, 2>& weights, const Point<T>& X) {
  return moment(weights[0], X) + moment(weights[1], X);
}

template <class T>
struct WeighedBars {
  std::vector<ElasticWeights<T>> weights;

  // Of the end of the `count`th bar: how far it has turned, and how far X, carried by it, rises.
  Vector<T> rotation(int count) const {
    Vector<T> theta{T(0), T(0)};
    for (int i = 0; i < count; ++i)
      theta = theta + weights[i].bending[0].f + weights[i].bending[1].f + weights[i].torsion.f;
    return theta;
  }
  T rise(int count, const Point<T>& X) const {
    T w(0);
    for (int i = 0; i < count; ++i) w += geometry::rise(weights[i].bending, X) + moment(weights[i].torsion, X);
    return w;
  }
};

}  // namespace epure::geometry
