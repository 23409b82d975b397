// A curve over an interval of a plain parameter (an angle, a length), drawn as cubic Bezier arcs that stay within a
// proved distance of it.
//
// A curve is anything callable as
//   template <class X> Point<X> operator()(const X& t) const
// trace_span calls it with X = BoundedSeries and BoundedTangent. The bound is the one explained in trace.h; it
// compares points at equal parameters, so a point at rest (a cusp) is a place like any other.
//
// Lengths in the unit of the curve.
#pragma once

#include <functional>
#include <vector>

#include "geometry/curves/trace.h"

namespace epure::geometry {

struct SpanTrace {
  std::vector<BezierArc> arcs = {};  // each starts at the very double the one before ends at
  double deviation = 0;              // proved upper bound
};

// The curve as the tracer calls it, so that the tracer is compiled once.
struct SpannedCurve {
  std::function<Point<BoundedSeries>(const BoundedSeries&)> over;
  std::function<Point<BoundedTangent>(const BoundedTangent&)> at;
};

// The whole curve from one parameter to the other, deviating by at most `tolerance`. Requires from < to, both finite,
// and a tolerance above zero: else a caller's mistake (assertion).
// Throws Impossible when the curve does so over a piece; Undecided when intervals of doubles cannot follow the curve
// to the tolerance somewhere (a root that vanishes, or a tolerance below the noise of doubles).
SpanTrace trace_span(const SpannedCurve& curve, double from, double to, double tolerance);

template <class Curve>
SpanTrace trace_span(const Curve& curve, double from, double to, double tolerance) {
  return trace_span(SpannedCurve{curve, curve}, from, to, tolerance);
}

}  // namespace epure::geometry
