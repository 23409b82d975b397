// Which links move as one body, and which turn alike: as the joints alone tell, whatever the givens are. A block
// turns as its guide; what hangs on one body only, with nothing that drives it, is a part of that body.
#pragma once

#include <vector>

#include "exercises/scenes/scene.h"

namespace epure::scenes {

class LinksAlike {
 public:
  explicit LinksAlike(const Built& built);

  // Where these say no, numbers may still find that they do.
  bool move_as_one(std::size_t i, std::size_t j) const { return bodies_[i] == bodies_[j]; }
  bool turn_alike(std::size_t i, std::size_t j) const { return turning_[i] == turning_[j]; }

 private:
  std::vector<int> bodies_, turning_;  // by link, a link of each
};

}  // namespace epure::scenes
