// The loci of the two sheets drawn by the transport method: the linkage as they need it.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/curve.h"
#include "exercises/slider-crank-velocity/exercise.h"
#include "geometry/curves/polodes.h"

namespace epure::slider_crank_velocity {

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

// The positions a student would draw: the driving link's circle divided.
inline constexpr int positions = 12;
struct Position {
  int number;         // of the division; with B behind A, where both occur, 12 more
  std::string label;  // as the sheet has it: the second closure's are primed
  Place A, B;
  std::optional<Place> P0, P0_on_coupler;  // none when at infinity
  Place C;                                 // the reference triangle carried here
};
std::vector<Position> divided_positions(const SliderCrankInstant& instant);

// How the positions were found, as the first step of a construction.
std::string division_in_words(const SliderCrankInstant& instant, Language language);

// Traces and draws one locus of every loop: `locus_of(loop)` makes it.
template <class LocusOf>
geometry::Trace draw_loci(Plot& plot, const SliderCrankInstant& instant, const LocusOf& locus_of,
                          const drawings::Box& room, Meaning meaning, const std::string& name) {
  geometry::Trace all;
  for (const auto& loop : loops_of<geometry::Bounded>(instant)) {
    const geometry::Trace traced = draw_locus(plot, locus_of(loop), room, meaning, name);
    all.branches.insert(all.branches.end(), traced.branches.begin(), traced.branches.end());
    all.gaps.insert(all.gaps.end(), traced.gaps.begin(), traced.gaps.end());
  }
  return all;
}

}  // namespace epure::slider_crank_velocity
