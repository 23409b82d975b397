// The forces of a scene as its sheets draw and write them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/nth_letter.h"
#include "exercises/scenes/forces/force_names.h"
#include "exercises/scenes/forces/scene_forces.h"
#include "exercises/scenes/sheets/scene_figure.h"

namespace epure::scenes {

// Of the corners of what is drawn.
inline Place middle_of(const Mechanism& drawn) {
  const std::vector<Place> corners = drawn.corners();
  Arrow2 sum{0, 0};
  for (const Place& P : corners) sum = sum + (P - Place{0, 0});
  return Place{0, 0} + (1.0 / static_cast<double>(corners.size())) * sum;
}

// Where the forces of a scene are and how large, in doubles, and how they are written.
class ForceFigures {
 public:
  ForceFigures(const Built& built, const Solution& s) : built_(built), s_(s), reach_(figure_of(built, s).reach()) {}

  double reach() const { return reach_; }
  std::string letter(int point) const { return "$" + point_letters(built_.letters.points[index(point)]) + "$"; }
  std::string line(int l) const { return "$" + point_letters(built_.letters.lines[index(l)]) + "$"; }
  std::string number(int link) const { return std::to_string(built_.letters.links[index(link)]); }
  Place at(int point) const { return s_.place(built_.letters.points[index(point)]); }
  Place through(int l) const { return s_.place("through " + built_.letters.lines[index(l)]); }

  Arrow2 vector(const ActingForce& force) const {
    using Kind = ActingForce::Kind;
    const std::string name = name_of_force(built_, force);
    const auto k = index(force.which);
    const auto& of = built_.linkage;
    Arrow2 v{0, 0};
    switch (force.kind) {
      case Kind::load:
        v = s_.vector("load " + name);
        break;
      case Kind::weight:
      case Kind::inertia:
      case Kind::hinge:
      case Kind::tooth:
      case Kind::held:
        v = s_.vector(name);
        break;
      case Kind::pin:
        v = of_line(force, pin_force(built_, k).name, along(force));
        break;
      case Kind::guide:
        v = of_line(force, guide_forces(built_, k).force.name, along(force));
        break;
      case Kind::slid:
        v = s_[name] * along(force);
        break;
      case Kind::cylinder: {
        const auto& cylinder = std::get<geometry::Stretched>(of.drives[k]);
        const Arrow2 whole = at(cylinder.to) - at(cylinder.from);
        v = (s_[name] / magnitude(whole)) * whole;
        break;
      }
    }
    return is_reversed(built_, force) ? -v : v;
  }
  // The line that guides what the force acts on, as it is directed: of pins, guides and drives that slide a point.
  Arrow2 along(const ActingForce& force) const {
    const auto& of = built_.linkage;
    const auto k = index(force.which);
    const int line = force.kind == ActingForce::Kind::pin     ? of.pins[k].line
                     : force.kind == ActingForce::Kind::guide ? of.blocks[k].guide
                                                              : std::get<geometry::SlidPoint>(of.drives[k]).guide;
    return s_.vector("along_" + built_.letters.lines[index(line)]);
  }
  // By how much friction turns the force of a line from its normal, counter-clockwise positive: radians.
  double turned_by_friction(const ActingForce& force, const geometry::LineFriction& friction) const {
    const auto k = index(friction.which);
    const int line = friction.is_of_block ? built_.linkage.blocks[k].guide : built_.linkage.pins[k].line;
    const Arrow2 v = vector(force), along = s_.vector("along_" + built_.letters.lines[index(line)]);
    const double across = cross(along, v);
    return across == 0 ? 0 : std::atan(-dot(along, v) / across);
  }
  // From the common tangent of two pitch circles to the force between the teeth, the shorter way: radians. And the
  // direction of that tangent, as the force has it.
  double turned_by_teeth(const ActingForce& force) const {
    const Arrow2 v = vector(force), t = tangent(force);
    return std::atan2(cross(t, v), dot(t, v));
  }
  Arrow2 tangent(const ActingForce& force) const {
    const geometry::MeshingLinks& gear = built_.linkage.gears[index(force.which)];
    const Arrow2 t = geometry::quarter_turn(at(built_.linkage.hinge_of(gear.second, gear.carrier)) -
                                            at(built_.linkage.hinge_of(gear.first, gear.carrier)));
    return dot(t, vector(force)) < 0 ? -t : t;
  }
  // "$α$", of several gears "$α_{25}$".
  std::string pressure_angle(const ActingForce& force) const {
    const bool is_one = built_.linkage.gears.size() == 1;
    return is_one ? "$α$" : "$α_{" + tooth_force(built_, index(force.which)).quantity.of + "}$";
  }
  Place place(const ActingForce& force) const {
    if (force.kind == ActingForce::Kind::load) return s_.place("place of " + name_of_force(built_, force));
    if (force.kind == ActingForce::Kind::tooth) return s_.place("place of " + name_of_force(built_, force));
    if (is_of_mass(force)) return s_.place("centre of " + number(force.link));
    if (force.kind == ActingForce::Kind::guide) return through(built_.linkage.blocks[index(force.which)].moving);
    return at(force.point);
  }
  // On a link; where nothing of that tells it, `otherwise`.
  Place place(const ActingCouple& couple, int link, const Place& otherwise) const {
    const auto k = index(couple.which);
    if (couple.kind == ActingCouple::Kind::hinge)
      return at(JointForces<geometry::Fast>(built_.linkage).hinges[k].point);
    if (couple.kind == ActingCouple::Kind::guide) return through(built_.linkage.blocks[k].moving);
    const auto& points = built_.linkage.links[index(link)].points;
    if (couple.kind == ActingCouple::Kind::drive)
      for (const geometry::LinkPoint& p : points)
        if (built_.linkage.links_at(p.point).front() == 0) return at(p.point);
    if (points.empty()) return otherwise;
    if (points.size() == 1) return at(points[0].point);
    return at(points[0].point) + 0.5 * (at(points[1].point) - at(points[0].point));
  }
  // Of a link from the middle of its first two points.
  std::vector<double> directions(int link) const {
    const auto& points = built_.linkage.links[index(link)].points;
    if (points.size() < 2) return {};
    const double along = epure::direction(at(points[0].point), at(points[1].point));
    return {along, along + std::numbers::pi};
  }
  Place place(const About& about) const { return about.point != nothing ? at(about.point) : through(about.line); }
  Words about_in_words(const About& about) const {
    if (about.point != nothing) return {letter(about.point), letter(about.point)};
    return format_words("the point that {} is given through", "il punto per cui {} è data", line(about.line));
  }

  // What presses on a body with this middle ends there; a load that passes by that, as one that hangs beside it,
  // starts.
  FreeBodyPanel::Arrow there(const ActingForce& force, const Place& middle) const {
    const double passes_by = force.kind == ActingForce::Kind::load ? 0.25 : 0;  // cosine
    const Arrow2 v = vector(force), inwards = middle - place(force);
    return dot(v, inwards) > passes_by * magnitude(v) * magnitude(inwards) ? FreeBodyPanel::Arrow::ends
                                                                           : FreeBodyPanel::Arrow::starts;
  }

  // As a known one, whatever it is.
  PolygonSide side(const ActingForce& force, ForcePart part = ForcePart::whole) const {
    PolygonSide side;
    const bool is_given = force.kind == ActingForce::Kind::load && built_.force_names[index(force.which)].is_given;
    side.quantity = is_given ? "" : name_of_force(built_, force);
    side.label = arrow_of_force(built_, force, part);
    side.magnitude = letters_of_force(built_, force, part);
    if (is_of_mass(force)) {
      const auto k = index(force.which);
      const bool is_weight = force.kind == ActingForce::Kind::weight;
      side.magnitude =
          built_.mass_names[k].mass + "·" + (is_weight ? built_.gravity : acceleration_of_centre(built_, k));
    }
    if (part == ForcePart::whole) {
      side.v = vector(force);
    } else {
      side.quantity = part_of_force(built_, force, part).name;
      side.v = s_.vector(side.quantity);
    }
    side.length = magnitude(side.v);
    // What has a sign is told with it, as among the results.
    if (const int sign = is_reversed(built_, force) ? -1 : 1; part == ForcePart::whole && has_sign(force))
      side.length = sign * s_[side.quantity];
    return side;
  }
  PolygonSide side(const ForceSide& of) const {
    PolygonSide drawn = side(of.force, of.part);
    drawn.direction = of.direction;
    if (of.is_unknown)
      drawn.magnitude = "?";
    else if (*drawn.length == 0)
      drawn.magnitude = "0";
    if (of.line != nothing) {
      const Arrow2 along = s_.vector("along_" + built_.letters.lines[index(of.line)]);
      drawn.along = of.is_square ? geometry::quarter_turn(along) : along;
    } else if (of.from != nothing) {
      drawn.along = at(of.to) - at(of.from);
    }
    if (of.is_along_action && *drawn.length != 0)
      drawn.direction += (turned_by_teeth(of.force) < 0 ? " − " : " + ") + pressure_angle(of.force);
    if (const auto* friction = friction_of(built_, of.force)) {
      const double turned = turned_by_friction(of.force, *friction);
      if (turned != 0) drawn.along = drawn.v;
      drawn.direction += (turned < 0 ? " − " : " + ") + friction_angle(built_, *friction);
    }
    return drawn;
  }
  VectorPolygon polygon(const ForceLoop& loop) const {
    std::vector<PolygonSide> left, right;
    for (const ForceSide& each : loop.left) left.push_back(side(each));
    std::size_t letter = 0;
    for (const ForceSide& each : loop.right) {
      right.push_back(side(each));
      if (right.back().is_drawn()) right.back().tip = "$" + next_corner(letter) + "$";
    }
    VectorPolygon forces = force_polygon(loop.letter, std::move(left), std::move(right));
    forces.origin = "$o_{" + loop.letter + "}$";  // as its corners, and no hinge, are called
    return forces;
  }

  // On the link it acts on: M_43 where M_34 is reported and acts on the other, as forces have it; or −M_b.
  std::string label(const ActingCouple& couple) const {
    const bool is_minus = couple.is_opposite && couple.kind == ActingCouple::Kind::guide;
    return (is_minus ? "−" : "") + symbol(couple);
  }
  // Its letters in an equation.
  std::string symbol(const ActingCouple& couple) const {
    if (couple.kind != ActingCouple::Kind::hinge || !couple.is_opposite) return quantity(couple).symbol;
    const auto hinge = JointForces<geometry::Fast>(built_.linkage).hinges[index(couple.which)];
    const auto [i, j] = std::minmax(built_.letters.links[index(hinge.by)], built_.letters.links[index(hinge.on)]);
    return letters_of_hinge_couple(j, i);
  }
  double value(const ActingCouple& couple) const {
    const double size = couple.kind == ActingCouple::Kind::load
                            ? CGAL::to_double(built_.loads->couples[index(couple.which)].moment)
                            : s_[quantity(couple).name];
    return couple.is_opposite ? -size : size;
  }
  // Of what is reported, or the load's.
  Quantity quantity(const ActingCouple& couple) const {
    const auto k = index(couple.which);
    if (couple.kind == ActingCouple::Kind::guide) return guide_forces(built_, k).couple;
    if (couple.kind == ActingCouple::Kind::hinge) {
      const auto hinge = JointForces<geometry::Fast>(built_.linkage).hinges[k];
      return hinge_couple(built_, hinge.by, hinge.on);
    }
    if (couple.kind == ActingCouple::Kind::inertia) return inertia_couple(built_, k);
    if (couple.kind == ActingCouple::Kind::drive) return driving_effort(built_, built_.linkage.drives[k]);
    return {built_.couple_names[k].name, built_.couple_names[k].symbol, "N*m", {}};
  }
  // How large what its letters stand for is: a given may be negative, and so may what has a sign.
  double value_of_letters(const ActingCouple& couple) const {
    if (couple.kind == ActingCouple::Kind::load)
      if (const LoadName& of = built_.couple_names[index(couple.which)]; of.is_given)
        return CGAL::to_double(s_.givens()[of.name]);
    const bool is_named_by_link = couple.kind == ActingCouple::Kind::load || couple.kind == ActingCouple::Kind::hinge;
    return is_named_by_link ? value(couple) : s_[quantity(couple).name];
  }
  double value_of_letters(const ActingForce& force) const {
    if (force.kind == ActingForce::Kind::load)
      if (const LoadName& of = built_.force_names[index(force.which)]; of.is_given)
        return CGAL::to_double(s_.givens()[of.name]);
    return has_sign(force) ? s_[name_of_force(built_, force)] : magnitude(vector(force));
  }
  // d'Alembert's force and couple.
  Words inertia_in_words(const ActingForce& force) const {
    const auto k = index(force.which);
    const MassName& letters = built_.mass_names[k];
    std::string a = acceleration_of_centre(built_, k);
    a = "$\\vec{a}" + a.substr(2);
    const std::string i = number(force.link);
    const Words in_centre = format_words(
        "Link {0}, d'Alembert: {1} = −{2}·{3} in ${4}$", "Membro {0}, d'Alembert: {1} = −{2}·{3} in ${4}$", i,
        arrow_of_force(built_, force), letters.mass, a, letters_of_centre(built_, k));
    if (letters.inertia.empty() || turns_steadily(built_, force.link)) return in_centre + Words{".", "."};
    return in_centre + format_words(", and {0} = −{1}·$α_{{{2}}}$.", ", e {0} = −{1}·$α_{{{2}}}$.",
                                    inertia_couple(built_, k).symbol, letters.inertia, i);
  }
  double moment(const ActingForce& force, const About& about) const {
    return cross(place(force) - place(about), vector(force));
  }
  bool has_arm(const Arm& arm) const { return s_.value(arm.length.name).value_or(0) != 0; }

 private:
  // Of lines without friction and of drives: what is reported is no size.
  bool has_sign(const ActingForce& force) const {
    using Kind = ActingForce::Kind;
    const bool is_of_line = force.kind == Kind::pin || force.kind == Kind::guide;
    return (is_of_line && !friction_of(built_, force)) || force.kind == Kind::slid || force.kind == Kind::cylinder;
  }
  // A small letter that stands for nothing else: no line of a link, and not gravity.
  std::string next_corner(std::size_t& letter) const {
    const auto& lines = built_.letters.lines;
    for (;;) {
      const std::string corner = nth_letter(letter++);
      if (std::find(lines.begin(), lines.end(), corner) == lines.end() && (corner != "g" || built_.gravity.empty()))
        return corner;
    }
  }
  Arrow2 of_line(const ActingForce& force, const std::string& normal, const Arrow2& along) const {
    const Arrow2 v = s_[normal] * geometry::quarter_turn(along);
    const auto* friction = friction_of(built_, force);
    return friction ? v + s_[friction_force(built_, *friction).name] * along : v;
  }

  const Built& built_;
  const Solution& s_;
  double reach_;
};

}  // namespace epure::scenes
