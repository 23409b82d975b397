#include "geometry/analytic/joints/equations.h"

#include <algorithm>

namespace epure::geometry::analytic::joints {

std::vector<int> links_at(const Linkage& linkage, const Hanging& hanging, int point) {
  std::vector<int> there = linkage.links_at(point);
  std::erase_if(there, [&](int link) { return !hanging.has(link); });
  std::stable_partition(there.begin(), there.end(), [&](int link) { return !hanging.places(link); });
  return there;
}
bool is_joined(const Linkage& linkage, const Hanging& hanging, std::initializer_list<int> points,
               std::initializer_list<int> links) {
  bool places_one = false;
  for (const int link : links) {
    if (!hanging.has(link)) return false;
    places_one = places_one || hanging.places(link);
  }
  for (const int point : points) {
    const std::vector<int> there = links_at(linkage, hanging, point);
    if (there.empty()) return false;
    places_one = places_one || hanging.places(there.front());
  }
  return places_one;
}

std::vector<std::optional<ToldByGear>> told_by_gears(const Linkage& linkage) {
  std::vector<std::optional<Angle>> known(linkage.links.size());
  const auto of = [&](int link) -> std::optional<Angle>& { return known[static_cast<std::size_t>(link)]; };
  of(0) = Angle{};
  for (const Drive& drive : linkage.drives)
    if (const auto* turned = std::get_if<TurnedLink>(&drive)) of(turned->link) = turned->angle;
  // θ_second - phase = m θ_first + (1 - m) θ_carrier
  const auto told = [&](const MeshingLinks& gear) -> std::optional<ToldByGear> {
    const Rational m = gear.turns_of_second();
    const auto &first = of(gear.first), &second = of(gear.second), &carrier = of(gear.carrier);
    if (first && carrier && !second)
      return ToldByGear{gear.second, gear.phase + m * *first + Rational(1 - m) * *carrier};
    if (second && carrier && !first)
      return ToldByGear{gear.first, Rational(1 / m) * (*second - gear.phase - Rational(1 - m) * *carrier)};
    if (first && second && !carrier && m != 1)
      return ToldByGear{gear.carrier, Rational(1 / Rational(1 - m)) * (*second - gear.phase - m * *first)};
    return {};
  };
  std::vector<std::optional<ToldByGear>> all(linkage.gears.size());
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (!all[k] && (all[k] = told(linkage.gears[k]))) {
        of(all[k]->link) = all[k]->angle;
        is_new = true;
      }
  }
  return all;
}

}  // namespace epure::geometry::analytic::joints
