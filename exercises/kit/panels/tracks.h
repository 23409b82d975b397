// Vectors of one figure that lie on one another are drawn beside each other: a vector painted back over another would
// hide its head, and seem to end it there.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "drawings/picture.h"

namespace epure {

using VectorOnPaper = std::pair<drawings::Point, drawings::Point>;  // mm, from and to

struct Track {
  drawings::Point by = {};                      // mm: how far aside the vector stands
  std::optional<drawings::Point> letters = {};  // the side of it where its letters stand, a unit vector; none: either
};

// What two vectors cover together, mm along the first from where it starts; nothing where the eye tells them apart.
std::optional<std::pair<double, double>> covered(const VectorOnPaper& a, const VectorOnPaper& b);

// In the order in which the vectors are drawn: what would lie on one before it moves aside, if it can away from
// `middle`. But before all others come those that `stay`, because the construction goes on from where they end. A
// vector that is no longer than its head covers none. Of a polygon, what is drawn over another one from the same
// point in the same sense, with its head well before, stays: as vectors from a pole either is read to its head.
enum class LyingOver { of_a_polygon, anything };
std::vector<Track> tracks(const std::vector<VectorOnPaper>& vectors, drawings::Point middle,
                          LyingOver which = LyingOver::of_a_polygon, const std::vector<std::size_t>& stay = {});

}  // namespace epure
