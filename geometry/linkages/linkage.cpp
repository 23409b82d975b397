#include "geometry/linkages/linkage.h"

#include <algorithm>
#include <cassert>

namespace epure::geometry {

int Linkage::count_of_points() const {
  int count = 0;
  for (const Link& link : links)
    for (const LinkPoint& p : link.points) count = std::max(count, p.point + 1);
  return count;
}

int Linkage::count_of_lines() const {
  int count = 0;
  for (const Link& link : links)
    for (const LinkLine& l : link.lines) count = std::max(count, l.line + 1);
  return count;
}

std::vector<int> Linkage::links_at(int point) const {
  std::vector<int> there;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (std::any_of(links[i].points.begin(), links[i].points.end(),
                    [&](const LinkPoint& p) { return p.point == point; }))
      there.push_back(static_cast<int>(i));
  return there;
}

int Linkage::link_of_line(int line) const {
  for (std::size_t i = 0; i < links.size(); ++i)
    for (const LinkLine& l : links[i].lines)
      if (l.line == line) return static_cast<int>(i);
  assert(!"a line of no link");
  return 0;
}

const Own& Linkage::place(int link, int point) const {
  const auto& points = links[static_cast<std::size_t>(link)].points;
  const auto found = std::find_if(points.begin(), points.end(), [&](const LinkPoint& p) { return p.point == point; });
  assert(found != points.end());
  return found->at;
}

const LinkLine& Linkage::line(int line) const {
  const auto& lines = links[static_cast<std::size_t>(link_of_line(line))].lines;
  return *std::find_if(lines.begin(), lines.end(), [&](const LinkLine& l) { return l.line == line; });
}

int Linkage::hinge_of(int one, int other) const {
  for (const LinkPoint& p : links[static_cast<std::size_t>(one)].points) {
    const std::vector<int> there = links_at(p.point);
    if (std::find(there.begin(), there.end(), other) != there.end()) return p.point;
  }
  return nothing;
}

// Inside, beyond the centre of the smaller wheel; else between the two.
Own Linkage::pitch_point(const MeshingLinks& gear) const {
  const Own &O = place(gear.carrier, hinge_of(gear.first, gear.carrier)), r = line_of_centres(gear);
  const Rational share = gear.first_teeth / (gear.is_inside ? Rational(gear.first_teeth - gear.second_teeth)
                                                            : Rational(gear.first_teeth + gear.second_teeth));
  return {O.x + share * r.x, O.y + share * r.y};
}

Own Linkage::line_of_centres(const MeshingLinks& gear) const {
  const Own &O = place(gear.carrier, hinge_of(gear.first, gear.carrier)),
            &Q = place(gear.carrier, hinge_of(gear.second, gear.carrier));
  return {Q.x - O.x, Q.y - O.y};
}

int Linkage::freedom() const {
  int free = 3 * (static_cast<int>(links.size()) - 1);
  for (int point = 0; point < count_of_points(); ++point)
    free -= 2 * std::max(0, static_cast<int>(links_at(point).size()) - 1);
  return free - static_cast<int>(pins.size()) - 2 * static_cast<int>(blocks.size()) - static_cast<int>(gears.size()) -
         static_cast<int>(rolls.size()) - static_cast<int>(drives.size());
}

bool Linkage::is_turned_steadily() const {
  const auto* turned = drives.size() == 1 ? std::get_if<TurnedLink>(&drives[0]) : nullptr;
  return turned && turned->omega.radians == 0 && is_zero(turned->alpha);
}

}  // namespace epure::geometry
