#include "exercises/scenes/sheets/scene_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "exercises/kit/statement/quantity.h"

namespace epure::scenes {
namespace {

using geometry::LineOnLine;
using geometry::Link;
using geometry::Linkage;
using geometry::LinkPoint;
using geometry::PinOnLine;

const std::string& letter(const Built& built, int point) {
  return built.letters.points[static_cast<std::size_t>(point)];
}

std::string letter_of_line(const Built& built, int line) {
  return "$" + point_letters(built.letters.lines[static_cast<std::size_t>(line)]) + "$";
}

// The way of a wheel's centre beside the line that it rolls on: nothing guides it but that.
bool is_way_of_wheel(const Linkage& of, const PinOnLine& pin) {
  return std::any_of(of.rolls.begin(), of.rolls.end(), [&](const geometry::RollingWheel& roll) {
    return roll.centre == pin.point && of.link_of_line(roll.line) == of.link_of_line(pin.line);
  });
}

// The guide of the frame on which a point slides, itself or as the first of its link's.
std::optional<int> guide_in_frame(const Linkage& of, int point) {
  for (const PinOnLine& pin : of.pins)
    if (pin.point == point && of.link_of_line(pin.line) == 0 && !is_way_of_wheel(of, pin)) return pin.line;
  for (const LineOnLine& block : of.blocks) {
    const Link& moving = of.links[static_cast<std::size_t>(of.link_of_line(block.moving))];
    if (of.link_of_line(block.guide) == 0 && !moving.points.empty() && moving.points.front().point == point)
      return block.guide;
  }
  return {};
}

bool ends_cylinder(const Linkage& of, int point) {
  return std::any_of(of.drives.begin(), of.drives.end(), [&](const geometry::Drive& drive) {
    const auto* cylinder = std::get_if<geometry::Stretched>(&drive);
    return cylinder && (cylinder->from == point || cylinder->to == point);
  });
}

// A point of the frame alone, of which coordinates are told: no link and no cylinder turns about it.
bool is_idle(const Linkage& of, int point) {
  return of.links_at(point) == std::vector<int>{0} && !ends_cylinder(of, point);
}

Mechanism::Joint joint(const Linkage& of, int point) {
  const std::vector<int> links = of.links_at(point);
  if (is_idle(of, point)) return Mechanism::Joint::none;
  if (links.front() == 0) return Mechanism::Joint::fixed;
  if (guide_in_frame(of, point)) return Mechanism::Joint::block;
  const bool runs_in_a_slot =
      std::any_of(of.pins.begin(), of.pins.end(), [&](const PinOnLine& pin) { return pin.point == point; });
  return links.size() > 1 || runs_in_a_slot || ends_cylinder(of, point) ? Mechanism::Joint::hinge
                                                                        : Mechanism::Joint::none;
}

double direction(const Linkage& of, int line) {
  const geometry::Direction& along = of.line(line).along;
  if (const auto* angle = std::get_if<geometry::Angle>(&along)) return geometry::to_double(*angle);
  const auto& vector = std::get<geometry::Own>(along);
  return std::atan2(CGAL::to_double(vector.y), CGAL::to_double(vector.x));
}

Arrow2 in_doubles(const geometry::Own& own) { return {CGAL::to_double(own.x), CGAL::to_double(own.y)}; }

// A block between moving links of which no more than its hinge is drawn.
bool is_hinged_block(const Linkage& of, const LineOnLine& block) {
  const auto& points = of.links[static_cast<std::size_t>(of.link_of_line(block.moving))].points;
  return points.size() == 1 && of.links_at(points.front().point).size() > 1;
}

// A pin, and the line of a link on which it runs, itself or by a block that is no more than this hinge.
struct PinInSlot {
  int pin, line;
  bool is_of_block = false;
};

// A block of one point, on no hinge, that slides in two guides, as the middle of Oldham's coupling: drawn in both.
bool is_cross(const Linkage& of, int link) {
  const auto& points = of.links[static_cast<std::size_t>(link)].points;
  return points.size() == 1 && of.links_at(points.front().point).size() == 1 &&
         std::count_if(of.blocks.begin(), of.blocks.end(),
                       [&](const LineOnLine& block) { return of.link_of_line(block.moving) == link; }) > 1;
}

// The pins that run in slots of the link, and the joints of blocks that do. Of a block between two moving links the
// guide is slotted, and the block where it is no bar itself.
std::vector<PinInSlot> pins_in(const Linkage& of, int link) {
  std::vector<PinInSlot> pins;
  if (is_cross(of, link)) return pins;
  for (const PinOnLine& pin : of.pins)
    if (of.link_of_line(pin.line) == link && !is_way_of_wheel(of, pin)) pins.push_back({pin.point, pin.line});
  for (const LineOnLine& block : of.blocks)
    for (const auto& [own, other] : {std::pair(block.moving, block.guide), {block.guide, block.moving}}) {
      if (of.link_of_line(own) != link || of.link_of_line(other) == 0) continue;
      const bool is_slotted = own == block.guide || (of.links[static_cast<std::size_t>(link)].points.size() < 2 &&
                                                     !is_hinged_block(of, block));
      if (!is_slotted) continue;
      for (const LinkPoint& p : of.links[static_cast<std::size_t>(of.link_of_line(other))].points)
        pins.push_back({p.point, own, is_hinged_block(of, block) || is_cross(of, of.link_of_line(other))});
    }
  return pins;
}

// Whether a slot can be drawn in a bar: all points of the link are on its line.
bool lie_on(const std::vector<LinkPoint>& points, const geometry::LinkLine& line) {
  const auto* along = std::get_if<geometry::Own>(&line.along);
  return along && std::all_of(points.begin(), points.end(), [&](const LinkPoint& p) {
           return along->x * (p.at.y - line.through.y) == along->y * (p.at.x - line.through.x);
         });
}

// The first pin that stands apart from the last of the link's own points, if it has any: a slot has a direction.
std::optional<PinInSlot> pin_apart(const std::vector<PinInSlot>& pins, const std::vector<std::string>& own,
                                   const Mechanism& figure, const Built& built) {
  constexpr double apart = 1e-6;  // of the whole
  for (const PinInSlot& each : pins)
    if (!own.empty() && distance(figure.at(own.back()), figure.at(letter(built, each.pin))) > apart * figure.reach())
      return each;
  return {};
}

// A line of a link where the link now has it; none of a link without points.
struct LineNow {
  Place through;
  Arrow2 along;
};
std::optional<LineNow> line_now(const Built& built, const Solution& s, int line) {
  const int link = built.linkage.link_of_line(line);
  if (built.linkage.links[static_cast<std::size_t>(link)].points.empty()) return {};
  const geometry::PlacedLink<double> now = placed(built, s, link);
  const double along = direction(built.linkage, line);
  return LineNow{now.at(in_doubles(built.linkage.line(line).through)),
                 now.turned({std::cos(along), std::sin(along)})};
}
Place foot_on(const LineNow& line, const Place& P) {
  return line.through + dot(P - line.through, line.along) * line.along;
}

bool is_on_its_line(const Mechanism& figure, const Built& built, const Solution& s, const PinInSlot& run) {
  constexpr double thin = 1e-6;  // of the whole
  const Place P = figure.at(letter(built, run.pin));
  const auto line = line_now(built, s, run.line);
  return line && distance(P, foot_on(*line, P)) <= thin * figure.reach();
}

// A link whose slot misses its hinge: an arm from there to the slot, and the slot where it is, around its pin.
bool add_slot_aside(Mechanism& figure, const Built& built, const Solution& s, int link) {
  const Linkage& of = built.linkage;
  const std::vector<PinInSlot> pins = pins_in(of, link);
  const Link& plate = of.links[static_cast<std::size_t>(link)];
  if (pins.empty() || plate.points.empty()) return false;
  const auto line = line_now(built, s, pins.front().line);
  if (!line) return false;
  const std::string name = "slot of " + std::to_string(link);
  std::vector<std::string> points;
  for (const LinkPoint& p : plate.points) points.push_back(letter(built, p.point));
  const Place pin = foot_on(*line, figure.at(letter(built, pins.front().pin))),
              arm = foot_on(*line, figure.at(points.front()));
  constexpr double apart = 1e-6, stub = 0.12;  // of the whole
  const double far = apart * figure.reach();
  const Place end = distance(pin, arm) > far ? arm : pin + (-stub * figure.reach()) * line->along;
  const auto corner = [&](const std::string& which, const Place& at) {
    figure.point(name + which, at, Mechanism::Joint::corner, "");
    return name + which;
  };
  const bool has_corner = std::any_of(points.begin(), points.end(),
                                      [&](const std::string& P) { return distance(figure.at(P), arm) <= far; });
  if (!has_corner) points.push_back(corner("'s foot", arm));
  if (points.size() > 1) figure.body(points, built.letters.links[static_cast<std::size_t>(link)]);
  figure.slotted({corner("'s end", end), corner("'s pin", pin)},
                 points.size() > 1 ? 0 : built.letters.links[static_cast<std::size_t>(link)], false,
                 letter_of_line(built, pins.front().line));
  return true;
}

// A rod that slides in a link of one hinge, both straight along the line of the slide: as a piston in a cylinder.
// The slide of such a cylinder; none of another link.
const LineOnLine* telescope(const Linkage& of, int cylinder) {
  const auto found = std::find_if(of.blocks.begin(), of.blocks.end(), [&](const LineOnLine& block) {
    if (of.link_of_line(block.guide) != cylinder) return false;
    const auto &hinge = of.links[static_cast<std::size_t>(cylinder)].points,
               &rod = of.links[static_cast<std::size_t>(of.link_of_line(block.moving))].points;
    return hinge.size() == 1 && rod.size() == 2 && lie_on(hinge, of.line(block.guide)) &&
           lie_on(rod, of.line(block.moving));
  });
  return found == of.blocks.end() ? nullptr : &*found;
}

bool add_barrel(Mechanism& figure, const Built& built, int link) {
  const Linkage& of = built.linkage;
  const LineOnLine* slide = link == 0 ? nullptr : telescope(of, link);
  if (!slide) return false;
  const std::string& hinge = letter(built, of.links[static_cast<std::size_t>(link)].points.front().point);
  const auto& rod = of.links[static_cast<std::size_t>(of.link_of_line(slide->moving))].points;
  std::vector<std::string> ends{letter(built, rod.front().point), letter(built, rod.back().point)};
  const auto way = [&](const std::string& P) { return distance(figure.at(hinge), figure.at(P)); };
  if (way(ends[1]) < way(ends[0])) std::swap(ends[0], ends[1]);
  const Place C = figure.at(hinge), K = figure.at(ends[0]);
  const Arrow2 rod_way = figure.at(ends[1]) - K, along = (1 / magnitude(rod_way)) * rod_way;
  constexpr double half_wide = 0.03, least = 0.03, of_the_rod = 0.4;  // of the whole, and in the barrel
  const double whole = figure.reach(), behind = std::min(least * whole, dot(K - C, along) - least * whole);
  const Place low = C + behind * along, high = K + of_the_rod * rod_way;
  const std::string name = "barrel of " + std::to_string(link);
  const auto corner = [&](const Place& on_axis, double side, const std::string& letters = {}) {
    const std::string corners = name + std::to_string(figure.corners().size());
    figure.point(corners, on_axis + (side * half_wide * whole) * geometry::quarter_turn(along),
                 Mechanism::Joint::corner, letters);
    return corners;
  };
  const std::string first = corner(low, -1), letters = corner(high, -1, letter_of_line(built, slide->guide)),
                    third = corner(high, 1), last = corner(low, 1);
  figure.body({first, letters, third, last}, built.letters.links[static_cast<std::size_t>(link)]);
  figure.body({hinge, corner(low, 0)});
  figure.body({corner(K, -1), corner(K, 1)});
  return true;
}

// A bar or a plate, with the slot in which a pin runs; nothing of a link that has neither. Whether it was drawn.
bool add_link(Mechanism& figure, const Built& built, const Solution& s, int link) {
  const Linkage& of = built.linkage;
  if (add_barrel(figure, built, link)) return true;
  const Link& own = of.links[static_cast<std::size_t>(link)];
  const int number = built.letters.links[static_cast<std::size_t>(link)];
  std::vector<std::string> points;
  for (const LinkPoint& p : own.points) points.push_back(letter(built, p.point));
  const auto pin = pin_apart(pins_in(of, link), points, figure, built);
  const bool is_straight = std::all_of(own.lines.begin(), own.lines.end(),
                                       [&](const geometry::LinkLine& line) { return lie_on(own.points, line); });
  if (pin && lie_on(own.points, of.line(pin->line)) && is_on_its_line(figure, built, s, *pin)) {
    points.push_back(letter(built, pin->pin));
    figure.slotted(points, number, pin->is_of_block, letter_of_line(built, pin->line));
    return true;
  }
  if ((points.size() > 1 || !is_straight) && add_slot_aside(figure, built, s, link)) return true;
  if (points.size() < 2) return false;
  figure.body(points, number);
  return true;
}

// A block of one point has its number beside that.
void add_number_of_block(Mechanism& figure, const Built& built, int link) {
  const Linkage& of = built.linkage;
  const auto& points = of.links[static_cast<std::size_t>(link)].points;
  const bool is_block = std::any_of(of.blocks.begin(), of.blocks.end(),
                                    [&](const LineOnLine& each) { return of.link_of_line(each.moving) == link; });
  if (!is_block || points.size() != 1) return;
  const std::string number = std::to_string(built.letters.links[static_cast<std::size_t>(link)]);
  figure.point("number " + number, figure.at(letter(built, points.front().point)), Mechanism::Joint::corner, number);
}

// The hinge of a link on the frame, and another of its points, or one in its slot; none where there are not both.
std::optional<std::pair<int, int>> crank_of(const Linkage& of, int link) {
  std::optional<int> hinge, pin;
  for (const LinkPoint& p : of.links[static_cast<std::size_t>(link)].points)
    (of.links_at(p.point).front() == 0 ? hinge : pin) = p.point;
  if (const auto in_slot = pins_in(of, link); !pin && !in_slot.empty()) pin = in_slot.front().pin;
  if (!hinge || !pin) return {};
  return std::pair{*hinge, *pin};
}

// A wheel by its pitch circle: filled where it is a round body, and a ring by its circle alone. Other links' centres
// need not be in the figure.
void add_wheel(Mechanism& figure, const Built& built, const Solution& s, const geometry::MeshingLinks& gear,
               bool is_first, bool is_numbered) {
  const Linkage& of = built.linkage;
  const auto hidden = [&](const std::string& name, const Place& at) {
    figure.point(name, at, Mechanism::Joint::corner, "");
    return name;
  };
  const int wheel = is_first ? gear.first : gear.second, centre = of.hinge_of(wheel, gear.carrier),
            other = of.hinge_of(is_first ? gear.second : gear.first, gear.carrier);
  const double own = CGAL::to_double(is_first ? gear.first_teeth : gear.second_teeth),
               others = CGAL::to_double(is_first ? gear.second_teeth : gear.first_teeth);
  const Place O = s.place(letter(built, centre)), Q = s.place(letter(built, other));
  const double radius = distance(O, Q) * own / std::abs(gear.is_inside ? own - others : own + others);
  const bool is_ring = gear.is_inside && own > others;
  const std::string name = std::to_string(wheel) + "*" + std::to_string(is_first ? gear.second : gear.first);
  if (!is_ring) {
    const double square = epure::direction(O, Q) + std::numbers::pi / 2;
    const bool is_bar = of.links[static_cast<std::size_t>(wheel)].points.size() > 1;
    figure.disc(letter(built, centre),
                hidden(name, {O.x + radius * std::cos(square), O.y + radius * std::sin(square)}), false,
                !is_numbered || is_bar || wheel == 0 ? 0 : built.letters.links[static_cast<std::size_t>(wheel)]);
    return;
  }
  figure.profile(O, radius, 0, 2 * std::numbers::pi);
  if (is_numbered) {
    const double below = -3 * std::numbers::pi / 4;
    figure.point(name + "'s number", {O.x + radius * std::cos(below), O.y + radius * std::sin(below)},
                 Mechanism::Joint::corner, std::to_string(built.letters.links[index(wheel)]));
  }
  for (const int quarter : {0, 1, 2, 3})
    hidden(name + std::to_string(quarter), {O.x + radius * std::cos(quarter * std::numbers::pi / 2),
                                            O.y + radius * std::sin(quarter * std::numbers::pi / 2)});
}
// A link may have several wheels, and has one number.
void add_wheels(Mechanism& figure, const Built& built, const Solution& s) {
  std::set<int> numbered;
  for (const geometry::MeshingLinks& gear : built.linkage.gears)
    for (const bool is_first : {true, false})
      add_wheel(figure, built, s, gear, is_first, numbered.insert(is_first ? gear.first : gear.second).second);
}
// A link with a bar or plate of its own, or a block, has its number there.
bool is_numbered_elsewhere(const Linkage& of, int link) {
  return of.links[index(link)].points.size() > 1 ||
         std::any_of(of.blocks.begin(), of.blocks.end(),
                     [&](const LineOnLine& each) { return of.link_of_line(each.moving) == link; });
}

// A wheel that rolls, and the line on which it does so: of the frame a surface, of another link a bar, as far as from
// its points to beyond the wheel.
void add_rolling(Mechanism& figure, const Built& built, const Solution& s, const geometry::RollingWheel& roll) {
  const Linkage& of = built.linkage;
  const int link = of.link_of_line(roll.line);
  const Arrow2 along = s.vector("along_" + built.letters.lines[index(roll.line)]);
  const double r = CGAL::to_double(roll.radius);
  const Place C = figure.at(letter(built, roll.centre)), touched = C + (-r) * geometry::quarter_turn(along);
  const std::string name =
      "rolling of " + std::to_string(roll.wheel) + " on " + built.letters.lines[index(roll.line)];
  const auto corner = [&](const std::string& which, const Place& at, const std::string& letters) {
    figure.point(name + which, at, Mechanism::Joint::corner, letters);
    return name + which;
  };
  constexpr double beyond = 1.6;  // radii
  double low = -beyond * std::abs(r), high = -low;
  if (link != 0)
    for (const LinkPoint& p : of.links[index(link)].points) {
      const double ahead = dot(figure.at(letter(built, p.point)) - touched, along);
      low = std::min(low, ahead), high = std::max(high, ahead);
    }
  const std::string first = corner("'s beginning", touched + low * along, ""),
                    last = corner("'s end", touched + high * along, letter_of_line(built, roll.line));
  if (link != 0)
    figure.body({first, last}, is_numbered_elsewhere(of, link) ? 0 : built.letters.links[index(link)]);
  else if (r > 0)
    figure.surface(figure.at(first), figure.at(last));
  else
    figure.surface(figure.at(last), figure.at(first));
  const bool is_bar = of.links[index(roll.wheel)].points.size() > 1;
  figure.disc(letter(built, roll.centre), corner("'s rim", touched, ""), false,
              is_bar ? 0 : built.letters.links[index(roll.wheel)]);
}
// Those that the link is; whether there are any.
bool add_wheels_of(Mechanism& figure, const Built& built, const Solution& s, int link) {
  bool is_wheel = false;
  for (const geometry::MeshingLinks& gear : built.linkage.gears)
    for (const bool is_first : {true, false}) {
      if ((is_first ? gear.first : gear.second) != link) continue;
      add_wheel(figure, built, s, gear, is_first, !is_wheel);
      is_wheel = true;
    }
  return is_wheel;
}

// The way along a guide that has its wall, on the right, on the side from which no link comes steeply: that would
// pass through the wall.
double direction_beside_links(const Built& built, const Mechanism& figure, int point, double along) {
  constexpr double flat = 0.35;  // radians: passes the end of the wall
  const Linkage& of = built.linkage;
  const Place& P = figure.at(letter(built, point));
  const auto has_link_on_the_right = [&](double ahead) {
    for (const int link : of.links_at(point))
      for (const LinkPoint& other : of.links[static_cast<std::size_t>(link)].points) {
        if (other.point == point) continue;
        const double turned =
            std::remainder(epure::direction(P, figure.at(letter(built, other.point))) - ahead, 2 * std::numbers::pi);
        if (turned < -flat && turned > flat - std::numbers::pi) return true;
      }
    return false;
  };
  const double back = along + std::numbers::pi;
  return has_link_on_the_right(along) && !has_link_on_the_right(back) ? back : along;
}

// The lines of the frame that points are told from.
void add_lines(Mechanism& figure, const Built& built) {
  for (const PointOffset& offset : built.offsets) {
    const Linkage& of = built.linkage;
    if (of.link_of_line(offset.line) != 0) continue;
    const auto& through = of.line(offset.line).through;
    const Place G{CGAL::to_double(through.x), CGAL::to_double(through.y)}, P = figure.at(letter(built, offset.point));
    const double towards = direction(of, offset.line), ux = std::cos(towards), uy = std::sin(towards),
                 along = (P.x - G.x) * ux + (P.y - G.y) * uy, half = figure.reach() / 5;
    figure.axis({G.x + (along - half) * ux, G.y + (along - half) * uy},
                {G.x + (along + half) * ux, G.y + (along + half) * uy}, letter_of_line(built, offset.line));
  }
}

// A block along its guide, about its first point.
void add_block(Mechanism& figure, const Built& built, const Solution& s, int link, double size) {
  const Link& own = built.linkage.links[static_cast<std::size_t>(link)];
  const int number = built.letters.links[static_cast<std::size_t>(link)];
  const Arrow2 along =
      own.lines.empty() ? Arrow2{1, 0}
                        : s.vector("along_" + built.letters.lines[static_cast<std::size_t>(own.lines.front().line)]);
  const Place P = figure.at(letter(built, own.points.front().point));
  std::vector<std::string> corners;
  for (const auto& [x, y] : {std::pair(-1.0, -0.6), {1.0, -0.6}, {1.0, 0.6}, {-1.0, 0.6}}) {
    corners.push_back("corner " + std::to_string(corners.size()));
    figure.point(corners.back(), P + (x * size) * along + (y * size) * geometry::quarter_turn(along),
                 Mechanism::Joint::corner, "");
  }
  figure.body(corners, number);
}

}  // namespace

void add_in_outline(Mechanism& mechanism, const Built& built, const std::string& name,
                    const std::vector<Place>& points, const std::map<int, std::string>& letters) {
  const auto moves = [&](int p) { return built.linkage.links_at(p).front() != 0; };
  const auto there = [&](int p) { return (moves(p) ? name + " " : "") + built.letters.points[index(p)]; };
  for (int p = 0; p < built.linkage.count_of_points(); ++p)
    if (moves(p))
      mechanism.point(there(p), points[index(p)],
                      letters.empty() || letters.count(p) ? Mechanism::Joint::none : Mechanism::Joint::corner,
                      letters.count(p) ? letters.at(p) : "");
  for (std::size_t link = 1; link < built.linkage.links.size(); ++link) {
    std::vector<std::string> corners;
    for (const geometry::LinkPoint& p : built.linkage.links[link].points) corners.push_back(there(p.point));
    if (corners.size() > 1) mechanism.other_position(corners);
  }
}

Mechanism figure_of_link(const Built& built, const Solution& s, int link, const std::vector<int>& acting,
                         double size_of_block, const Place& otherwise) {
  const Linkage& of = built.linkage;
  const std::vector<LinkPoint>& own = of.links[static_cast<std::size_t>(link)].points;
  Mechanism figure;
  if (own.empty()) return figure.point("", otherwise, Mechanism::Joint::corner, "");
  for (const LinkPoint& p : own)
    figure.point(letter(built, p.point), s.place(letter(built, p.point)),
                 joint(of, p.point) == Mechanism::Joint::none ? Mechanism::Joint::none : Mechanism::Joint::hinge,
                 "$" + point_letters(letter(built, p.point)) + "$");
  std::vector<std::string> arm{letter(built, own.front().point)};
  for (const PinInSlot& run : pins_in(of, link)) {
    const std::string& name = letter(built, run.pin);
    if (std::any_of(own.begin(), own.end(), [&](const LinkPoint& p) { return p.point == run.pin; })) continue;
    const bool is_seen = std::find(acting.begin(), acting.end(), run.pin) != acting.end();
    figure.point(name, s.place(name), is_seen ? Mechanism::Joint::none : Mechanism::Joint::corner,
                 is_seen ? "$" + point_letters(name) + "$" : "");
    if (is_seen && arm.size() == 1) arm.push_back(name);
  }
  const bool is_block =
      own.size() == 1 && std::any_of(of.blocks.begin(), of.blocks.end(),
                                     [&](const LineOnLine& each) { return of.link_of_line(each.moving) == link; });
  if (!is_block) add_link(figure, built, s, link);
  if (is_block && arm.size() > 1) figure.body(arm);
  const bool is_wheel = add_wheels_of(figure, built, s, link);
  if (own.size() == 1 && !is_wheel && (is_block || !figure.has_bodies()))
    add_block(figure, built, s, link, size_of_block);
  return figure;
}

geometry::PlacedLink<double> placed(const Built& built, const Solution& s, int link) {
  const Link& own = built.linkage.links[static_cast<std::size_t>(link)];
  const LinkPoint& first = own.points.front();
  const Place P = s.place(letter(built, first.point));
  Arrow2 was, is;
  if (own.points.size() > 1) {
    was = in_doubles(own.points.back().at) - in_doubles(first.at);
    is = s.place(letter(built, own.points.back().point)) - P;
  } else {
    const int line = own.lines.front().line;
    const double along = direction(built.linkage, line);
    was = {std::cos(along), std::sin(along)};
    is = s.vector("along_" + built.letters.lines[static_cast<std::size_t>(line)]);
  }
  const double turned = std::atan2(cross(was, is), dot(was, is));
  geometry::PlacedLink<double> now{{0, 0}, {std::cos(turned), std::sin(turned)}};
  now.O = P + (-1.0) * now.turned(in_doubles(first.at));
  return now;
}

std::vector<std::string> moving_points(const Built& built) {
  std::vector<std::string> names;
  for (int p = 0; p < built.linkage.count_of_points(); ++p)
    if (built.linkage.links_at(p).front() != 0) names.push_back(letter(built, p));
  return names;
}

Mechanism figure_of(const Built& built, const Solution& solution) {
  const Linkage& of = built.linkage;
  Mechanism figure;
  for (int p = 0; p < of.count_of_points(); ++p)
    figure.point(letter(built, p), solution.place(letter(built, p)), joint(of, p),
                 "$" + point_letters(letter(built, p)) + "$");
  std::vector<int> without_number;
  for (std::size_t i = 1; i < of.links.size(); ++i)
    if (!add_link(figure, built, solution, static_cast<int>(i))) without_number.push_back(static_cast<int>(i));
  for (const geometry::Drive& drive : of.drives)
    if (const auto* cylinder = std::get_if<geometry::Stretched>(&drive))
      figure.cylinder(letter(built, cylinder->from), letter(built, cylinder->to));
  for (int p = 0; p < of.count_of_points(); ++p)
    if (const auto line = guide_in_frame(of, p))
      figure.guide(letter(built, p), direction_beside_links(built, figure, p, direction(of, *line)), {},
                   letter_of_line(built, *line));
  for (const geometry::Drive& drive : of.drives)
    if (const auto* turned = std::get_if<geometry::TurnedLink>(&drive))
      if (const auto crank = crank_of(of, turned->link))
        figure.turning(letter(built, crank->first), letter(built, crank->second), sign_of(turned->omega),
                       angular_velocity(built.letters.links[static_cast<std::size_t>(turned->link)]).symbol);
  add_wheels(figure, built, solution);
  for (const geometry::RollingWheel& roll : of.rolls) add_rolling(figure, built, solution, roll);
  for (const int link : without_number) add_number_of_block(figure, built, link);
  add_lines(figure, built);
  return figure;
}

}  // namespace epure::scenes
