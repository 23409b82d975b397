// The loci of the slider-crank's coupler plane, drawn position by position: the two polodes and the coupler curves.
//
// One position after another is found from the direction of a link; the figure A, B, P₀ is carried back with tracing
// paper until AB lies on the AB of a reference position (its P₀ then draws the moving polode, as the coupler in its
// reference position carries it), or the reference triangle ABC is carried forth onto the new AB (C then draws the
// coupler curve). The only root is the one that closes the linkage.
#pragma once

#include <vector>

#include "geometry/constructions/transport.h"
#include "geometry/mechanisms/slider_crank.h"

namespace epure::geometry {

// The link whose direction is given: the crank A₀A, or the coupler A -> B. When it can turn fully (the shorter by |e|
// or more of the two, see crank_range), a locus is one closed branch (seen projectively). Driven by a link that
// cannot, the linkage closes for part of the turn only; when neither can, the loci of both closures together are the
// whole.
enum class Driver { crank, coupler };

// The other pin is found on the guide (B), or on the parallel to the guide through it (A): ahead of or behind the
// foot. `ahead` with the crank as driver is the slider_crank of mechanisms/.
template <class T>
struct SliderCrankLoop {
  T r, l;  // A₀A, AB
  Driver driver = Driver::crank;
  Along closure = Along::ahead;
  T e{0};                       // of the guide from A₀, as in slider_crank
  Vector<T> along{T(1), T(0)};  // the guide's direction, a unit vector
};

// What is found with the guide level, on the sheet with the guide in its direction.
template <class T>
ProjectivePoint<T> turned_with_guide(const ProjectivePoint<T>& P, const Vector<T>& along) {
  return {P.x * along.x - P.y * along.y, P.x * along.y + P.y * along.x, P.w};
}
template <class T>
Point<T> turned_with_guide(const Point<T>& P, const Vector<T>& along) {
  return {P.x * along.x - P.y * along.y, P.x * along.y + P.y * along.x};
}

template <class T>
struct CouplerPosition {
  Point<T> A, B;
  ProjectivePoint<T> P0;
};

// `direction` is the driver's as seen from the guide, so that crank or coupler square to the guide is exactly that: a
// linkage that just touches there is followed to within 1e-5 radians; had the direction to be turned first, noise
// would take a thousand times more work. Throws Impossible when the linkage does not close, Undecided when that
// cannot be told.
template <class T>
CouplerPosition<T> coupler_position(const SliderCrankLoop<T>& loop, const Vector<T>& direction) {
  const Point<T> A0{T(0), T(0)};
  const Line<T> guide = guide_of_slider_crank(loop.e, {T(1), T(0)});
  Point<T> A, B;
  if (loop.driver == Driver::crank) {
    A = A0 + loop.r * direction;
    B = joint_on_guide(A, loop.l, guide, loop.closure);
  } else {
    const Vector<T> AB = loop.l * direction;
    const Point<T> foot_of_A0{T(0), loop.e};
    A = joint_on_guide(A0, loop.r, parallel(guide, foot_of_A0 + (-AB)), loop.closure);
    B = A + AB;
  }
  const ProjectivePoint<T> P0 = meet(line(A0, A), perpendicular(guide, B));
  return {turned_with_guide(A, loop.along), turned_with_guide(B, loop.along), turned_with_guide(P0, loop.along)};
}

// A position beside the reference: the tracing paper that carries the reference coupler onto it, and the one back.
template <class T>
struct TransportedPosition {
  CouplerPosition<T> here;
  Transport<T> forth, back;

  TransportedPosition(const CouplerPosition<T>& reference, const CouplerPosition<T>& position)
      : here(position),
        forth(reference.A, reference.B, position.A, position.B),
        back(position.A, position.B, reference.A, reference.B) {}

  // P₀ as a point of the coupler, where the coupler has it in the reference position: a point of the moving polode.
  ProjectivePoint<T> P0_on_coupler() const { return back(here.P0); }
};

// The division of the circle: n unit vectors from +x, counter-clockwise, as they are seen from the direction `from`.
template <class T>
std::vector<Vector<T>> directions_of_divided_circle(int n, const Angle& from = {}) {
  const Point<T> centre{T(0), T(0)}, start{T(1), T(0)};
  std::vector<Vector<T>> directions;
  for (int k = 0; k < n; ++k) directions.push_back(turned(start, centre, Angle{Rational(k, n)} - from) - centre);
  return directions;
}

// The loci. Made of plain numbers T and called with X: T itself, or a series over T (see trace.h).

template <class X, class T>
Point<X> lifted(const Point<T>& P) {
  return {X(P.x), X(P.y)};
}
template <class X, class T>
ProjectivePoint<X> lifted(const ProjectivePoint<T>& P) {
  return {X(P.x), X(P.y), X(P.w)};
}
template <class X, class T>
SliderCrankLoop<X> lifted(const SliderCrankLoop<T>& loop) {
  return {X(loop.r), X(loop.l), loop.driver, loop.closure, X(loop.e), {X(loop.along.x), X(loop.along.y)}};
}
template <class X, class T>
CouplerPosition<X> lifted(const CouplerPosition<T>& p) {
  return {lifted<X>(p.A), lifted<X>(p.B), lifted<X>(p.P0)};
}

// P₀ in the fixed plane.
template <class T>
struct FixedPolode {
  SliderCrankLoop<T> loop;

  template <class X>
  ProjectivePoint<X> operator()(const Vector<X>& direction) const {
    return coupler_position(lifted<X>(loop), direction).P0;
  }
};

// P₀ in the coupler, drawn with the coupler in its reference position.
template <class T>
struct MovingPolode {
  SliderCrankLoop<T> loop;
  CouplerPosition<T> reference;

  template <class X>
  ProjectivePoint<X> operator()(const Vector<X>& direction) const {
    const CouplerPosition<X> position = coupler_position(lifted<X>(loop), direction);
    return TransportedPosition<X>(lifted<X>(reference), position).P0_on_coupler();
  }
};

// The path of C, a point of the coupler given in its reference position.
template <class T>
struct CouplerCurve {
  SliderCrankLoop<T> loop;
  CouplerPosition<T> reference;
  Point<T> C;

  template <class X>
  ProjectivePoint<X> operator()(const Vector<X>& direction) const {
    const CouplerPosition<X> position = coupler_position(lifted<X>(loop), direction);
    return projective(TransportedPosition<X>(lifted<X>(reference), position).forth(lifted<X>(C)));
  }
};

}  // namespace epure::geometry
