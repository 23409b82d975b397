// A mechanism's links, joints, guides and supports as they are drawn.
#include <limits>
#include <utility>

#include "exercises/kit/panels/mechanism_on_paper.h"

namespace epure {
namespace {

using namespace mechanism_on_paper;

// Of a polygon: a ray from X to the right crosses its outline an odd number of times.
bool is_inside(const Place& X, const std::vector<Place>& corners) {
  bool inside = false;
  for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
    const Place &P = corners[i], &Q = corners[before];
    if ((P.y > X.y) != (Q.y > X.y) && X.x < P.x + (X.y - P.y) / (Q.y - P.y) * (Q.x - P.x)) inside = !inside;
  }
  return inside;
}

}  // namespace

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
  // At the end of its wall: vectors along it start in its middle line.
  if (!guide.letter.empty())
    plot.small_label(guide.letter, plot.from_paper(beside(p, guide.direction, guide_ahead, -block_top)),
                     plot.from_paper(beside(p, guide.direction, 0, -block_top)));
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

}  // namespace epure
