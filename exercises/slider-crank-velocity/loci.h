// The loci of the two sheets drawn by the transport method: the linkage as they need it.
#pragma once

#include <vector>

#include "exercises/slider-crank-velocity/exercise.h"
#include "geometry/curves/polodes.h"

namespace epure::slider_crank_velocity {

// The linkage driven by its shorter link, which can turn fully, on the branch it stands on. Needs Arithmetic<T>.
template <class T>
geometry::SliderCrankLoop<T> loop_of(const SliderCrankInstant& instant) {
  const auto& [r, l, AC, BC] = instant.lengths;
  const T long_r = geometry::from_rational<T>(r), long_l = geometry::from_rational<T>(l);
  if (r <= l) return {long_r, long_l, geometry::Driver::crank, geometry::Along::ahead};
  // Crank longer than coupler: A stays on one side of A₀. (Square to the guide the linkage would not close.)
  const bool ahead = geometry::cosine<geometry::Fast>(instant.crank) > 0;
  return {long_r, long_l, geometry::Driver::coupler, ahead ? geometry::Along::ahead : geometry::Along::behind};
}

// The instant's own position, which the transports refer to. Found with many bits and then enclosed in intervals, so
// that a plate or a closure too sharp for intervals of doubles is no obstacle to the curves.
struct Reference {
  geometry::CouplerPosition<geometry::Bounded> coupler;
  geometry::Point<geometry::Bounded> C;
};
Reference reference_of(const SliderCrankInstant& instant);

// The positions a student would draw: the driving link's circle divided.
inline constexpr int positions = 12;
struct Position {
  int number;
  Place A, B;
  std::optional<Place> P0, P0_on_coupler;  // none when at infinity
  Place C;                                 // the reference triangle carried here
};
std::vector<Position> divided_positions(const SliderCrankInstant& instant);

}  // namespace epure::slider_crank_velocity
