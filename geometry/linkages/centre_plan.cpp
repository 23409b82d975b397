#include "geometry/linkages/centre_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace epure::geometry {
namespace {

// The joints of links and stones.
class Joints {
 public:
  explicit Joints(const Linkage& linkage) {
    plan_.bodies = static_cast<int>(linkage.links.size());
    for (int point = 0; point < linkage.count_of_points(); ++point) {
      const std::vector<int> links = linkage.links_at(point);
      for (std::size_t a = 0; a < links.size(); ++a)
        for (std::size_t b = a + 1; b < links.size(); ++b) hinge(links[a], links[b], point);
    }
    for (const LineOnLine& block : linkage.blocks)
      slide({.i = linkage.link_of_line(block.moving), .j = linkage.link_of_line(block.guide), .line = block.guide});
    for (std::size_t k = 0; k < linkage.gears.size(); ++k)
      add({.i = linkage.gears[k].first, .j = linkage.gears[k].second, .gear = static_cast<int>(k)});
    for (std::size_t k = 0; k < linkage.rolls.size(); ++k)
      add({.i = linkage.rolls[k].wheel,
           .j = linkage.link_of_line(linkage.rolls[k].line),
           .roll = static_cast<int>(k)});
    for (const PinOnLine& pin : linkage.pins) {
      const int stone = plan_.bodies++;
      for (const int link : linkage.links_at(pin.point)) hinge(link, stone, pin.point);
      slide({.i = linkage.link_of_line(pin.line), .j = stone, .line = pin.line});
    }
  }
  CentrePlan plan() { return plan_; }

 private:
  void hinge(int i, int j, int point) { add({.i = i, .j = j, .point = point}); }
  void slide(const PermanentCentre& centre) { add(centre); }
  void add(PermanentCentre centre) {
    if (centre.i > centre.j) std::swap(centre.i, centre.j);
    if (!plan_.permanent_of(centre.i, centre.j)) plan_.permanent.push_back(centre);
  }
  CentrePlan plan_;
};

bool is_at_rest(const Drive& drive) {
  if (const auto* turned = std::get_if<TurnedLink>(&drive)) return is_zero(turned->omega);
  if (const auto* slid = std::get_if<SlidPoint>(&drive)) return slid->velocity == 0;
  return std::get<Stretched>(drive).velocity == 0;
}

// Round after round, from what is known.
class Search {
 public:
  Search(const Linkage& linkage, const LinkagePosition<Fast>& at, CentrePlan plan)
      : linkage_(linkage), at_(at), plan_(std::move(plan)), known_(table(plan_.permanent)) {
    double far = 0;
    for (const Point<Fast>& P : at.points) far = std::max({far, std::abs(P.x), std::abs(P.y)});
    reach_ = far > 0 ? far : 1;
  }

  CentrePlan run() {
    while (round()) {
    }
    return std::move(plan_);
  }

 private:
  using Table = std::vector<char>;
  Table table(const std::vector<PermanentCentre>& of) const {
    Table known(in_square(plan_.bodies, 0, plan_.bodies));
    for (const PermanentCentre& centre : of) mark(known, centre.i, centre.j);
    return known;
  }
  void mark(Table& known, int i, int j) const {
    known[in_square(i, j, plan_.bodies)] = known[in_square(j, i, plan_.bodies)] = 1;
  }
  bool is_known(int i, int j) const { return known_[in_square(i, j, plan_.bodies)] != 0; }

  // What is found in a round serves the next one: so each centre is found by as few others as can be.
  bool round() {
    const Centres<Fast> centres(plan_, linkage_, at_);
    const std::size_t before = plan_.found.size();
    std::vector<FoundCentre> found;
    const int links = static_cast<int>(linkage_.links.size());
    for (int i = 0; i < links; ++i)
      for (int j = i + 1; j < links; ++j)
        if (!is_known(i, j))
          if (const auto centre = best(i, j, centres)) found.push_back(*centre);
    for (const FoundCentre& centre : found) {
      plan_.found.push_back(centre);
      mark(known_, centre.i, centre.j);
    }
    return plan_.found.size() > before;
  }

  std::optional<FoundCentre> best(int i, int j, const Centres<Fast>& centres) const {
    struct Through {
      int body;
      Line<Fast> line;
    };
    std::vector<Through> lines;
    for (int k = 0; k < plan_.bodies; ++k)
      if (k != i && k != j && is_known(i, k) && is_known(k, j))
        if (const auto through = distinct(centres.of(i, k), centres.of(k, j))) lines.push_back({k, *through});
    std::optional<FoundCentre> found;
    double best = smallest;
    for (std::size_t a = 0; a < lines.size(); ++a)
      for (std::size_t b = a + 1; b < lines.size(); ++b)
        if (const double how = meeting(lines[a].line, lines[b].line); how > best) {
          best = how;
          found = {i, j, lines[a].body, lines[b].body};
        }
    return found;
  }

  // The line of two points, scaled so that its normal is a unit vector (or its third coordinate one, at infinity).
  std::optional<Line<Fast>> distinct(const ProjectivePoint<Fast>& P, const ProjectivePoint<Fast>& Q) const {
    const auto unit = [&](const ProjectivePoint<Fast>& X) {
      const double size = std::hypot(X.x / reach_, X.y / reach_, X.w);
      return ProjectivePoint<Fast>{X.x / size / reach_, X.y / size / reach_, X.w / size};
    };
    const Line<Fast> l = line(unit(P), unit(Q));
    if (!(std::hypot(l.a, l.b, l.c) > smallest)) return {};
    const double normal = std::hypot(l.a, l.b);
    const double size = normal > smallest * std::abs(l.c) ? normal : std::abs(l.c);
    return Line<Fast>{l.a / size, l.b / size, l.c / size};
  }
  // How well two lines tell a point: the sine of their angle, or of parallel ones a little, where they are apart; 0:
  // they tell none.
  static double meeting(const Line<Fast>& one, const Line<Fast>& other) {
    const double turn = std::abs(one.a * other.b - one.b * other.a);
    if (turn > smallest) return turn;
    const bool is_same_way = one.a * other.a + one.b * other.b > 0;
    const double apart = std::abs(one.c - (is_same_way ? other.c : -other.c));
    return apart > smallest ? smallest * (1 + std::min(apart, 1.0)) : 0;
  }

  static constexpr double smallest = 1e-6;
  const Linkage& linkage_;
  const LinkagePosition<Fast>& at_;
  CentrePlan plan_;
  Table known_;
  double reach_ = 1;
};

}  // namespace

const PermanentCentre* CentrePlan::permanent_of(int i, int j) const {
  const auto joint = std::find_if(permanent.begin(), permanent.end(), [&](const PermanentCentre& centre) {
    return (centre.i == i && centre.j == j) || (centre.i == j && centre.j == i);
  });
  return joint == permanent.end() ? nullptr : &*joint;
}

CentrePlan CentrePlan::leading_to(int i, int j) const {
  std::set<std::pair<int, int>> wanted{std::minmax(i, j)};
  const auto is_wanted = [&](const auto& centre) { return wanted.contains(std::minmax(centre.i, centre.j)); };
  CentrePlan plan{.bodies = bodies, .permanent = {}, .found = {}};
  for (auto centre = found.rbegin(); centre != found.rend(); ++centre) {
    if (!is_wanted(*centre)) continue;
    plan.found.push_back(*centre);
    for (const int other : {centre->k, centre->l})
      for (const int of : {centre->i, centre->j}) wanted.insert(std::minmax(of, other));
  }
  std::reverse(plan.found.begin(), plan.found.end());
  std::copy_if(permanent.begin(), permanent.end(), std::back_inserter(plan.permanent), is_wanted);
  return plan;
}

CentrePlan centre_plan(const Linkage& linkage, const LinkagePosition<Fast>& at) {
  CentrePlan plan = Joints(linkage).plan();
  if (linkage.drives.size() != 1 || is_at_rest(linkage.drives.front())) return plan;
  return Search(linkage, at, std::move(plan)).run();
}

}  // namespace epure::geometry
