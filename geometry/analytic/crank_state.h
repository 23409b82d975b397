// The crank that drives a mechanism, at one instant: where it points and how it turns.
#pragma once

#include "geometry/analytic/complex.h"
#include "geometry/numbers/angle.h"

namespace epure::geometry::analytic {

// cos φ and sin φ; φ' = ω₂ in rad/s and φ'' = α₂ in rad/s², counter-clockwise positive. With ω₂ = 1, α₂ = 0 no π
// enters, and Exact can run the mechanism.
template <class T>
struct CrankState {
  T cosine, sine;
  T omega, alpha;
};

template <class T>
CrankState<T> crank_at(const Angle& angle, const T& omega, const T& alpha) {
  return {cosine<T>(angle), sine<T>(angle), omega, alpha};
}

// Along a unit direction: of a special position, say.
template <class T>
CrankState<T> crank_along(const Complex<T>& direction, const T& omega, const T& alpha) {
  return {direction.re, direction.im, omega, alpha};
}

}  // namespace epure::geometry::analytic
