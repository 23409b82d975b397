#include "exercises/scenes/shipped.h"

#include <algorithm>

namespace epure::scenes {

const Shipped* shipped_scene(const std::string& id) {
  const auto& all = shipped_scenes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Shipped& each) { return each.id == id; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> shipped_ids() {
  std::vector<std::string> ids;
  for (const Shipped& each : shipped_scenes()) ids.push_back(each.id);
  return ids;
}

FileHead head_of(const Shipped& scene) { return read_head(File(scene.id), read_text_tree(scene.id, scene.text)); }

}  // namespace epure::scenes
