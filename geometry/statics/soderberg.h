// Soderberg's diagram: the mean stress σ_m to the right, the range Δσ upwards.
#pragma once

#include "geometry/constructions/ordinate.h"

namespace epure::geometry {

inline constexpr Phrase mean_stress_yields{"the mean stress reaches the yield stress: no range of stress is left",
                                           "la tensione media raggiunge lo snervamento: non resta ampiezza alcuna"};

// The line from the yield stress on the axis of σ_m through the state meets the axis of Δσ in the range that is worth
// the state's with a mean stress of zero. Throws Impossible when σ_m is not below the yield stress.
template <class T>
T range_without_mean(const T& mean, const T& range, const T& yield) {
  const Sign left = sign(yield - mean);
  if (left == Sign::undecided)
    throw Undecided("whether the mean stress reaches the yield stress",
                    "se la tensione media raggiunga lo snervamento");
  if (left != Sign::positive) throw Impossible(mean_stress_yields);
  return ordinate(line(Point<T>{mean, range}, Point<T>{yield, T(0)}), T(0));
}

}  // namespace epure::geometry
