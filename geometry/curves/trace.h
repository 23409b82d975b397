// Tracing a locus: cubic Bezier arcs that stay within a proved distance of the true curve.
//
// A locus is anything callable as
//   template <class X> ProjectivePoint<X> operator()(const Vector<X>& direction) const
// the point that belongs to a unit vector turning once around: the crank, for what a crank drives. trace and
// asymptotes call it with X = BoundedSeries and BoundedTangent, sample with X = Fast.
//
// The bound. On a piece of the turn of parameter length h the cubic takes the values and derivatives of the curve at
// the ends. At equal parameters a component f is then missed by at most max|f⁗| h⁴/384 over the piece,
// (t-a)²(t-b)²/4! being at most (h/2)⁴/24; and c[4] = f⁗/24 is enclosed over the whole piece, which leaves h⁴
// max|c[4]|/16. To it is added how far the control points, rounded to doubles, may be from the true ones: the cubic
// is their convex combination. What is bounded at equal parameters bounds the distance from every point of the curve
// to the arc, and from every point of the arc to the curve.
//
// Lengths in the unit of the locus throughout. On paper 0.01 mm at 1:10 is a tolerance of 1e-4 m.
#pragma once

#include <functional>
#include <vector>

#include "geometry/constructions/plane.h"
#include "geometry/curves/taylor.h"

namespace epure::geometry {

// Nothing outside is worth drawing.
struct Frame {
  double x_min, y_min, x_max, y_max;
};

struct BezierArc {
  Point<double> start, first_control, second_control, end;
};

// A continuous run: each arc starts at the very double the one before ends at. When closed, the last ends where the
// first starts.
struct Branch {
  std::vector<BezierArc> arcs;
  double deviation = 0;     // proved upper bound
  Vector<double> from, to;  // directions (rounded) at the two ends; for a closed branch where the tracing began
  bool closed = false;
};

// A piece of the turn without a curve.
//   absent     proved: the construction is impossible throughout (the linkage does not close)
//   undecided  nothing is known: intervals of doubles cannot follow the construction there, or not to the tolerance
struct Gap {
  enum class Cause { absent, undecided } cause;
  Vector<double> from, to;  // rounded
  double width;             // radians, rounded
};

struct Trace {
  std::vector<Branch> branches;  // in the order of the turn, which begins at the direction (3/5, -4/5)
  std::vector<Gap> gaps;

  std::size_t arcs() const;
  double deviation() const;  // of the worst branch; 0 without one
};

// The locus as the tracer calls it, so that the tracer is compiled once.
struct TracedLocus {
  std::function<ProjectivePoint<BoundedSeries>(const Vector<BoundedSeries>&)> over;
  std::function<ProjectivePoint<BoundedTangent>(const Vector<BoundedTangent>&)> at;
};

// How often the locus is found over a quarter of the turn before gaps are allowed to become wider.
inline constexpr int usual_looks = 1 << 14;

// Every branch deviates by at most `tolerance`. A piece of the curve is left out only when it is proved to lie
// outside the frame (a point at infinity does), or when it is stated as a gap. What is drawn reaches at most one
// width or height of the frame beyond it. Where a root vanishes and the locus ends, the undecided gap is some 1e-12
// radians wide; where the linkage folds (l = r) noise takes more, some 1e-6, the more the finer the tolerance.
// A locus that has had three times its looks may have gaps of some 0.05 radians. A frame without an inside, or a
// tolerance that is not positive, is a caller's mistake.
Trace trace(const TracedLocus& locus, const Frame& frame, double tolerance, int looks = usual_looks);

template <class Locus>
Trace trace(const Locus& locus, const Frame& frame, double tolerance) {
  return trace(TracedLocus{locus, locus}, frame, tolerance);
}

// A point of the locus and its direction, in doubles.
struct Sample {
  Vector<Fast> direction;
  ProjectivePoint<Fast> point;
};

// The locus at n equal parts of the turn, from the direction (1, 0): for the eye, for tests and benches; proves
// nothing. Directions at which the construction finds that the point does not exist, or cannot tell, are passed over.
template <class Locus>
std::vector<Sample> sample(const Locus& locus, int n) {
  std::vector<Sample> samples;
  for (int k = 0; k < n; ++k) {
    const Turn turn{Rational(k, n)};
    const Vector<Fast> direction{cosine<Fast>(turn), sine<Fast>(turn)};
    try {
      samples.push_back({direction, locus(direction)});
    } catch (const Impossible&) {
    } catch (const Undecided&) {
    }
  }
  return samples;
}

}  // namespace epure::geometry
