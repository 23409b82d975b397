// The loci of the two sheets drawn by the transport method: the linkage as they need it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/linkages/slider_crank_loops.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/slider-crank-velocity/exercise.h"

namespace epure::slider_crank_velocity {

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

// Whether its A has its number already, without the prime: of one direction of the crank there is one A.
bool shares_A(const Position& at, const std::vector<Position>& all);

// Points with their numbers; those that are one point on the paper bear all of theirs.
std::vector<std::pair<Place, std::string>> numbered_together(
    const Plot& plot, const std::vector<std::pair<Place, std::string>>& points);

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
