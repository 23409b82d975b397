// The rocker's velocity ratio ω₄/ω₂ from the instant centres, and where it is extreme.
//
// P₂₄, where coupler and frame meet, has one velocity as a point of the crank and of the rocker, so ω₄/ω₂ is the
// ratio of its distances from A₀ and B₀ (Kennedy). It is extreme when the collineation axis, the line through P₂₄ and
// the coupler's pole P₁₃, is square to the coupler (Freudenstein's theorem; Hartenberg and Denavit, Kinematic
// Synthesis of Linkages, section 12-8, where it is proved for a crank of constant speed).
#pragma once

#include "geometry/mechanisms/four_bar.h"

namespace epure::geometry {

// Where the lines of coupler and frame meet. At infinity when these are parallel: crank and rocker then turn alike.
template <class T>
ProjectivePoint<T> centre_of_crank_and_rocker(const FourBar<T>& at) {
  return meet(line(at.A, at.B), line(at.A0, at.B0));
}

// ω₄/ω₂. Throws Undecided when P₂₄ lies on B₀ (coupler and rocker in line) or that cannot be told.
template <class T>
T velocity_ratio_by_centres(const FourBar<T>& at) {
  const ProjectivePoint<T> P24 = centre_of_crank_and_rocker(at);
  const Vector<T> frame = at.B0 - at.A0;
  const auto from = [&](const Point<T>& O) {
    return dot(frame, Vector<T>{P24.x - P24.w * O.x, P24.y - P24.w * O.y});
  };
  return quotient(from(at.A0), from(at.B0));
}

// By the direction of the crank: zero where the collineation axis is square to the coupler. Defined where the linkage
// closes, and as smooth as it.
struct CollineationAxisAcrossCoupler {
  FourBarLengths of;
  Side side;

  template <class T>
  T operator()(const Vector<T>& crank) const {
    const FourBar<T> at = four_bar(of, crank, side);
    return dot(line(at.pole(), centre_of_crank_and_rocker(at)).direction(), at.B - at.A);
  }
};

}  // namespace epure::geometry
