#include "exercises/kit/panels/mechanism.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/mechanism_on_paper.h"

namespace epure {

using namespace mechanism_on_paper;

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

double Mechanism::radius_of(const Angle& angle) { return angle.is_directed ? from_x_radius : angle_radius; }

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
