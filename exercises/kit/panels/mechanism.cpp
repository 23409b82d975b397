#include "exercises/kit/panels/mechanism.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "exercises/kit/panels/senses.h"

namespace epure {
namespace {

constexpr double guide_behind = 14, guide_ahead = 10, guide_ahead_of_axis = 26;  // mm of it beside the block
constexpr double axis_ahead = 28;                        // mm of the guide's axis, with its name
constexpr double half_block = 5, block_top = 3;          // mm from the hinge
constexpr double angle_radius = 19, from_x_radius = 13;  // mm
constexpr double surface_beyond = 9;                     // mm of the frame on either side of a disc
constexpr double axis_beyond = 8;                        // mm
constexpr double support_height = 7;                     // mm

// From p, `along` mm in a direction and `across` mm to its left.
drawings::Point beside(drawings::Point p, double direction, double along, double across) {
  const double c = std::cos(direction), s = std::sin(direction);
  return {p.x + along * c - across * s, p.y + along * s + across * c};
}

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

constexpr double one_direction = 0.02;  // radians

bool has_direction(const std::vector<double>& lines, double direction) {
  return std::any_of(lines.begin(), lines.end(), [&](double line) {
    return std::abs(std::remainder(line - direction, 2 * std::numbers::pi)) < one_direction;
  });
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
  constexpr double past_arc = 3;  // mm
  const double length = (radius + past_arc) / plot.scale().mm_per_unit;
  plot.segment(vertex, vertex + length * Arrow2{std::cos(direction), std::sin(direction)}, Meaning::construction);
}

// Of a polygon: a ray from X to the right crosses its outline an odd number of times.
bool is_inside(const Place& X, const std::vector<Place>& corners) {
  bool inside = false;
  for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
    const Place &P = corners[i], &Q = corners[before];
    if ((P.y > X.y) != (Q.y > X.y) && X.x < P.x + (X.y - P.y) / (Q.y - P.y) * (Q.x - P.x)) inside = !inside;
  }
  return inside;
}

double distance_to_segment(const Place& X, const Place& P, const Place& Q) {
  const Arrow2 along = Q - P;
  const double length_squared = dot(along, along);
  const double t = length_squared > 0 ? std::clamp(dot(X - P, along) / length_squared, 0.0, 1.0) : 0;
  return distance(X, P + t * along);
}

Arrow2 unit_at(double direction) { return {std::cos(direction), std::sin(direction)}; }

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

Mechanism& Mechanism::point(const std::string& name, const Place& at, Joint joint, const std::string& letters) {
  points_.push_back({name, at, joint, letters});
  return *this;
}
Mechanism& Mechanism::body(const std::vector<std::string>& points, int number) {
  bodies_.push_back({points, number, false});
  return *this;
}
Mechanism& Mechanism::slotted(const std::vector<std::string>& points, int number, bool takes_block,
                              const std::string& letter) {
  bodies_.push_back({points, number, true, false, takes_block, letter});
  return *this;
}
Mechanism& Mechanism::cylinder(const std::string& from, const std::string& to) {
  bodies_.push_back({{from, to}, 0, false, true});
  return *this;
}
Mechanism& Mechanism::disc(const std::string& centre, const std::string& rim, bool rolls, int number) {
  discs_.push_back({centre, rim, rolls, number});
  return *this;
}
Mechanism& Mechanism::surface(const Place& from, const Place& to) {
  surfaces_.push_back({from, to});
  return *this;
}
Mechanism& Mechanism::profile(const Place& centre, double radius, double from, double to) {
  profiles_.push_back({centre, radius, from, to});
  return *this;
}
Mechanism& Mechanism::other_position(const std::vector<std::string>& points) {
  other_positions_.push_back({points, 0, false});
  return *this;
}
Mechanism& Mechanism::found_in(int step, const std::vector<std::string>& points) {
  for (const std::string& name : points) steps_[name] = step;
  return *this;
}
Mechanism& Mechanism::guide(const std::string& block, double direction, const std::string& axis,
                            const std::string& letter) {
  guides_.push_back({block, direction, axis, letter});
  return *this;
}
Mechanism& Mechanism::with_open_blocks() {
  has_open_blocks_ = true;
  return *this;
}
Mechanism& Mechanism::path(const std::string& about, const std::string& of) {
  paths_.push_back({about, of});
  return *this;
}
Mechanism& Mechanism::swing(const std::string& about, const std::string& of, double from, double to) {
  const auto known = std::find_if(swings_.begin(), swings_.end(), [&](const Swing& each) { return each.of == of; });
  if (known == swings_.end()) {
    swings_.push_back({about, of, from, to});
  } else {
    known->from = std::min(known->from, from);
    known->to = std::max(known->to, to);
  }
  return *this;
}
Mechanism& Mechanism::without_ways() {
  paths_.clear();
  swings_.clear();
  return *this;
}
Mechanism& Mechanism::unnumbered() {
  for (Body& body : bodies_) body.number = 0;
  return *this;
}
Mechanism& Mechanism::turning(const std::string& about, const std::string& of, double sense,
                              const std::string& symbol) {
  turnings_.push_back({about, of, sense, symbol});
  return *this;
}
Mechanism& Mechanism::turning_found(const std::string& about, const std::string& of, double sense,
                                    const std::string& symbol) {
  turnings_.push_back({about, of, sense, symbol, false});
  return *this;
}
Mechanism& Mechanism::axis(const Place& from, const Place& to, const std::string& name) {
  axes_.push_back({from, to, name});
  return *this;
}
Mechanism& Mechanism::offset(const std::string& point, const Place& foot, double direction, double clear,
                             const std::string& symbol) {
  offsets_.push_back({point, foot, direction, clear, symbol});
  return *this;
}
Mechanism& Mechanism::angle(const std::string& at, double from, double to, const std::string& symbol) {
  angles_.push_back({at, from, to, symbol});
  return *this;
}

// About a hinge of the frame within a turn, as such an angle is given.
Mechanism& Mechanism::angle_from_x(const std::string& at, const std::string& of, const std::string& symbol) {
  double to = direction(find(at).at, find(of).at);
  if (find(at).joint == Joint::fixed && to < 0) to += 2 * std::numbers::pi;
  angles_.push_back({at, 0, to, symbol, true});
  return *this;
}

Mechanism& Mechanism::right_angle(const std::string& at, const std::string& one, const std::string& other) {
  right_angles_.push_back({at, one, other});
  return *this;
}

const Mechanism::Point& Mechanism::find(const std::string& name) const {
  const auto found =
      std::find_if(points_.begin(), points_.end(), [&](const Point& point) { return point.name == name; });
  assert(found != points_.end() && "a point of the mechanism");
  return *found;
}

void Mechanism::begin_step_of(Plot& plot, const std::vector<std::string>& points) const {
  if (steps_.empty()) return;
  std::optional<int> last;
  for (const std::string& name : points)
    if (const auto known = steps_.find(name); known != steps_.end()) last = std::max(last.value_or(0), known->second);
  plot.in_step(last);
}

Place Mechanism::middle() const {
  Place sum{0, 0};
  for (const Point& P : points_) sum = {sum.x + P.at.x, sum.y + P.at.y};
  const auto count = static_cast<double>(points_.size());
  return {sum.x / count, sum.y / count};
}

Place Mechanism::neighbour(const Point& P) const {
  for (const Body& body : bodies_) {
    const auto found = std::find(body.points.begin(), body.points.end(), P.name);
    if (found == body.points.end()) continue;
    return at(found == body.points.begin() ? body.points[1] : *(found - 1));
  }
  for (const Disc& disc : discs_)
    if (disc.rim == P.name) return at(disc.centre);
  return middle();
}

// A slot goes on beyond its pin.
std::vector<double> Mechanism::directions_at(const std::string& point) const {
  std::vector<double> all;
  for (const Body& body : bodies_) {
    const auto& points = body.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i] != point) continue;
      if (i > 0) all.push_back(direction(at(point), at(points[i - 1])));
      if (i + 1 < points.size())
        all.push_back(direction(at(point), at(points[i + 1])));
      else if (body.is_slotted)
        all.push_back(direction(at(points[i - 1]), at(point)));
    }
  }
  return all;
}

// Longer than it must be for this one position, but clear of the points before and beyond.
std::pair<Place, Place> Mechanism::slot(const Body& body, const Scale& scale) const {
  constexpr double shortest = 9;  // mm to either side
  const Place &before = at(*(body.points.end() - 2)), &pin = at(body.points.back());
  const double length = distance(before, pin), half = std::max(0.3 * length, shortest / scale.mm_per_unit);
  const Arrow2 along = (1 / length) * (pin - before);
  constexpr double of_the_way = 0.6;  // to the next point
  double ahead = half;
  for (auto name = body.points.begin(); name != body.points.end() - 1; ++name)
    if (const double way = dot(at(*name) - pin, along); way > 0) ahead = std::min(ahead, of_the_way * way);
  return {pin + -std::min(half, of_the_way * length) * along, pin + ahead * along};
}

std::vector<std::pair<Place, Place>> Mechanism::edges(const std::vector<Body>& bodies) const {
  std::vector<std::pair<Place, Place>> all;
  for (const Body& body : bodies) {
    const std::vector<std::string>& corners = body.points;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) all.emplace_back(at(corners[i]), at(corners[i + 1]));
    if (corners.size() > 2 && !body.is_slotted) all.emplace_back(at(corners.back()), at(corners.front()));
  }
  return all;
}

double Mechanism::direction_of_support(const Point& P, const Scale& scale) const {
  constexpr double half_wide = 5.4;  // mm of the support
  constexpr double right_angle = std::numbers::pi / 2;
  std::vector<std::vector<Place>> plates;
  for (const Body& body : bodies_) {
    if (body.points.size() <= 2 || body.is_slotted) continue;
    plates.emplace_back();
    for (const std::string& name : body.points) plates.back().push_back(at(name));
  }
  const auto is_on_plate = [&](const Place& X) {
    return std::any_of(plates.begin(), plates.end(), [&](const auto& corners) { return is_inside(X, corners); });
  };
  std::vector<std::pair<Place, Place>> lines = edges(bodies_);
  const auto others = edges(other_positions_);
  lines.insert(lines.end(), others.begin(), others.end());
  const auto room = [&](double direction) {
    const Place foot = P.at + support_height / scale.mm_per_unit * unit_at(direction);
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : lines) nearest = std::min(nearest, distance_to_segment(foot, from, to));
    constexpr double worse_on_plate = 1000;  // mm: more than all room beside one
    return nearest * scale.mm_per_unit - (is_on_plate(foot) ? worse_on_plate : 0);
  };
  // Upside down only where there is clearly no room beside it either.
  constexpr double upside_down = 3;  // mm of room that it must gain
  const double down = -right_angle, beside = room(0) >= room(std::numbers::pi) ? 0 : std::numbers::pi;
  double best = down;
  for (const double direction : {down, beside, right_angle}) {
    if (room(direction) >= half_wide) return direction;
    if (room(direction) > room(best) + (direction == right_angle ? upside_down : 0)) best = direction;
  }
  return best;
}

void Mechanism::draw_guide(Plot& plot, const Guide& guide) const {
  const drawings::Point p = plot.at(at(guide.block));
  const auto on_it = [&](double along) { return beside(p, guide.direction, along, 0); };
  if (!guide.axis.empty())
    plot.mark(drawings::Line{drawings::segment(on_it(-guide_behind), on_it(axis_ahead)), Meaning::axis, {}});
  plot.mark(drawings::Guide{on_it(-guide_behind), on_it(guide.axis.empty() ? guide_ahead : guide_ahead_of_axis)});
  plot.mark(drawings::Slider{p, guide.direction, has_open_blocks_});
  if (!guide.axis.empty()) plot.label(guide.axis, plot.from_paper(on_it(axis_ahead)), at(guide.block));
  if (!guide.letter.empty()) plot.small_label(guide.letter, plot.from_paper(on_it(guide_ahead)), at(guide.block));
}

// Too short a distance has no room for its letter; nor has one beyond the border of a close-up.
void Mechanism::draw_offset(Plot& plot, const Offset& offset) const {
  constexpr double shortest = 3, air = 6, beyond = 2;  // mm
  const Place& P = at(offset.point);
  if (distance(P, offset.foot) * plot.scale().mm_per_unit < shortest) return;
  const double out = offset.clear * plot.scale().mm_per_unit + air;
  const drawings::Point at_point = beside(plot.at(P), offset.direction, out, 0),
                        at_foot = beside(plot.at(offset.foot), offset.direction, out, 0);
  if (!plot.shows(plot.from_paper(at_point)) || !plot.shows(plot.from_paper(at_foot))) return;
  plot.long_segment(plot.from_paper(at_point), P, beyond, Meaning::axis);
  plot.long_segment(plot.from_paper(at_foot), offset.foot, beyond, Meaning::axis);
  plot.mark(drawings::Dimension{at_point, at_foot, 0, offset.symbol});
}

void Mechanism::draw_discs(Plot& plot) const {
  for (const Disc& disc : discs_) {
    const Place& O = at(disc.centre);
    plot.mark(
        drawings::Area{drawings::circle(plot.at(O), radius(disc) * plot.scale().mm_per_unit), Meaning::plate, {}});
    plot.circle(O, radius(disc), Meaning::link);
    if (disc.rolls) draw_surface(plot, disc);
  }
}

// Left out where the support of a fixed hinge stands on it.
void Mechanism::draw_surface(Plot& plot, const Disc& disc) const {
  constexpr double clear = 5, shortest = 4;  // mm
  const drawings::Point rim = plot.at(at(disc.rim));
  const double along = direction(at(disc.rim), at(disc.centre)) - std::numbers::pi / 2;
  const double c = std::cos(along), s = std::sin(along);
  const double half = radius(disc) * plot.scale().mm_per_unit + surface_beyond;
  std::vector<std::pair<double, double>> pieces{{-half, half}};
  for (const Point& P : points_) {
    if (P.joint != Joint::fixed) continue;
    const double dx = plot.at(P.at).x - rim.x, dy = plot.at(P.at).y - rim.y, x = dx * c + dy * s;
    if (std::abs(dy * c - dx * s) > clear) continue;
    for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
      pieces.emplace_back(std::max(pieces[i].first, x + clear), pieces[i].second);
      pieces[i].second = std::min(pieces[i].second, x - clear);
    }
  }
  for (const auto& [from, to] : pieces)
    if (to - from > shortest) plot.mark(drawings::Ground{beside(rim, along, from, 0), beside(rim, along, to, 0)});
}

void Mechanism::draw_axes(Plot& plot) const {
  for (const Axis& axis : axes_) {
    plot.long_segment(axis.from, axis.to, axis_beyond, Meaning::axis);
    if (axis.name.empty()) continue;
    const drawings::Point end = beside(plot.at(axis.to), direction(axis.from, axis.to), axis_beyond, 0);
    plot.small_label(axis.name, plot.from_paper(end), axis.to);
  }
}

void Mechanism::draw_bodies(Plot& plot) const {
  for (const Body& body : bodies_) {
    std::vector<Place> corners;
    for (const std::string& name : body.points) corners.push_back(at(name));
    begin_step_of(plot, body.points);
    if (corners.size() > 2 && !body.is_slotted) plot.area(corners, Meaning::plate);
  }
  for (const Body& body : other_positions_) {
    begin_step_of(plot, body.points);
    for (const auto& [from, to] : edges({body})) plot.segment(from, to, Meaning::alternative);
  }
  for (const Body& body : bodies_) {
    begin_step_of(plot, body.points);
    if (body.is_cylinder)
      draw_cylinder(plot, body);
    else
      for (const auto& [from, to] : edges({body})) plot.segment(from, to, Meaning::link);
  }
  begin_step_of(plot, {});
  for (const auto& [from, to] : surfaces_) plot.mark(drawings::Ground{plot.at(from), plot.at(to)});
  for (const auto& [centre, radius, from, to] : profiles_)
    plot.mark(drawings::Line{
        drawings::arc(plot.at(centre), radius * plot.scale().mm_per_unit, from, to), Meaning::link, {}});
  for (const Body& body : bodies_) {
    if (!body.is_slotted) continue;
    constexpr double width = 3.5, width_for_block = 6;  // mm: takes the hinge that is its pin
    const auto [near, far] = slot(body, plot.scale());
    plot.mark(drawings::Slot{plot.at(near), plot.at(far), body.takes_block ? width_for_block : width});
    if (body.takes_block) plot.mark(drawings::Slider{plot.at(at(body.points.back())), direction(near, far)});
  }
  for (const auto& [P, one, other] : right_angles_) plot.right_angle(at(P), at(one), at(other));
}

// Its barrel over the first part of the way, the piston in it, the rod from there on.
void Mechanism::draw_cylinder(Plot& plot, const Body& body) const {
  constexpr double widest = 2.2, clear_of_hinge = 3.5, shortest = 12;       // mm
  constexpr double end_of_barrel = 0.62, piston = 0.48, half_width = 0.08;  // of the way
  const Place &from = at(body.points[0]), &to = at(body.points[1]);
  const drawings::Point p = plot.at(from), q = plot.at(to);
  const double long_way = std::hypot(q.x - p.x, q.y - p.y), along = std::atan2(q.y - p.y, q.x - p.x);
  if (long_way < shortest) return plot.segment(from, to, Meaning::link);
  const auto on_it = [&](double way, double across) { return plot.from_paper(beside(p, along, way, across)); };
  const double end = end_of_barrel * long_way, half_wide = std::min(widest, half_width * long_way);
  const std::vector<Place> barrel{on_it(clear_of_hinge, -half_wide), on_it(end, -half_wide), on_it(end, half_wide),
                                  on_it(clear_of_hinge, half_wide)};
  plot.area(barrel, Meaning::plate);
  plot.polygon(barrel, Meaning::link);
  plot.segment(from, on_it(clear_of_hinge, 0), Meaning::link);
  plot.segment(on_it(piston * long_way, -half_wide), on_it(piston * long_way, half_wide), Meaning::link);
  plot.segment(on_it(piston * long_way, 0), to, Meaning::link);
}

void Mechanism::draw_joint(Plot& plot, const Point& P) const {
  switch (P.joint) {
    case Joint::none:
      return plot.dot(P.at, Meaning::link);
    case Joint::mass: {
      constexpr double mass_radius = 2;  // mm
      const drawings::Path mass = drawings::circle(plot.at(P.at), mass_radius);
      plot.mark(drawings::Area{mass, Meaning::link, {}});
      return plot.mark(drawings::Line{mass, Meaning::link, {}});
    }
    case Joint::fixed:
      return plot.mark(drawings::FixedHinge{plot.at(P.at), direction_of_support(P, plot.scale())});
    case Joint::hinge:
    case Joint::block:
      return plot.hinge(P.at);
    case Joint::corner:
      return;
  }
}

double Mechanism::radius_of(const Angle& angle) { return angle.is_directed ? from_x_radius : angle_radius; }

// No arc where there is none to see, nor where it would be longer than the links.
void Mechanism::draw_angle(Plot& plot, const Angle& angle) const {
  constexpr double shortest_arc = 4;  // mm
  const double opening = angle.to - angle.from;
  if (std::abs(opening) * angle_radius < shortest_arc || plot.scale().mm_per_unit * reach() < angle_radius) return;
  const Place& O = at(angle.at);
  const std::vector<std::pair<Place, Place>> links = edges(bodies_), others = edges(other_positions_);
  const auto usual = [&](const Angle& each) {
    constexpr double share = 0.6, least = 5;  // of the leg, mm
    double leg = std::numeric_limits<double>::infinity();
    for (const double side : {each.from, each.to})
      leg = std::min({leg, shortest_leg(links, O, side), shortest_leg(others, O, side)});
    return std::min(radius_of(each), std::max(share * leg * plot.scale().mm_per_unit, least));
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
  for (const double side : {angle.from, angle.to})
    if (!has_direction(lines, side)) draw_leg(plot, O, side, radius);
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

void Mechanism::draw(Plot& plot) const {
  constexpr int last_step = 1000;  // more than there are: a result comes with the last
  draw_given(plot);
  for (const Turning& each : turnings_) {
    if (each.is_given) continue;
    plot.in_step(last_step);
    draw_turning(plot, each);
    plot.in_step({});
  }
}

void Mechanism::draw_given(Plot& plot) const {
  draw_discs(plot);
  draw_axes(plot);
  for (const Offset& offset : offsets_) draw_offset(plot, offset);
  for (const Path& path : paths_) plot.circle(at(path.about), distance(at(path.about), at(path.of)), Meaning::axis);
  for (const Swing& each : swings_) {
    const Place &O = at(each.about), &P = at(each.of);
    const double now = direction(O, P), radius = distance(O, P) * plot.scale().mm_per_unit;
    plot.mark(drawings::Line{drawings::arc(plot.at(O), radius, now + each.from, now + each.to), Meaning::axis, {}});
  }
  for (const Guide& guide : guides_) draw_guide(plot, guide);
  // Supports stand behind the links, which run over them where there is no other room.
  const auto is_fixed = [](const Point& P) { return P.joint == Joint::fixed; };
  for (const Point& P : points_)
    if (is_fixed(P)) draw_joint(plot, P);
  draw_bodies(plot);
  for (const Point& P : points_) {
    if (is_fixed(P)) continue;
    begin_step_of(plot, {P.name});
    draw_joint(plot, P);
  }
  for (const Angle& angle : angles_) {
    std::vector<std::string> on_sides;
    for (const Point& P : points_)
      if (P.name != angle.at && has_direction({angle.from, angle.to}, direction(at(angle.at), P.at)))
        on_sides.push_back(P.name);
    begin_step_of(plot, on_sides);
    draw_angle(plot, angle);
  }
  begin_step_of(plot, {});
  for (const Turning& each : turnings_)
    if (each.is_given) draw_turning(plot, each);
  for (const Point& P : points_) {
    begin_step_of(plot, {P.name});
    draw_letters(plot, P);
  }
  begin_step_of(plot, {});
  draw_numbers(plot);
}

void Mechanism::sketch(Plot& plot) const {
  constexpr double beyond = 3;  // mm
  draw_discs(plot);
  for (const Axis& axis : axes_) plot.long_segment(axis.from, axis.to, beyond, Meaning::axis);
  draw_bodies(plot);
  for (const Point& P : points_) {
    if (P.joint == Joint::corner) continue;
    plot.dot(P.at, Meaning::link);
    plot.label(P.letters, P.at, neighbour(P));
  }
}

void Mechanism::include(Extent& extent, const Scale& scale) const {
  constexpr double letters = 7, support = 11;  // mm
  for (const Path& path : paths_) {
    const Place& O = at(path.about);
    const double r = distance(O, at(path.of));
    extent.include(scale, {O.x - r, O.y - r}, 2);
    extent.include(scale, {O.x + r, O.y + r}, 2);
  }
  for (const Point& P : points_) extent.include(scale, P.at, P.joint == Joint::fixed ? support : letters);
  for (const Surface& each : surfaces_)
    for (const Place& P : {each.from, each.to}) extent.include(scale, P, 5);
  for (const Guide& guide : guides_) {
    const Place& P = at(guide.block);
    const drawings::Point p{scale.mm_per_unit * P.x, scale.mm_per_unit * P.y};
    for (const double across : {-support, support})
      for (const double along : {-guide_behind, guide.axis.empty() ? guide_ahead : axis_ahead + 5}) {
        const drawings::Point corner = beside(p, guide.direction, along, across);
        extent.include(corner.x, corner.y);
      }
  }
  for (const Offset& offset : offsets_) {
    const double out = offset.clear * scale.mm_per_unit + support;
    for (const Place& P : {at(offset.point), offset.foot}) {
      const drawings::Point p = beside({scale.mm_per_unit * P.x, scale.mm_per_unit * P.y}, offset.direction, out, 0);
      extent.include(p.x, p.y);
    }
  }
  include_discs(extent, scale);
  include_arcs(extent, scale);
}

// Slots and names of axes too.
void Mechanism::include_discs(Extent& extent, const Scale& scale) const {
  for (const Disc& disc : discs_) {
    const Place& O = at(disc.centre);
    const double r = radius(disc), air = disc.rolls ? surface_beyond : 2;
    extent.include(scale, {O.x - r, O.y - r}, air);
    extent.include(scale, {O.x + r, O.y + r}, air);
  }
  for (const Body& body : bodies_)
    if (body.is_slotted) extent.include(scale, slot(body, scale).second, 3);
  constexpr double name = 10;  // mm
  for (const Axis& axis : axes_)
    if (!axis.name.empty()) extent.include(scale, axis.to, axis_beyond + name);
}

// As far as the arcs reach that tell angles and senses of turning.
void Mechanism::include_arcs(Extent& extent, const Scale& scale) const {
  constexpr double letters = 5, turning_radius = 9;  // mm
  const auto include_arc = [&](const Place& O, double from, double to, double radius) {
    constexpr int pieces = 8;
    for (int i = 0; i <= pieces; ++i) {
      const double direction = from + (to - from) * i / pieces;
      extent.include(scale.mm_per_unit * O.x + (radius + letters) * std::cos(direction),
                     scale.mm_per_unit * O.y + (radius + letters) * std::sin(direction));
    }
  };
  for (const Angle& angle : angles_)
    if (scale.mm_per_unit * reach() >= angle_radius)
      include_arc(at(angle.at), angle.from, angle.to, radius_of(angle));
  for (const Turning& each : turnings_) include_arc(at(each.about), 0, 2 * std::numbers::pi, turning_radius);
}

std::vector<Place> Mechanism::corners() const {
  std::vector<Place> all;
  for (const Point& P : points_) all.push_back(P.at);
  return all;
}

// Twice around the first point at most: a crank's pin comes by on the other side too.
double Mechanism::reach() const {
  const Place& O = points_.front().at;
  double farthest = 0, round = 0;
  for (const Disc& disc : discs_) round = std::max(round, radius(disc));
  for (const Point& P : points_) farthest = std::max(farthest, distance(O, P.at));
  for (const Path& path : paths_) round = std::max(round, distance(at(path.about), at(path.of)));
  const double all = farthest + round;
  return all > 0 ? all : 1;  // a single point has none
}

}  // namespace epure
