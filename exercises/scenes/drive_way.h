// How far what drives a mechanism can go, in doubles: for curves and charts over all its places.
#pragma once

#include <optional>

#include "exercises/scenes/scene.h"
#include "geometry/linkages/carried_out.h"

namespace epure::scenes {

// How many places of the drive curves are drawn with: of a turned link's turn, and of a way.
inline constexpr int shown_directions = 12, shown_ways = 9;

// Of a mechanism with one drive, which must outlive it; in a scope of Fast.
class DriveWay {
 public:
  explicit DriveWay(const Built& built) : built_(built) {}

  // Where the links are then; none where the mechanism does not close.
  std::optional<geometry::LinkagePosition<geometry::Fast>> closed_at(
      const geometry::DriveAt<geometry::Fast>& there) const;
  // A slid point so far ahead on its guide, a cylinder so long.
  static geometry::DriveAt<geometry::Fast> at(double way) { return {0, {1, 0}, way}; }

  // Of a slid point or a cylinder: the way at the givens, and the least and the greatest, from there as far as the
  // mechanism closes, or some of its sizes.
  double now() const;
  double low() const { return farthest(-1); }
  double high() const { return farthest(1); }

  // As far as the points now lie from the first of them.
  double size() const;

 private:
  const geometry::Drive& drive() const { return built_.linkage.drives.front(); }
  double farthest(double sense) const;

  const Built& built_;
};

}  // namespace epure::scenes
