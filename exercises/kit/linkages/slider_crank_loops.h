// The slider-crank led through its positions: what loci of its points are traced on.
#pragma once

#include <vector>

#include "exercises/kit/linkages/slider_crank_instant.h"
#include "geometry/curves/polodes.h"

namespace epure {

// How the linkage is led through all the positions it can take from the one it stands in.
//   crank    it turns fully: B stays ahead of A
//   coupler  it turns fully, the crank swings: A stays on one side of A₀
//   both     neither does: the crank swings, and at each of its limits B changes from ahead of A to behind it or back
enum class Circuit { crank, coupler, both };
inline Circuit circuit_of(const SliderCrankInstant& instant) {
  if (geometry::crank_range(instant.lengths).is_full_turn()) return Circuit::crank;
  return geometry::coupler_turns_fully(instant.lengths) ? Circuit::coupler : Circuit::both;
}

// The loops that make up the circuit; the linkage stands on the first. Needs Arithmetic<T>.
template <class T>
std::vector<geometry::SliderCrankLoop<T>> loops_of(const SliderCrankInstant& instant) {
  using geometry::Along, geometry::Driver;
  geometry::SliderCrankLoop<T> loop{
      .r = geometry::from_rational<T>(instant.lengths.r),
      .l = geometry::from_rational<T>(instant.lengths.l),
      .e = geometry::from_rational<T>(instant.lengths.e),
      .along = instant.direction<T>(instant.guide),
  };
  const Circuit circuit = circuit_of(instant);
  if (circuit == Circuit::coupler) {
    loop.driver = Driver::coupler;
    // Square to the guide the linkage would not close.
    loop.closure = instant.crank_points_ahead() ? Along::ahead : Along::behind;
  }
  if (circuit != Circuit::both) return {loop};
  auto other = loop;
  other.closure = Along::behind;
  return {loop, other};
}

// The instant's own position, which the transports refer to. Found with many bits and then enclosed in intervals, so
// that a plate or a closure too sharp for intervals of doubles is no obstacle to the curves.
struct Reference {
  geometry::CouplerPosition<geometry::Bounded> coupler;
  geometry::Point<geometry::Bounded> C;
};
Reference reference_of(const SliderCrankInstant& instant);

}  // namespace epure
