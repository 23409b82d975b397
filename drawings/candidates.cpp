#include "drawings/candidates.h"

#include <array>

#include "drawings/clip.h"
#include "drawings/vectors.h"

namespace epure::drawings {

namespace {

constexpr int directions = 16;
constexpr std::array near_gaps{1.3, 1.8, 2.4, 3.1, 4.0, 5.0};  // mm from a point to the box
constexpr std::array side_gaps{1.15, 1.6, 2.3, 3.2};           // mm from a segment to the box
constexpr std::array far_gaps{7.0, 9.0, 11.5, 14.5, 18.0, 22.0, 27.0};
constexpr double shortest_with_sides = 6;  // mm
constexpr std::array along{0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82};
// Upper right is where one looks first when nothing else is asked for.
const Point usual = direction(std::numbers::pi / 4);

Box box_around(Point centre, const LabelBox& label) {
  const Point half{label.width / 2, label.height / 2};
  return {centre - half, centre + half};
}

// The box seen from `at` in direction u, `gap` mm away: at 45° its corner points at `at`, upright its side.
Box box_beside(Point at, Point u, double gap, const LabelBox& label) {
  const auto lean = [](double c) { return std::clamp(c * std::numbers::sqrt2, -1.0, 1.0); };
  return box_around(at + gap * u + Point{lean(u.x) * label.width / 2, lean(u.y) * label.height / 2}, label);
}

double side_cost(Point from_anchor, const LabelBox& label, Point anchor) {
  const bool asked = label.away_from && distance(*label.away_from, anchor) > 1e-6;
  const Point wish = asked ? unit(*label.away_from, anchor) : usual;
  return (asked ? price::wrong_side : price::usual_side) * (1 - dot(unit({}, from_anchor), wish)) / 2;
}

class Judge {
 public:
  Judge(const Obstacles& obstacles, Box area) : obstacles_(obstacles), area_(area) {}

  bool allows(Box box) const { return contains(area_, box); }

  // Adds what the drawing under and around the box costs.
  void judge(Candidate& candidate) const {
    double nearest = label_clearance;
    obstacles_.near(candidate.box, label_clearance + 0.5, [&](const Obstacle& o) {
      const double d = gap(candidate.box, o.from, o.to) - o.half_width;
      nearest = std::min(nearest, d);
      if (d > 0) return true;
      if (!candidate.blocked || o.heavy) candidate.cost = std::max(candidate.cost, touch(o));
      candidate.blocked = true;
      candidate.cost += price::inside * length_inside(candidate.box, o.from, o.to);
      return !candidate.leader;
    });
    // Touching something far away is no better than touching something near: such places are not kept.
    if (candidate.leader && candidate.blocked) return;
    const double lack = 1 - std::max(nearest, 0.0) / label_clearance;
    candidate.cost += price::crowded * lack * lack;
    if (candidate.leader) candidate.cost += price::leader_crossing * crossings(*candidate.leader);
  }

 private:
  static double touch(const Obstacle& o) { return o.heavy ? price::touch_heavy : price::touch_thin; }

  int crossings(const Segment& leader) const {
    int count = 0;
    const Box box = include(include(nothing(), leader.first), leader.second);
    obstacles_.near(box, 0, [&](const Obstacle& o) {
      count += cross(leader, {o.from, o.to}) ? 1 : 0;
      return true;
    });
    return count;
  }

  const Obstacles& obstacles_;
  Box area_;
};

// Ends a little short of both, so that neither letter nor point is touched.
Segment leader_between(Box box, Point anchor) {
  const Point start = nearest_in(grown(box, 0.5), anchor);
  return {start, anchor - 0.9 * unit(start, anchor)};
}

void around_point(const LabelBox& label, Point at, const Judge& judge, std::vector<Candidate>& found) {
  for (const double gap : near_gaps)
    for (int i = 0; i < directions; ++i) {
      const Point u = direction(2 * std::numbers::pi * i / directions);
      Candidate candidate{box_beside(at, u, gap, label)};
      if (!judge.allows(candidate.box)) continue;
      candidate.cost = (gap - near_gaps.front()) + side_cost(u, label, at);
      judge.judge(candidate);
      found.push_back(candidate);
    }
}

void beside_segment(const LabelBox& label, Point from, Point to, const Judge& judge, std::vector<Candidate>& found) {
  const Point normal = left_of(unit(from, to));
  // How far the box reaches towards the segment from its centre.
  const double reach = std::abs(normal.x) * label.width / 2 + std::abs(normal.y) * label.height / 2;
  for (const double gap : side_gaps)
    for (const double t : along)
      for (const double sign : {1.0, -1.0}) {
        const Point anchor = between(from, to, t), u = sign * normal;
        Candidate candidate{box_around(anchor + (gap + reach) * u, label)};
        if (!judge.allows(candidate.box)) continue;
        candidate.cost = (gap - side_gaps.front()) + 2 * price::off_middle * std::abs(t - 0.5) +
                         side_cost(u, label, between(from, to, 0.5));
        judge.judge(candidate);
        found.push_back(candidate);
      }
}

void with_leader(const LabelBox& label, Point anchor, const Judge& judge, std::vector<Candidate>& found) {
  for (const double gap : far_gaps)
    for (int i = 0; i < directions; ++i) {
      const Point u = direction(2 * std::numbers::pi * i / directions);
      Candidate candidate{box_beside(anchor, u, gap, label)};
      if (!judge.allows(candidate.box)) continue;
      candidate.leader = leader_between(candidate.box, anchor);
      candidate.cost = price::leader + gap - near_gaps.front() + side_cost(u, label, anchor);
      judge.judge(candidate);
      if (!candidate.blocked) found.push_back(candidate);
    }
}

}  // namespace

bool cross(const Segment& first, const Segment& second) {
  // Each has its ends on different sides of the other.
  const auto parted = [](const Segment& line, const Segment& ends) {
    const Point normal = left_of(line.second - line.first);
    return (dot(normal, ends.first - line.first) > 0) != (dot(normal, ends.second - line.first) > 0);
  };
  return parted(first, second) && parted(second, first);
}

std::vector<Candidate> candidates(const LabelBox& label, const Obstacles& obstacles, Box area) {
  const Judge judge(obstacles, area);
  std::vector<Candidate> found;
  const auto shown = clip_segment(label.at, label.to.value_or(label.at), grown(area, 0.5));
  if (!shown) return found;
  const Point anchor = between(shown->first, shown->second, 0.5);
  // A short segment has no sides worth the name: its label goes around its middle.
  if (distance(shown->first, shown->second) > shortest_with_sides)
    beside_segment(label, shown->first, shown->second, judge, found);
  else
    around_point(label, anchor, judge, found);
  with_leader(label, anchor, judge, found);
  return found;
}

}  // namespace epure::drawings
