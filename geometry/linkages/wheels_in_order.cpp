#include "geometry/linkages/wheels_in_order.h"

#include <algorithm>
#include <set>

namespace epure::geometry {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Which steps each step builds on.
class Foundations {
 public:
  Foundations(const Linkage& linkage, const std::vector<Step>& steps)
      : linkage_(linkage), of_links_(linkage.links.size(), nothing), on_(steps.size()) {
    for (std::size_t k = 0; k < steps.size(); ++k)
      for (const int link : placed_by(steps[k])) of_links_[index(link)] = static_cast<int>(k);
    for (int p = 0; p < linkage.count_of_points(); ++p) of_points_.push_back(first_at(p, steps));
    for (int p = 0; p < linkage.count_of_points(); ++p)
      for (const int link : linkage.links_at(p)) join(of_points_[index(p)], of_links_[index(link)]);
    for (const PinOnLine& pin : linkage.pins) join(of_points_[index(pin.point)], of_line(pin.line));
    for (const LineOnLine& block : linkage.blocks) join(of_line(block.moving), of_line(block.guide));
    for (const Drive& drive : linkage.drives) {
      if (const auto* slid = std::get_if<SlidPoint>(&drive))
        join(of_points_[index(slid->point)], of_line(slid->guide));
      if (const auto* cylinder = std::get_if<Stretched>(&drive))
        join(of_points_[index(cylinder->from)], of_points_[index(cylinder->to)]);
    }
  }
  const std::set<int>& of(std::size_t step) const { return on_[step]; }

 private:
  int of_line(int line) const { return of_links_[index(linkage_.link_of_line(line))]; }
  int first_at(int point, const std::vector<Step>& steps) const {
    const std::vector<int> there = linkage_.links_at(point);
    int first = of_links_[index(there.front())];
    for (const int link : there) first = std::min(first, of_links_[index(link)]);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const auto* slid = std::get_if<SlidPin>(&steps[k]);
      const auto* tracks = std::get_if<TwoTracks>(&steps[k]);
      const auto* rods = std::get_if<TwoRods>(&steps[k]);
      const auto* rod = std::get_if<RodAndTrack>(&steps[k]);
      const int joint = slid ? slid->point : tracks ? tracks->joint : rods ? rods->joint : rod ? rod->joint : nothing;
      if (joint == point) first = std::min(first, static_cast<int>(k));
    }
    return first;
  }
  // The later of two steps builds on the earlier one; `nothing` is the frame's.
  void join(int one, int other) {
    if (one != other && one != nothing && other != nothing)
      on_[index(std::max(one, other))].insert(std::min(one, other));
  }

  const Linkage& linkage_;
  std::vector<int> of_links_, of_points_ = {};
  std::vector<std::set<int>> on_;
};

class Ordering {
 public:
  Ordering(const Linkage& linkage, const std::vector<Step>& steps)
      : linkage_(linkage),
        steps_(steps),
        foundations_(linkage, steps),
        is_done_(steps.size(), false),
        is_placed_(linkage.links.size(), false) {
    is_placed_[0] = true;
  }
  WheelsInOrder all() {
    WheelsInOrder found;
    for (std::size_t next; (next = ready()) < steps_.size();) {
      is_done_[next] = true;
      for (const int link : placed_by(steps_[next])) is_placed_[index(link)] = true;
      found.steps.push_back(steps_[next]);
    }
    for (std::size_t k = 0; k < steps_.size(); ++k)
      if (const auto* wheel = std::get_if<GearedWheel>(&steps_[k]); wheel && !is_done_[k])
        found.left.push_back(wheel->link);
    return found;
  }

 private:
  std::size_t ready() const {
    std::size_t k = 0;
    while (k < steps_.size() && (is_done_[k] || !stands(k))) ++k;
    return k;
  }
  bool stands(std::size_t step) const {
    const std::set<int>& on = foundations_.of(step);
    if (!std::all_of(on.begin(), on.end(), [&](int k) { return is_done_[index(k)]; })) return false;
    const auto* wheel = std::get_if<GearedWheel>(&steps_[step]);
    return !wheel || std::count_if(linkage_.gears.begin(), linkage_.gears.end(),
                                   [&](const MeshingLinks& gear) { return tells(gear, *wheel); }) == 1;
  }
  bool tells(const MeshingLinks& gear, const GearedWheel& wheel) const {
    if (gear.first != wheel.link && gear.second != wheel.link) return false;
    const int other = gear.first == wheel.link ? gear.second : gear.first;
    return is_placed_[index(other)] && is_placed_[index(gear.carrier)] &&
           linkage_.hinge_of(wheel.link, gear.carrier) == wheel.hinge;
  }

  const Linkage& linkage_;
  const std::vector<Step>& steps_;
  Foundations foundations_;
  std::vector<bool> is_done_, is_placed_;
};

}  // namespace

WheelsInOrder wheels_in_order(const Linkage& linkage, const std::vector<Step>& steps) {
  return Ordering(linkage, steps).all();
}

}  // namespace epure::geometry
