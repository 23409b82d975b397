// Where the panels of a sheet stand and how large they are.
#pragma once

#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct PlacedPanel {
  const Panel* panel;
  drawings::Box room;
  Scale lengths, vectors;  // of a plane of vectors `lengths` says nothing
  drawings::Point origin;  // of its plane
  const Scale& plane() const { return panel->is_of_vectors() ? vectors : lengths; }
};

// Of all ways to divide the room, keeping the panels' order, into parts side by side and one below the other, the one
// that leaves them largest together, each at a standard scale. Vectors of one unit have one scale. A scale in the
// request is that of the first panel of lengths. What is too far is left out. Throws DoesNotFit.
std::vector<PlacedPanel> laid_out(const std::vector<const Panel*>& panels, const drawings::Box& room,
                                  const SheetRequest& request);
std::vector<PlacedPanel> laid_out(const Panels& panels, const drawings::Box& room, const SheetRequest& request);

}  // namespace epure
