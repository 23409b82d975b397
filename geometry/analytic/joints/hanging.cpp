#include <algorithm>
#include <iterator>
#include <set>

#include "geometry/analytic/joints/equations.h"

namespace epure::geometry::analytic {
namespace {

using namespace joints;

// The links of these equations, a row each.
std::vector<std::vector<int>> links_of_equations(const Linkage& linkage, const Hanging& hanging) {
  const std::vector<LinkState<Fast>> anywhere = states(Column<Fast>(unknowns_of_a_link * (linkage.links.size() - 1)));
  std::vector<std::vector<int>> all;
  for (const Equation<Fast>& row : JointEquations<Fast>(linkage, anywhere, hanging).all()) {
    std::vector<int>& links = all.emplace_back();
    for (const auto& [column, slope] : row.slopes) links.push_back(column / unknowns_of_a_link + 1);
  }
  return all;
}

}  // namespace

Hanging all_links(const Linkage& linkage) {
  Hanging all{std::vector<bool>(linkage.links.size(), false), std::vector<bool>(linkage.links.size(), true)};
  all.stands[0] = true;
  all.is_placed[0] = false;
  return all;
}

std::vector<Hanging> one_after_another(const Linkage& linkage, const std::vector<std::vector<int>>& order) {
  std::vector<Hanging> all;
  const std::vector<bool> none(linkage.links.size(), false);
  Hanging next{none, none};
  next.stands[0] = true;
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const int link : order[k]) next.is_placed[static_cast<std::size_t>(link)] = true;
    const auto unknowns = unknowns_of_a_link * std::count(next.is_placed.begin(), next.is_placed.end(), true);
    const std::vector<std::vector<int>> rows = links_of_equations(linkage, next);
    // Wheels may hang on each other in another order: then they are placed together.
    const bool is_whole = static_cast<std::ptrdiff_t>(rows.size()) == unknowns || k + 1 == order.size();
    if (unknowns == 0 || !is_whole) continue;
    std::set<int> on;
    for (const std::vector<int>& row : rows) on.insert(row.begin(), row.end());
    std::copy_if(on.begin(), on.end(), std::back_inserter(next.on), [&](int link) { return !next.places(link); });
    all.push_back(next);
    for (std::size_t i = 0; i < none.size(); ++i) next.stands[i] = next.has(static_cast<int>(i));
    next.is_placed = none;
    next.on.clear();
  }
  return all;
}

}  // namespace epure::geometry::analytic
