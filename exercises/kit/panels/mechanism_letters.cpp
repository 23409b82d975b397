// A mechanism's angles, letters and numbers.
#include <limits>
#include <utility>

#include "exercises/kit/panels/mechanism_on_paper.h"

namespace epure {
namespace {

using namespace mechanism_on_paper;

// The usual radius of an angle's arc (mm), or one near it, so that the arc falls on none of the circles about its
// vertex.
double clear_of(const std::vector<double>& circles, double usual, const Scale& scale) {
  constexpr double apart = 3, least = 3;  // mm
  for (const double radius : {usual, usual - apart, usual + apart, usual - 2 * apart})
    if (radius >= least && std::none_of(circles.begin(), circles.end(), [&](double circle) {
          return std::abs(scale.mm_per_unit * circle - radius) < apart;
        }))
      return radius;
  return usual;
}

bool is_on_line(const Place& P, const Place& from, const Place& to) {
  const Arrow2 along = to - from, there = P - from;
  return std::abs(cross(along, there)) <= one_direction * magnitude(along) * magnitude(there);
}

// How long a link is that leaves O in this direction; infinite where none does.
double shortest_leg(const std::vector<std::pair<Place, Place>>& links, const Place& O, double side) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : links)
    for (const auto& [here, there] : {std::pair{from, to}, std::pair{to, from}})
      if (distance(O, here) == 0 && has_direction({direction(here, there)}, side))
        shortest = std::min(shortest, distance(here, there));
  return shortest;
}

// The side of an angle that is no line of the mechanism: thin, a little beyond the arc.
void draw_leg(Plot& plot, const Place& vertex, double direction, double radius) {
  constexpr double beyond_arc = 3;  // mm
  const double length = (radius + beyond_arc) / plot.scale().mm_per_unit;
  plot.segment(vertex, vertex + length * Arrow2{std::cos(direction), std::sin(direction)}, Meaning::construction);
}

// Where links of one body cross those of others between their ends: a number there could be either's.
std::vector<Place> crossings(const std::vector<std::pair<Place, Place>>& own,
                             const std::vector<std::pair<Place, Place>>& others) {
  std::vector<Place> all;
  for (const auto& [A, B] : own)
    for (const auto& [C, D] : others) {
      const double turn = cross(B - A, D - C);
      if (turn == 0) continue;
      const double on_own = cross(C - A, D - C) / turn, on_other = cross(C - A, B - A) / turn;
      if (on_own > 0 && on_own < 1 && on_other > 0 && on_other < 1) all.push_back(A + on_own * (B - A));
    }
  return all;
}

// In the middle of a body, or a little off it where another point is near: halfway from there to a corner.
Place place_of_number(const std::vector<Place>& corners, const std::vector<Place>& points) {
  Place middle{0, 0};
  double size = 0;
  for (const Place& P : corners) {
    const double share = 1 / static_cast<double>(corners.size());
    middle = middle + share * (P - Place{0, 0});
    size = std::max(size, distance(P, corners.front()));
  }
  const auto room = [&](const Place& X) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Place& P : points) nearest = std::min(nearest, distance(X, P));
    return nearest;
  };
  constexpr double enough = 0.15;  // of the size
  Place best = middle;
  if (room(middle) >= enough * size) return best;
  for (const Place& P : corners)
    if (const Place X = middle + 0.5 * (P - middle); room(X) > room(best)) best = X;
  return best;
}

}  // namespace

// No arc where there is none to see, nor where it would be longer than the links.
void Mechanism::draw_angle(Plot& plot, const Angle& angle) const {
  constexpr double shortest_arc = 2.5;  // mm
  const double opening = angle.to - angle.from;
  if (std::abs(opening) * angle_radius < shortest_arc || plot.scale().mm_per_unit * reach() < angle_radius) return;
  const Place& O = at(angle.at);
  std::vector<std::pair<Place, Place>> legs = edges(bodies_);
  for (const auto& leg : edges(other_positions_)) legs.push_back(leg);
  for (const Axis& axis : axes_) legs.emplace_back(axis.from, axis.to);
  const auto usual = [&](const Angle& each) {
    constexpr double share = 0.6, least = 5, short_leg = 8, joint = 6;  // of the leg, mm
    const double leg =
        plot.scale().mm_per_unit * std::min(shortest_leg(legs, O, each.from), shortest_leg(legs, O, each.to));
    // The joint at the end of a short leg would hide a short arc: that stands beyond it.
    const bool is_hidden = leg < short_leg && std::abs(each.to - each.from) * least < joint;
    return std::min(radius_of(each), is_hidden ? leg + joint : std::max(share * leg, least));
  };
  std::vector<double> circles;
  for (const Path& path : paths_)
    if (path.about == angle.at) circles.push_back(distance(O, at(path.of)));
  for (const Swing& swing : swings_)
    if (swing.about == angle.at) circles.push_back(distance(O, at(swing.of)));
  for (const Disc& disc : discs_)
    if (disc.centre == angle.at) circles.push_back(this->radius(disc));
  for (const Angle& each : angles_) {  // of two angles at a point each has an arc of its own
    if (&each == &angle) break;
    if (each.at != angle.at) continue;
    circles.push_back(clear_of(circles, usual(each), plot.scale()) / plot.scale().mm_per_unit);
  }
  const double radius = clear_of(circles, usual(angle), plot.scale());

  std::vector<double> lines = directions_at(angle.at);
  for (const Axis& axis : axes_)
    for (const Place& end : {axis.from, axis.to})
      if (is_on_line(O, axis.from, axis.to) && distance(O, end) > 0) lines.push_back(direction(O, end));
  for (const auto& [from, to] : edges(other_positions_))  // dashed
    for (const auto& [here, there] : {std::pair{from, to}, std::pair{to, from}})
      if (distance(O, here) == 0) lines.push_back(direction(here, there));
  for (const double side : {angle.from, angle.to})
    if (!has_direction(lines, side) || shortest_leg(legs, O, side) * plot.scale().mm_per_unit < radius)
      draw_leg(plot, O, side, radius);
  if (angle.is_directed)
    plot.mark(drawings::Rotation{plot.at(O), radius, angle.from, angle.to, Meaning::dimension});
  else
    plot.mark(drawings::AngleMark{plot.at(O), radius, std::min(angle.from, angle.to), std::max(angle.from, angle.to),
                                  Meaning::dimension});
  const double out = radius / plot.scale().mm_per_unit, middle = (angle.from + angle.to) / 2;
  plot.label(angle.symbol, {O.x + out * std::cos(middle), O.y + out * std::sin(middle)}, O);
}

// A block's letters at its corner, on the side that the link leaves free: inside the block they would be lost. A
// corner in its pin bears its number, which stands at the other corner.
void Mechanism::draw_letters(Plot& plot, const Point& P) const {
  if (P.letters.empty()) return;
  const auto guide = std::find_if(guides_.begin(), guides_.end(), [&](const Guide& each) {
    return P.joint == Joint::block ? each.block == P.name
                                   : P.joint == Joint::corner && distance(at(each.block), P.at) == 0;
  });
  if (guide == guides_.end()) return plot.label(P.letters, P.at, neighbour(P));
  const Place Q = neighbour(find(guide->block));
  const double c = std::cos(guide->direction), s = std::sin(guide->direction);
  const double ahead = (Q.x - P.at.x) * c + (Q.y - P.at.y) * s;
  const bool is_number = guide->block != P.name;
  const drawings::Point corner =
      beside(plot.at(P.at), guide->direction, (ahead > 0) != is_number ? -half_block : half_block, block_top);
  plot.label(P.letters, plot.from_paper(corner), P.at);
}

void Mechanism::draw_numbers(Plot& plot) const {
  constexpr double below_support = 8, middle_of_number = 2.5, beside_number = 4;  // mm
  bool is_numbered = false;
  const auto fixed =
      std::find_if(points_.begin(), points_.end(), [](const Point& point) { return point.joint == Joint::fixed; });
  for (const Body& body : bodies_) {
    if (!body.letter.empty()) {
      const auto [begins, ends] = slot(body, plot.scale());
      plot.small_label(body.letter, ends, begins);
    }
    if (body.number == 0) continue;
    is_numbered = true;
    if (body.is_slotted) {
      const Place &P = at(body.points[0]), &Q = at(body.points[1]);
      plot.label(std::to_string(body.number), P + 0.5 * (Q - P));
      continue;
    }
    std::vector<Place> corners, all;
    for (const std::string& name : body.points) corners.push_back(at(name));
    for (const Point& P : points_) {
      all.push_back(P.at);
      if (P.joint != Joint::fixed) continue;
      const Arrow2 down = 1 / plot.scale().mm_per_unit * unit_at(direction_of_support(P, plot.scale()));
      all.push_back(P.at + support_height * down);
      if (&P != &*fixed) continue;
      for (const double side : {-beside_number, 0.0, beside_number})  // and the number of the frame
        all.push_back(P.at + (below_support + middle_of_number) * down + side * geometry::quarter_turn(down));
    }
    if (corners.size() == 2) {  // of a bar; a plate is seen beneath what crosses it
      const std::vector<Place> met = crossings(edges({body}), edges(bodies_));
      all.insert(all.end(), met.begin(), met.end());
    }
    begin_step_of(plot, body.points);
    plot.label(std::to_string(body.number), place_of_number(corners, all), middle());
  }
  begin_step_of(plot, {});
  for (const Disc& disc : discs_) {
    const Place &O = at(disc.centre), &D = at(disc.rim);
    if (disc.number != 0) plot.label(std::to_string(disc.number), O + 0.5 * (D - O), D);
  }
  if (!is_numbered) return;
  if (fixed == points_.end()) {  // of a frame without hinges: at the first wall of its guides
    if (guides_.empty()) return;
    const Place& P = at(guides_.front().block);
    const drawings::Point wall = beside(plot.at(P), guides_.front().direction, -guide_behind, -below_support);
    return plot.label("1", plot.from_paper(wall), P);
  }
  const drawings::Point below =
      beside(plot.at(fixed->at), direction_of_support(*fixed, plot.scale()), below_support, 0);
  plot.label("1", plot.from_paper(below), fixed->at);
}

}  // namespace epure
