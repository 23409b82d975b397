// The cubic Bezier arc with the values and derivatives of a curve at two parameters, and how far it may be from it.
#pragma once

#include "geometry/curves/trace.h"

namespace epure::geometry {

// The curve at one parameter, enclosed, and the double that is drawn for it.
struct Knot {
  double t;
  Point<Bounded> position;
  Vector<Bounded> derivative;  // by t
  Point<double> drawn;
};

Knot knot(double t, const Point<BoundedTangent>& at);

struct FittedArc {
  BezierArc arc;
  // The two parts of the bound on |arc - curve| at equal parameters: what a cubic misses, which falls with the fourth
  // power of the length of the piece, and what doubles for the control points miss.
  double interpolation, rounding;
  double deviation() const;  // infinite when the curve is not bounded
  // How much longer the next piece may be so that the fourth power of its length still keeps to the tolerance; a
  // little less, because c[4] is not constant. At most doubled, because far ahead the prediction is worth little.
  double growth(double tolerance) const;
};

// `fourth` encloses the fourth Taylor coefficient of the curve from a.t to b.t. Needs an Arithmetic<Bounded> scope,
// for the bounds too.
FittedArc fit(const Knot& a, const Knot& b, const Vector<Bounded>& fourth);

// c[4] over an interval of parameters, narrowed by the mean value theorem: c[4] = c[4] at m + 5 c[5] somewhere
// between times (t - m), intersected with c[4] of `over`. `over` and `middle` are one series over `t` and at its
// middle m.
Bounded fourth_coefficient(const BoundedSeries& over, const BoundedSeries& middle, const Bounded& t, double m);

}  // namespace epure::geometry
