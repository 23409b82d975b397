#include "exercises/scenes/links_alike.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace epure::scenes {
namespace {

using geometry::Linkage;

// Links that a step places together, and the links placed before that a joint of theirs can be told to be on: of a
// hinge of several links, any of them.
class HangingGroup {
 public:
  HangingGroup(const Linkage& linkage, const std::vector<int>& group, const std::set<int>& standing)
      : linkage_(linkage), group_(group), standing_(standing) {
    for (const int link : group)
      for (const geometry::LinkPoint& p : linkage.links[index(link)].points) hang(linkage.links_at(p.point));
    for (const geometry::PinOnLine& pin : linkage.pins)
      join(linkage.links_at(pin.point), {linkage.link_of_line(pin.line)});
    for (const geometry::LineOnLine& block : linkage.blocks)
      join({linkage.link_of_line(block.moving)}, {linkage.link_of_line(block.guide)});
  }

  // Nothing drives it and no wheel of it rolls: it is held by where its joints are.
  bool is_held_by_joints() const {
    const auto& drives = linkage_.drives;
    const auto& gears = linkage_.gears;
    return std::none_of(drives.begin(), drives.end(), [this](const geometry::Drive& each) { return moves(each); }) &&
           std::none_of(gears.begin(), gears.end(),
                        [this](const geometry::MeshingLinks& each) {
                          return is_in_group(each.first) || is_in_group(each.second) || is_in_group(each.carrier);
                        }) &&
           std::none_of(linkage_.rolls.begin(), linkage_.rolls.end(), [this](const geometry::RollingWheel& each) {
             return is_in_group(each.wheel) || is_in_group(linkage_.link_of_line(each.line));
           });
  }
  const std::vector<std::vector<int>>& joints() const { return joints_; }

 private:
  bool is_in_group(int link) const { return std::find(group_.begin(), group_.end(), link) != group_.end(); }
  bool any_in_group(const std::vector<int>& links) const {
    return std::any_of(links.begin(), links.end(), [this](int link) { return is_in_group(link); });
  }
  bool moves(const geometry::Drive& drive) const {
    if (const auto* turned = std::get_if<geometry::TurnedLink>(&drive)) return is_in_group(turned->link);
    if (const auto* slid = std::get_if<geometry::SlidPoint>(&drive))
      return any_in_group(linkage_.links_at(slid->point)) || is_in_group(linkage_.link_of_line(slid->guide));
    const auto& cylinder = std::get<geometry::Stretched>(drive);
    return any_in_group(linkage_.links_at(cylinder.from)) || any_in_group(linkage_.links_at(cylinder.to));
  }
  void hang(std::vector<int> links) {
    std::erase_if(links, [this](int link) { return !standing_.contains(link); });
    if (!links.empty()) joints_.push_back(std::move(links));
  }
  void join(const std::vector<int>& ones, const std::vector<int>& others) {
    if (any_in_group(ones)) hang(others);
    if (any_in_group(others)) hang(ones);
  }

  const Linkage& linkage_;
  const std::vector<int>& group_;
  const std::set<int>& standing_;
  std::vector<std::vector<int>> joints_ = {};
};

void unite(std::vector<int>& classes, int one, int other) {
  const int from = classes[index(one)], to = classes[index(other)];
  std::replace(classes.begin(), classes.end(), from, to);
}

}  // namespace

LinksAlike::LinksAlike(const Built& built) {
  const Linkage& linkage = built.linkage;
  bodies_.resize(linkage.links.size());
  std::iota(bodies_.begin(), bodies_.end(), 0);
  std::set<int> standing{0};
  for (const geometry::Step& step : built.steps) {
    const std::vector<int> placed = geometry::placed_by(step);
    const HangingGroup group(linkage, placed, standing);
    const auto holds_all = [&](int body) {
      return std::all_of(group.joints().begin(), group.joints().end(), [&](const std::vector<int>& links) {
        return std::any_of(links.begin(), links.end(), [&](int link) { return bodies_[index(link)] == body; });
      });
    };
    if (group.is_held_by_joints() && !group.joints().empty())
      for (const int link : group.joints().front())
        if (const int body = bodies_[index(link)]; holds_all(body)) {
          for (const int each : placed) unite(bodies_, each, body);
          break;
        }
    standing.insert(placed.begin(), placed.end());
  }
  turning_ = bodies_;
  for (const geometry::LineOnLine& block : linkage.blocks)
    unite(turning_, linkage.link_of_line(block.moving), linkage.link_of_line(block.guide));
}

}  // namespace epure::scenes
