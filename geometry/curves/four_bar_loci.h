// The path of a point of a four-bar's coupler, position by position, for the tracer (trace.h).
#pragma once

#include "geometry/mechanisms/four_bar.h"

namespace epure::geometry {

// P lies `along` from A towards B and `across` to the left of it (metres). By the direction of the crank: one circuit
// where the crank turns fully; else the part of it with B on the named side of A -> B₀, which meets that of the other
// side at the limit positions of the crank.
struct FourBarCouplerCurve {
  FourBarLengths of;
  Side side;
  Rational along, across;

  template <class X>
  ProjectivePoint<X> operator()(const Vector<X>& crank) const {
    const FourBar<X> at = four_bar(of, crank, side);
    const Vector<X> AB = at.B - at.A;
    return projective(at.A +
                      (from_rational<X>(along / of.AB) * AB + from_rational<X>(across / of.AB) * quarter_turn(AB)));
  }
};

}  // namespace epure::geometry
