#include "exercises/scenes/force_sheets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/force_groups.h"
#include "exercises/scenes/in_lines.h"
#include "exercises/scenes/scene_figure.h"
#include "exercises/scenes/scene_forces.h"

namespace epure::scenes {
namespace {

using geometry::nothing;

// The names of links or of a pin: "3 and 4".
Words enumerated_links(const std::vector<std::string>& numbers) {
  Words all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) all = all + (i + 1 == numbers.size() ? Words{" and ", " e "} : Words{", ", ", "});
    all = all + Words{numbers[i], numbers[i]};
  }
  return all;
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
    const auto along = [&](int l) { return s_.vector("along_" + built_.letters.lines[index(l)]); };
    Arrow2 v{0, 0};
    switch (force.kind) {
      case Kind::load:
        v = s_.vector("load " + name);
        break;
      case Kind::weight:
      case Kind::inertia:
      case Kind::hinge:
      case Kind::held:
        v = s_.vector(name);
        break;
      case Kind::pin:
        v = s_[name] * geometry::quarter_turn(along(of.pins[k].line));
        break;
      case Kind::guide:
        v = s_[name] * geometry::quarter_turn(along(of.blocks[k].guide));
        break;
      case Kind::slid:
        v = s_[name] * along(std::get<geometry::SlidPoint>(of.drives[k]).guide);
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
  Place place(const ActingForce& force) const {
    if (force.kind == ActingForce::Kind::load) return s_.place("place of " + name_of_force(built_, force));
    if (is_of_mass(force)) return s_.place("centre of " + number(force.link));
    if (force.kind == ActingForce::Kind::guide) return through(built_.linkage.blocks[index(force.which)].moving);
    return at(force.point);
  }
  Place place(const About& about) const { return about.point != nothing ? at(about.point) : through(about.line); }
  Words about_in_words(const About& about) const {
    if (about.point != nothing) return {letter(about.point), letter(about.point)};
    return format_words("the point that {} is given through", "il punto per cui {} è data", line(about.line));
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
    return drawn;
  }
  VectorPolygon polygon(const ForceLoop& loop) const {
    std::vector<PolygonSide> left, right;
    for (const ForceSide& each : loop.left) left.push_back(side(each));
    char corner = 'a';
    for (const ForceSide& each : loop.right) {
      right.push_back(side(each));
      if (right.back().is_drawn()) right.back().tip = std::string("$") + corner++ + "$";
    }
    return force_polygon(loop.letter, std::move(left), std::move(right));
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
    if (couple.kind == ActingCouple::Kind::inertia) return inertia_couple(built_, k);
    if (couple.kind == ActingCouple::Kind::drive) return driving_effort(built_, built_.linkage.drives[k]);
    return {built_.couple_names[k].name, built_.couple_names[k].symbol, "N*m", {}};
  }
  // How large what its letters stand for is: a given may be negative, and so may what has a sign.
  double value_of_letters(const ActingCouple& couple) const {
    if (couple.kind == ActingCouple::Kind::load)
      if (const LoadName& of = built_.couple_names[index(couple.which)]; of.is_given)
        return CGAL::to_double(s_.givens()[of.name]);
    return couple.kind == ActingCouple::Kind::load ? value(couple) : s_[quantity(couple).name];
  }
  double value_of_letters(const ActingForce& force) const {
    using Kind = ActingForce::Kind;
    if (force.kind == Kind::load)
      if (const LoadName& of = built_.force_names[index(force.which)]; of.is_given)
        return CGAL::to_double(s_.givens()[of.name]);
    if (force.kind == Kind::pin || force.kind == Kind::guide || force.kind == Kind::slid ||
        force.kind == Kind::cylinder)
      return s_[name_of_force(built_, force)];
    return magnitude(vector(force));
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
  const Built& built_;
  const Solution& s_;
  double reach_;
};

// An equation of moments in words: what is sought on the left, the other terms with the signs that they then have.
class MomentsInWords {
 public:
  MomentsInWords(const ForceFigures& of, const Built& built, const Moments& moments)
      : of_(of), built_(built), moments_(moments) {}

  Words all() const {
    const std::string right = terms();
    return format_words("Link {0}, moments about {1}: {2} = {3}.", "Membro {0}, momenti rispetto a {1}: {2} = {3}.",
                        of_.number(moments_.link), of_.about_in_words(moments_.about), left(),
                        right.empty() ? "0" : right);
  }

 private:
  static int sign_of_term(double moment, double letters) { return (moment < 0) != (letters < 0) ? -1 : 1; }

  std::string left() const {
    if (const auto* of_rod = std::get_if<AcrossRod>(&moments_.sought)) {
      const std::string arm = of_.letter(of_rod->pin), joint = of_.letter(of_rod->joint);
      return letters_of_force(built_, of_rod->force, ForcePart::across) + "·" + arm + joint;
    }
    if (const auto* arm = std::get_if<Arm>(&moments_.sought)) return product(*arm);
    return of_.quantity(std::get<ActingCouple>(moments_.sought)).symbol;
  }
  // By which sign what is sought stands among the moments.
  int sign_of_sought() const {
    if (const auto* of_rod = std::get_if<AcrossRod>(&moments_.sought)) {
      const Arrow2 lever = of_.at(of_rod->pin) - of_.place(moments_.about);
      return cross(lever, of_.side(of_rod->force, ForcePart::across).v) < 0 ? -1 : 1;
    }
    if (const auto* arm = std::get_if<Arm>(&moments_.sought))
      return sign_of_term(of_.moment(arm->force, moments_.about), of_.value_of_letters(arm->force));
    return std::get<ActingCouple>(moments_.sought).is_opposite ? -1 : 1;
  }
  std::string product(const Arm& arm) const { return letters_of_force(built_, arm.force) + "·" + arm.length.symbol; }
  std::string terms() const {
    const int other_side = -sign_of_sought();
    std::string written;
    const auto add = [&](double moment, double letters, const std::string& what) {
      if (moment == 0) return;
      const bool is_minus = other_side * sign_of_term(moment, letters) < 0;
      written += written.empty() ? (is_minus ? "−" : "") : (is_minus ? " − " : " + ");
      written += what;
    };
    for (const Arm& arm : moments_.arms)
      if (of_.has_arm(arm)) add(of_.moment(arm.force, moments_.about), of_.value_of_letters(arm.force), product(arm));
    for (const ActingCouple& each : moments_.couples)
      add(of_.value(each), of_.value_of_letters(each), of_.quantity(each).symbol);
    return written;
  }

  const ForceFigures& of_;
  const Built& built_;
  const Moments& moments_;
};

// A group's links cut free, and the polygons of their forces.
class GroupSheet {
 public:
  GroupSheet(const Built& built, const Solution& s, const GroupForces& group)
      : built_(built), s_(s), group_(group), of_(built, s) {}

  enum class Shows { all, bodies, polygons };
  PanelSheet sheet(Shows shows) const {
    PanelSheet sheet;
    if (shows != Shows::polygons)
      for (const LinkForces& body : group_.bodies) add(sheet, cut_free(body));
    if (shows != Shows::bodies)
      for (const ForceLoop& loop : group_.loops)
        if (!is_of_two(loop)) add(sheet, polygon(loop));
    add_results(sheet, shows);
    sheet.seen =
        shows == Shows::polygons ? Words{"The polygon of the forces", "Il poligono delle forze"}
        : shows == Shows::bodies
            ? format_words("{}, with the arms of the forces", "{}, con i bracci delle forze", seen_bodies())
            : format_words("{}, and the polygon of the forces", "{}, e il poligono delle forze", seen_bodies());
    return sheet;
  }

 private:
  template <class Kind>
  static void add(PanelSheet& sheet, Kind panel) {
    sheet.panels.push_back(std::make_unique<Kind>(std::move(panel)));
  }
  Words seen_bodies() const {
    std::vector<std::string> numbers;
    for (const LinkForces& body : group_.bodies)
      if (body.link != nothing) numbers.push_back(of_.number(body.link));
    if (numbers.empty()) return {"The pin cut free", "Il perno isolato"};
    return numbers.size() == 1 ? format_words("Link {} cut free", "Il membro {} isolato", numbers[0])
                               : format_words("Links {} cut free", "I membri {} isolati", enumerated_links(numbers));
  }

  // Two forces need no polygon.
  static bool is_of_two(const ForceLoop& loop) {
    return loop.right.size() == 1 && loop.left.front().direction == "?";
  }

  Mechanism figure(const LinkForces& body) const {
    constexpr double of_reach = 1.0 / 30;
    if (body.link != nothing) {
      std::vector<int> acting;
      for (const auto* forces : {&body.known, &body.sought})
        for (const ActingForce& force : *forces) acting.push_back(force.point);
      return figure_of_link(built_, s_, body.link, acting, of_reach * of_.reach(), of_.place(any_force(body)));
    }
    Mechanism pin;
    const int point = any_force(body).point;
    pin.point("pin", of_.at(point), Mechanism::Joint::hinge, of_.letter(point));
    return pin;
  }
  // Of a mass that is in no point of its own name.
  void add_centre(Mechanism& link, const LinkForces& body) const {
    for (const ActingForce& force : body.known)
      if (force.kind == ActingForce::Kind::inertia && force.point == nothing)
        link.point("centre", of_.place(force), Mechanism::Joint::mass,
                   "$" + letters_of_centre(built_, index(force.which)) + "$");
  }
  static const ActingForce& any_force(const LinkForces& body) {
    return body.sought.empty() ? body.known.front() : body.sought.front();
  }

  FreeBodyPanel cut_free(const LinkForces& body) const {
    Mechanism link = figure(body);
    add_centre(link, body);
    const auto drawn = std::make_shared<const Mechanism>(std::move(link));
    FreeBodyPanel panel(drawn);
    panel.to_scale();
    // What has no size of its own is no larger than the whole mechanism lets it be.
    constexpr double millimetres = 1000;
    if (drawn->reach() < of_.reach() / 4) panel.at_most(millimetres / of_.reach() / 2);
    Place middle{0, 0};
    for (const Place& P : drawn->corners())
      middle = middle + (1.0 / static_cast<double>(drawn->corners().size())) * (P - Place{0, 0});
    for (const auto* forces : {&body.known, &body.sought})
      for (const ActingForce& force : *forces) draw(panel, force, middle);
    for (const ActingCouple& each : body.couples)
      panel.couple(of_.quantity(each).symbol, place_of_couple(each, body), of_.value(each), directions(body));
    add_steps(panel, body);
    return panel;
  }
  // What presses on the body ends there.
  void draw(FreeBodyPanel& panel, const ActingForce& force, const Place& middle) const {
    const Place P = of_.place(force);
    const PolygonSide side = of_.side(force);
    const auto there = dot(side.v, middle - P) > 0 ? FreeBodyPanel::Arrow::ends : FreeBodyPanel::Arrow::starts;
    if (force.kind == ActingForce::Kind::load || force.kind == ActingForce::Kind::weight)
      panel.load(side, P, there);
    else
      panel.force(side, P, there);
  }
  Place place_of_couple(const ActingCouple& couple, const LinkForces& body) const {
    if (couple.kind == ActingCouple::Kind::guide)
      return of_.through(built_.linkage.blocks[index(couple.which)].moving);
    const auto& points = built_.linkage.links[index(body.link)].points;
    if (couple.kind == ActingCouple::Kind::drive)
      for (const geometry::LinkPoint& p : points)
        if (built_.linkage.links_at(p.point).front() == 0) return of_.at(p.point);
    if (points.empty()) return of_.place(any_force(body));
    if (points.size() == 1) return of_.at(points[0].point);
    return of_.at(points[0].point) + 0.5 * (of_.at(points[1].point) - of_.at(points[0].point));
  }
  // Of the link from a couple's place.
  std::vector<double> directions(const LinkForces& body) const {
    if (body.link == nothing) return {};
    const auto& points = built_.linkage.links[index(body.link)].points;
    if (points.size() < 2) return {};
    const double along = epure::direction(of_.at(points[0].point), of_.at(points[1].point));
    return {along, along + std::numbers::pi};
  }

  static std::string turned_round(const std::string& arrow) {
    const std::string minus = "−";
    return arrow.starts_with(minus) ? arrow.substr(minus.size()) : minus + arrow;
  }
  void add_steps(FreeBodyPanel& panel, const LinkForces& body) const {
    for (const GroupForces::Strut& each : group_.struts)
      if (each.link == body.link)
        panel.step(format_words("Link {0} is loaded in its hinges only: its forces run along {1}{2}.",
                                "Il membro {0} è caricato solo nelle cerniere: le sue forze corrono lungo {1}{2}.",
                                of_.number(each.link), of_.letter(each.from), of_.letter(each.to)),
                   of_.at(each.from) + 0.5 * (of_.at(each.to) - of_.at(each.from)));
    for (const ActingForce& force : body.known)
      if (force.kind == ActingForce::Kind::inertia) panel.step(of_.inertia_in_words(force), of_.place(force));
    for (const GroupForces::Pressed& each : group_.pressed)
      if (each.force.link == body.link && each.force.kind != ActingForce::Kind::hinge)
        panel.step(format_words("There is no friction: {} is square to {}.", "Non c'è attrito: la {} è normale a {}.",
                                arrow_of_force(built_, each.force), of_.line(each.line)),
                   of_.place(each.force));
    for (const ForceLoop& loop : group_.loops)
      if (is_of_two(loop) && loop.left.front().force.link == body.link)
        panel.step(format_words("Two forces only: {} = {}.", "Due sole forze: {} = {}.",
                                arrow_of_force(built_, loop.left.front().force),
                                turned_round(arrow_of_force(built_, loop.right.front().force))),
                   of_.place(loop.left.front().force));
    for (const Moments& each : group_.moments) {
      if (each.link != body.link) continue;
      double out = 0;
      for (const Arm& arm : each.arms) draw_arm(panel, arm, each.about, body, out);
      if (const auto* arm = std::get_if<Arm>(&each.sought)) draw_arm(panel, *arm, each.about, body, out);
      panel.step(MomentsInWords(of_, built_, each).all(), of_.place(each.about));
    }
  }
  // One that runs along the link stands beside it, and each further one farther out.
  void draw_arm(FreeBodyPanel& panel, const Arm& arm, const About& about, const LinkForces& body, double& out) const {
    if (!of_.has_arm(arm)) return;
    constexpr double nearly = 0.25, apart = 8;  // radians, mm
    const Arrow2 across = geometry::quarter_turn(of_.vector(arm.force));
    double beside = 0;
    for (const double along : directions(body)) {
      const Arrow2 link{std::cos(along), std::sin(along)};
      if (std::abs(std::atan2(cross(link, across), dot(link, across))) < nearly) beside = out += apart;
    }
    panel.arm(of_.place(about), of_.place(arm.force), of_.vector(arm.force), arm.length.symbol, arm.length.name,
              beside);
  }

  ChainedPolygonsPanel polygon(const ForceLoop& loop) const {
    VectorPolygon drawn = of_.polygon(loop);
    std::vector<Arrow2> corners{{0, 0}};
    for (const PolygonSide& side : drawn.right) corners.push_back(corners.back() + side.v);
    for (const ForceLoop::Between& each : loop.between) {
      PolygonImage image{.absolute = {.v = corners[each.to]}};
      image.relative = of_.side(each.force);
      drawn.images.push_back(std::move(image));
    }
    ChainedPolygonsPanel panel(drawn);
    for (const ForceLoop::Between& each : loop.between) {
      constexpr double along = 0.65;  // clear of its letters
      const Arrow2 from = corners[each.from];
      const std::string label = arrow_of_force(built_, each.force);
      panel.step(
          each.is_sum
              ? format_words("{} is the sum of its two parts.", "La {} è la somma delle sue due componenti.", label)
              : format_words("{} closes the forces on link {}.", "La {} chiude le forze sul membro {}.", label,
                             of_.number(each.force.link)),
          from + along * (corners[each.to] - from));
    }
    return panel;
  }

  void add_results(PanelSheet& sheet, Shows shows) const {
    std::vector<std::string> arms, parts, scalars, told;
    std::vector<VectorQuantity> vectors;
    for (const Moments& each : group_.moments) {
      for (const Arm& arm : each.arms)
        if (of_.has_arm(arm)) arms.push_back(arm.length.name);
      if (const auto* arm = std::get_if<Arm>(&each.sought); arm && of_.has_arm(*arm))
        arms.push_back(arm->length.name);
      if (const auto* couple = std::get_if<ActingCouple>(&each.sought)) scalars.push_back(of_.quantity(*couple).name);
      if (const auto* of_rod = std::get_if<AcrossRod>(&each.sought))
        for (const ForcePart part : {ForcePart::across, ForcePart::along})
          if (shows == Shows::all || (shows == Shows::bodies) == (part == ForcePart::across))
            parts.push_back(part_of_force(built_, of_rod->force, part).name);
    }
    if (shows != Shows::polygons) add_inertia(vectors, scalars, told);
    if (shows != Shows::bodies) add_sought(vectors, scalars, told);
    if (shows != Shows::polygons) add_in_lines(sheet, arms, 3);
    add_in_lines(sheet, parts, 2);
    for (const VectorQuantity& each : vectors) sheet.results.push_back(components(each));
    add_in_lines(sheet, scalars, 2);
    for (const std::string& each : scalars)
      if (std::find(told.begin(), told.end(), each) == told.end()) told.push_back(each);
    sheet.told = told;
  }
  using Names = std::vector<std::string>;
  void add_inertia(std::vector<VectorQuantity>& vectors, Names& scalars, Names& told) const {
    for (const LinkForces& body : group_.bodies)
      for (const ActingForce& force : body.known)
        if (is_of_mass(force)) {
          vectors.push_back(mass_force(built_, force));
          told.push_back(vectors.back().name);
        }
    for (const LinkForces& body : group_.bodies)
      for (const ActingCouple& each : body.couples)
        if (each.kind == ActingCouple::Kind::inertia)
          scalars.push_back(inertia_couple(built_, index(each.which)).name);
  }
  void add_sought(std::vector<VectorQuantity>& vectors, Names& scalars, Names& told) const {
    for (const LinkForces& body : group_.bodies)
      for (const ActingForce& force : body.sought) {
        const std::string name = name_of_force(built_, force);
        if (std::find(told.begin(), told.end(), name) != told.end()) continue;
        told.push_back(name);
        if (force.kind == ActingForce::Kind::held)
          vectors.push_back(held_force(built_, force.which));
        else if (force.kind == ActingForce::Kind::hinge) {
          const auto hinge = JointForces<geometry::Fast>(built_.linkage).hinges[index(force.which)];
          vectors.push_back(hinge_force(built_, hinge.point, hinge.by, hinge.on).quantity);
        } else {
          scalars.insert(scalars.begin(), name);
        }
      }
  }

  const Built& built_;
  const Solution& s_;
  const GroupForces& group_;
  ForceFigures of_;
};

std::vector<std::string> numbers_of(const Built& built, const GroupForces& group) {
  std::vector<std::string> all;
  for (const LinkForces& body : group.bodies)
    if (body.link != nothing) all.push_back(std::to_string(built.letters.links[index(body.link)]));
  std::sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  return all;
}
// The pin of a group that places no link.
std::string pin_of(const Built& built, const GroupForces& group) {
  const LinkForces& body = group.bodies.front();
  return built.letters.points[index(body.known.front().point)];
}
Words forces_on(const Built& built, const GroupForces& group) {
  const std::vector<std::string> numbers = numbers_of(built, group);
  if (numbers.empty())
    return format_words("Forces on the pin {}", "Forze sul perno {}",
                        "$" + point_letters(pin_of(built, group)) + "$");
  return numbers.size() == 1 ? format_words("Forces on link {}", "Forze sul membro {}", numbers[0])
                             : format_words("Forces on links {}", "Forze sui membri {}", enumerated_links(numbers));
}

Words links_or_pin(const Built& built, const GroupForces& group) {
  const std::vector<std::string> numbers = numbers_of(built, group);
  if (numbers.empty()) {
    const std::string pin = "$" + point_letters(pin_of(built, group)) + "$";
    return format_words("the pin {}", "il perno {}", pin);
  }
  return numbers.size() == 1 ? format_words("link {}", "il membro {}", numbers[0])
                             : format_words("links {}", "i membri {}", enumerated_links(numbers));
}
// When a group is cut free, and why then.
Words turn_of(const Built& built, const std::vector<GroupForces>& groups, std::size_t i) {
  const Words group = links_or_pin(built, groups[i]);
  if (groups.size() == 1)
    return format_words("Cut free {}: only loads act there.", "Si isola {}: vi agiscono solo carichi.", group);
  if (i == 0)
    return format_words("First {}: only loads act there.", "Per prima cosa {}: lì agiscono solo carichi.", group);
  const Words then = i + 1 == groups.size() ? Words{"At last ", "Infine "} : Words{"Then ", "Poi "};
  return then + group +
         Words{": what the others exert there is known now.", ": ciò che gli altri vi esercitano ora è noto."};
}
// Clear of the link, and of what turns it.
void add_couple(FreeBodyPanel& whole, const Built& built, const ForceFigures& of, int link,
                const ActingCouple& couple) {
  const auto& points = built.linkage.links[index(link)].points;
  const Place O = of.at(points.front().point);
  std::vector<double> occupied;
  if (points.size() > 1) {
    const double along = direction(O, of.at(points[1].point));
    occupied = {along, along - std::numbers::pi / 3, along + std::numbers::pi / 3, -std::numbers::pi / 2};
  }
  whole.couple(of.quantity(couple).symbol, O, of.value(couple), occupied);
}

// The whole mechanism with its loads and what drives it, and in which order its links are cut free.
PanelSheet overview(const Built& built, const Solution& s) {
  const std::vector<GroupForces> groups = force_groups(built);
  const ForceFigures of(built, s);
  FreeBodyPanel whole(std::make_shared<const Mechanism>(figure_of(built, s)));
  whole.to_scale();
  for (std::size_t k = 0; k < built.loads->forces.size(); ++k) {
    const ActingForce load{ActingForce::Kind::load, static_cast<int>(k), built.loads->forces[k].link};
    whole.load(of.side(load), of.place(load));
  }
  for (std::size_t k = 0; k < built.loads->masses.size(); ++k)
    for (const auto kind : {ActingForce::Kind::weight, ActingForce::Kind::inertia}) {
      const ActingForce force{kind, static_cast<int>(k), built.loads->masses[k].link};
      if (kind == ActingForce::Kind::weight && built.gravity.empty()) continue;
      whole.force(of.side(force), of.place(force));
    }
  PanelSheet sheet;
  std::vector<std::string> efforts, reactions;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const GroupForces& group = groups[i];
    for (const LinkForces& body : group.bodies) {
      for (const ActingCouple& each : body.couples)
        if (each.kind != ActingCouple::Kind::guide) add_couple(whole, built, of, body.link, each);
      for (const ActingForce& force : body.sought) {
        const std::string name = name_of_force(built, force);
        if (force.kind == ActingForce::Kind::slid || force.kind == ActingForce::Kind::cylinder)
          whole.effort(of.side(force), of.place(force));
        else if (std::find(reactions.begin(), reactions.end(), name) == reactions.end())
          reactions.push_back(name);
      }
    }
    whole.step(turn_of(built, groups, i), of.place(group.bodies.front().sought.front()));
  }
  for (const geometry::Drive& drive : built.linkage.drives) efforts.push_back(driving_effort(built, drive).name);
  sheet.panels = panels(std::move(whole));
  for (const std::string& each : efforts) sheet.results.push_back(values({each}));
  add_in_lines(sheet, reactions, 3);
  sheet.seen = {"The mechanism with its loads and what drives it",
                "Il meccanismo con i suoi carichi e ciò che lo muove"};
  sheet.told = efforts;
  return sheet;
}

// Then its polygon has a sheet of its own.
bool is_crowded(const GroupForces& group) {
  constexpr std::size_t most = 4;
  std::size_t known = 0;
  for (const LinkForces& body : group.bodies) {
    known += body.known.size();
    for (const ActingCouple& each : body.couples)
      if (each.kind == ActingCouple::Kind::load || each.kind == ActingCouple::Kind::inertia) ++known;
  }
  return known > most;
}

}  // namespace

std::vector<SheetMaker> force_sheets(const std::shared_ptr<const Scene>& scene) {
  const Built stated = scene->built(Givens(scene->givens()));
  const std::vector<GroupForces> groups = force_groups(stated);
  std::vector<SheetMaker> sheets;
  if (groups.empty()) return sheets;
  sheets.push_back({{"forces", {"Forces", "Forze"}},
                    [scene](const Solution& s, Language) { return overview(scene->built(s.givens()), s); }});
  using Shows = GroupSheet::Shows;
  const auto add = [&](const std::string& name, const Words& title, std::size_t i, Shows shows) {
    sheets.push_back({{name, title}, [scene, i, shows](const Solution& s, Language) {
                        const Built built = scene->built(s.givens());
                        return GroupSheet(built, s, force_groups(built).at(i)).sheet(shows);
                      }});
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::string name = "forces";
    const std::vector<std::string> numbers = numbers_of(stated, groups[i]);
    if (numbers.empty()) name += "-" + pin_of(stated, groups[i]);
    for (const std::string& number : numbers) name += "-" + number;
    const Words title = forces_on(stated, groups[i]);
    if (!is_crowded(groups[i])) {
      add(name, title, i, Shows::all);
      continue;
    }
    add(name, title, i, Shows::bodies);
    add(name + "-polygon", title + Words{": polygon", ": poligono"}, i, Shows::polygons);
  }
  return sheets;
}

}  // namespace epure::scenes
