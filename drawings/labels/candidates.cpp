#include "drawings/labels/candidates.h"

#include <array>

#include "drawings/paths/clip.h"
#include "drawings/paths/vectors.h"

namespace epure::drawings {

namespace {

constexpr std::array near_gaps{1.3, 1.8, 2.4, 3.1, 4.0, 5.0};  // mm from a point to the box
constexpr std::array side_gaps{1.15, 1.6, 2.3, 3.2};           // mm from a segment to the box
constexpr std::array far_gaps{7.0, 9.0, 11.5, 14.5, 18.0, 22.0, 27.0};
constexpr double shortest_with_sides = 6;  // mm
constexpr std::array shares{0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82};
// Upper right is where one looks first when nothing else is asked for.
const Point usual = direction(std::numbers::pi / 4);
// From a point to its labels: all round.
const std::array<Point, 16> directions = [] {
  std::array<Point, 16> all;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = direction(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(all.size()));
  return all;
}();

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

// What a place costs for lines close to it; none when it touches one.
std::optional<double> closeness(Box box, const Obstacles& obstacles) {
  double nearest = label_clearance;
  obstacles.near(box, label_clearance + 0.5, [&](const Obstacle& o) {
    if (!is_beyond(nearest + o.half_width, box, o.from, o.to))
      nearest = std::min(nearest, gap(box, o.from, o.to) - o.half_width);
    return nearest > 0;
  });
  if (nearest <= 0) return std::nullopt;
  const double lack = 1 - nearest / label_clearance;
  return price::crowded * lack * lack;
}

// Of the places those that touch nothing, priced.
std::vector<Candidate> clear_of(std::vector<Candidate> places, const Obstacles& obstacles) {
  std::erase_if(places, [&](Candidate& place) {
    const auto more = closeness(place.box, obstacles);
    place.cost += more.value_or(0);
    return !more;
  });
  return places;
}

double touch(const Obstacle& o) { return o.heavy ? price::touch_heavy : price::touch_thin; }

// Adds what the lines under a place cost, if there are any.
void price_touching(Candidate& place, const Obstacles& obstacles) {
  obstacles.near(place.box, label_clearance + 0.5, [&](const Obstacle& o) {
    if (is_beyond(o.half_width, place.box, o.from, o.to)) return true;
    const double covered = length_inside(place.box, o.from, o.to);
    if (covered == 0 && gap(place.box, o.from, o.to) > o.half_width) return true;
    if (!place.blocked || o.heavy) place.cost = std::max(place.cost, touch(o));
    place.blocked = true;
    place.cost += price::inside * covered;
    return true;
  });
  if (place.blocked) place.cost += price::crowded;
}

int crossings(const Segment& leader, const Obstacles& obstacles) {
  int count = 0;
  const Box box = include(include(nothing(), leader.first), leader.second);
  obstacles.near(box, 0, [&](const Obstacle& o) {
    count += cross(leader, {o.from, o.to}) ? 1 : 0;
    return true;
  });
  return count;
}

// Ends a little short of both, so that neither letter nor point is touched.
Segment leader_between(Box box, Point anchor) {
  const Point start = nearest_in(grown(box, 0.5), anchor);
  return {start, anchor - 0.9 * unit(start, anchor)};
}

// Letters farther off than they are high, and clearly so, are joined to their point. (The number of a step has a
// circle that tells where it ends.)
std::optional<Segment> leader_of_far(const LabelBox& label, double gap, Box box, Point at) {
  constexpr double far = 3.5;  // mm
  const bool is_near = label.number != LabelBox::Number::no || gap < std::max(far, label.height);
  return is_near ? std::nullopt : std::optional(leader_between(box, at));
}

// Places inside `area`, priced by themselves.
std::vector<Candidate> around_point(const LabelBox& label, Point at, Box area) {
  std::vector<Candidate> places;
  for (const double gap : near_gaps)
    for (const Point u : directions) {
      const Box box = box_beside(at, u, gap, label);
      if (contains(area, box))
        places.push_back(
            {box, leader_of_far(label, gap, box, at), (gap - near_gaps.front()) + side_cost(u, label, at)});
    }
  return places;
}

std::vector<Candidate> beside_segment(const LabelBox& label, Point from, Point to, Box area) {
  const Point normal = left_of(unit(from, to));
  // How far the box reaches towards the segment from its centre.
  const double reach = std::abs(normal.x) * label.width / 2 + std::abs(normal.y) * label.height / 2;
  std::vector<Candidate> places;
  for (const double gap : side_gaps)
    for (const double t : shares)
      for (const double sign : {1.0, -1.0}) {
        const Point anchor = between(from, to, t), u = sign * normal;
        const Box box = box_around(anchor + (gap + reach) * u, label);
        if (!contains(area, box)) continue;
        const double aside = 2 * price::off_middle * std::abs(t - 0.5);
        places.push_back({box, {}, (gap - side_gaps.front()) + aside + side_cost(u, label, between(from, to, 0.5))});
      }
  return places;
}

std::vector<Candidate> with_leader(const LabelBox& label, Point anchor, Box area) {
  std::vector<Candidate> places;
  for (const double gap : far_gaps)
    for (const Point u : directions) {
      const Box box = box_beside(anchor, u, gap, label);
      if (contains(area, box))
        places.push_back({box, leader_between(box, anchor),
                          price::leader + gap - near_gaps.front() + side_cost(u, label, anchor)});
    }
  return places;
}

// The part of what a label names that is on the paper.
std::optional<Segment> shown_of(const LabelBox& label, Box area) {
  return clip_segment(label.at, label.to.value_or(label.at), grown(area, 0.5));
}

Point middle(const Segment& segment) { return between(segment.first, segment.second, 0.5); }

std::vector<Candidate> beside(const LabelBox& label, const Segment& shown, Box area) {
  // A short segment has no sides worth the name: its label goes around its middle.
  return distance(shown.first, shown.second) > shortest_with_sides
             ? beside_segment(label, shown.first, shown.second, area)
             : around_point(label, middle(shown), area);
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

std::vector<Candidate> clear_places_around_point(const LabelBox& label, const Obstacles& obstacles, Box area,
                                                 double below) {
  std::vector<Candidate> places = around_point(label, label.at, area);
  const auto is_dear = [=](const Candidate& place) { return place.cost >= below; };
  std::erase_if(places, is_dear);  // before lines close to it cost more, which takes long to find
  places = clear_of(std::move(places), obstacles);
  std::erase_if(places, is_dear);
  return places;
}

std::vector<Candidate> clear_places(const LabelBox& label, const Obstacles& obstacles, Box area) {
  const auto shown = shown_of(label, area);
  if (!shown) return {};
  std::vector<Candidate> places = clear_of(beside(label, *shown, area), obstacles);
  for (Candidate& place : places)
    if (place.leader)
      place.cost += price::short_leader + price::leader_crossing * crossings(*place.leader, obstacles);
  return places;
}

std::vector<Candidate> places_with_leader(const LabelBox& label, const Obstacles& obstacles, Box area) {
  const auto shown = shown_of(label, area);
  if (!shown) return {};
  // Touching something far away is no better than touching something near: such places are left out.
  std::vector<Candidate> places = clear_of(with_leader(label, middle(*shown), area), obstacles);
  for (Candidate& place : places) place.cost += price::leader_crossing * crossings(*place.leader, obstacles);
  return places;
}

std::vector<Candidate> touching_places(const LabelBox& label, const Obstacles& obstacles, Box area) {
  const auto shown = shown_of(label, area);
  if (!shown) return {};
  std::vector<Candidate> places = beside(label, *shown, area);
  for (Candidate& place : places) price_touching(place, obstacles);
  std::erase_if(places, [](const Candidate& place) { return !place.blocked; });
  return places;
}

}  // namespace epure::drawings
