// How far a drive can go, the others at rest: extremes: [theta_2] of a turned link, [s_A] of a point that is slid,
// [l_PQ] of a cylinder.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/proof/exercise.h"
#include "exercises/scenes/scene.h"
#include "geometry/linkages/carried_out.h"

namespace epure::scenes {

// What each drive sets, in the order of the file.
std::vector<Quantity> driven_coordinates(const Built& built);
// Which drive sets it; none: none does.
std::optional<std::size_t> drive_of_coordinate(const Built& built, const std::string& name);

// The least and the greatest of each of these names that a drive sets, by the construction and by the equations of
// all joints. Absent, with the reason, where a link goes right round, or a way has no end.
std::vector<RouteValue> ranges(const Built& built, const std::vector<std::string>& names, Rung rung);

// The mechanism at an end of the range, and what stops it there; or why there is none, or it is not told.
struct AtEnd {
  std::optional<geometry::LinkagePosition<geometry::Bounded>> position;
  Words words;                                 // rich text
  std::optional<geometry::TwoRods> rods = {};  // that lie in one line there, if it is two
};
AtEnd at_end(const Built& built, std::size_t drive, bool is_greatest);

}  // namespace epure::scenes
