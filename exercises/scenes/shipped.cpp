#include "exercises/scenes/shipped.h"

#include <algorithm>

namespace epure::scenes {

const Shipped* shipped_scene(std::string_view id) {
  const auto& all = shipped_scenes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Shipped& each) { return each.id == id; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> shipped_ids() {
  std::vector<std::string> ids;
  for (const Shipped& each : shipped_scenes()) ids.emplace_back(each.id);
  return ids;
}

FileHead head_of(const Shipped& scene) {
  const std::string name(scene.id);
  return read_head(File(name), read_text_tree(name, scene.text));
}

}  // namespace epure::scenes
