// Arc arrows at a mechanism's links, clear of what else is drawn there.
#include <limits>
#include <utility>

#include "exercises/kit/panels/mechanism_on_paper.h"
#include "exercises/kit/panels/senses.h"

namespace epure {
namespace {

using namespace mechanism_on_paper;

// What an arrow must keep clear of: a line, with as many mm to either side.
struct Obstacle {
  Place from, to;
  double half_width;
};

void add_arc(std::vector<Obstacle>& all, const Place& O, double radius, double from, double to, double half_width) {
  constexpr int pieces = 32;
  const auto on_it = [&](int i) { return O + radius * unit_at(from + (to - from) * i / pieces); };
  for (int i = 0; i < pieces; ++i) all.push_back({on_it(i), on_it(i + 1), half_width});
}

// How far an arrow about O is from the nearest of them (mm).
double room_of(const ArcArrow& arrow, const Place& O, const std::vector<Obstacle>& others, const Scale& scale) {
  constexpr int pieces = 12;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= pieces; ++i) {
    const double direction = arrow.middle + sweep_of_arrow * (static_cast<double>(i) / pieces - 0.5);
    const Place X = O + arrow.radius / scale.mm_per_unit * unit_at(direction);
    for (const Obstacle& other : others)
      least = std::min(least, distance_to_segment(X, other.from, other.to) * scale.mm_per_unit - other.half_width);
  }
  return least;
}

// The arrow where it is if that is clear; else the nearest about the same point that is, and keeps clear of its own
// link too. Where none is: about a support, which its usual place keeps clear of, there; else where it has most room.
ArcArrow in_the_clear(const ArcArrow& usual, const Place& O, std::vector<Obstacle> others, const Obstacle& own_link,
                      bool is_at_support, const Scale& scale) {
  constexpr double enough = 0.7;  // mm
  constexpr int directions = 24;
  if (room_of(usual, O, others, scale) >= enough) return usual;
  others.push_back(own_link);
  ArcArrow best = usual;
  double most = room_of(usual, O, others, scale);
  for (int i = 0; i < directions; ++i)
    for (const double further : {0.0, -2.0, 2.0}) {  // mm
      if (most >= enough) return best;
      ArcArrow other = usual;
      other.middle += (i + 1) / 2 * (i % 2 == 0 ? 1 : -1) * 2 * std::numbers::pi / directions;
      other.radius += further;
      const double found = room_of(other, O, others, scale);
      if (found <= most) continue;
      best = other;
      most = found;
    }
  return most >= enough || !is_at_support ? best : usual;
}

}  // namespace

// Where the arrow usually stands; where it would be drawn across links, slots, guides, discs or supports there,
// elsewhere about the same point.
void Mechanism::draw_turning(Plot& plot, const Turning& each) const {
  if (each.sense == 0) return;
  const Point& about = find(each.about);
  const auto disc =
      std::find_if(discs_.begin(), discs_.end(), [&](const Disc& one) { return one.centre == each.about; });
  const auto usual = [&] {
    std::vector<double> links = directions_at(each.about);
    if (disc != discs_.end() || links.size() > 1) {  // not ahead of one link, but where there is room between them
      if (about.joint == Joint::fixed) links.push_back(direction_of_support(about, plot.scale()));
      ArcArrow arrow{clearest_direction(links), each.sense, each.symbol};
      if (disc != discs_.end()) arrow.radius = std::max(arrow.radius, 0.6 * radius(*disc) * plot.scale().mm_per_unit);
      return arrow;
    }
    if (about.joint == Joint::fixed)
      return sense_of_crank(about.at, at(each.of), each.sense, each.symbol,
                            direction_of_support(about, plot.scale()));
    return sense_of_turning(about.at, at(each.of), each.sense, each.symbol);
  };

  constexpr double line = 0.5, slot_wide = 2.3, hinge = 1.7;                 // mm to either side
  constexpr double support_from = 5.4, support_to = 14, support_wide = 5.5;  // mm
  constexpr double support_seen = 0.75, may_touch = -0.65;                   // radians; mm
  constexpr double beside_crank = 2.4, wall = 4.5, wall_wide = 2;            // mm
  const double mm = 1 / plot.scale().mm_per_unit;
  std::vector<Obstacle> others;
  for (const auto& [from, to] : edges(bodies_)) others.push_back({from, to, line});
  for (const Body& body : bodies_)
    if (body.is_slotted) {
      const auto [from, to] = slot(body, plot.scale());
      others.push_back({from, to, slot_wide});
    }
  for (const Disc& each_disc : discs_)
    add_arc(others, at(each_disc.centre), radius(each_disc), 0, 2 * std::numbers::pi, line);
  for (const Profile& profile : profiles_)
    add_arc(others, profile.centre, profile.radius, profile.from, profile.to, line);
  for (const Guide& guide : guides_) {
    const Arrow2 along = mm * unit_at(guide.direction), across = mm * unit_at(guide.direction + std::numbers::pi / 2);
    const Place &P = at(guide.block), on_wall = P + -wall * across;
    others.push_back({on_wall + -guide_behind * along, on_wall + guide_ahead * along, wall_wide});
    others.push_back({P + -half_block * along, P + half_block * along, block_top + line});
  }
  for (const Point& P : points_) {
    if (P.joint != Joint::corner) others.push_back({P.at, P.at, hinge});
    if (P.joint != Joint::fixed) continue;
    // Not under it either, where the frame's number stands, nor over the edges of that, seen from the hinge.
    const double below = direction_of_support(P, plot.scale());
    const Arrow2 down = mm * unit_at(below);
    others.push_back({P.at + support_from * down, P.at + support_to * down, support_wide});
    for (const double side : {-support_seen, support_seen})
      others.push_back({P.at, P.at + support_to * mm * unit_at(below + side), may_touch});
  }
  const Obstacle own_link{about.at, at(each.of), about.joint == Joint::fixed ? beside_crank : line};
  draw_arc_arrow(plot, about.at,
                 in_the_clear(usual(), about.at, others, own_link, about.joint == Joint::fixed, plot.scale()));
}

}  // namespace epure
