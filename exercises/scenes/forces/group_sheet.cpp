#include "exercises/scenes/forces/group_sheet.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/scenes/forces/moments_in_words.h"
#include "exercises/scenes/forces/signs_in_words.h"
#include "exercises/scenes/sheets/in_lines.h"

namespace epure::scenes {
namespace {

using geometry::nothing;

// A group's links cut free, and the polygons of their forces.
class GroupSheet {
 public:
  GroupSheet(const Built& built, const Solution& s, const GroupForces& group)
      : built_(built), s_(s), group_(group), of_(built, s) {}

  PanelSheet sheet(Shows shows, Language language) const {
    PanelSheet sheet;
    if (shows != Shows::polygons)
      for (const LinkForces& body : group_.bodies) {
        add(sheet, cut_free(body));
        for (const ActingCouple& each : body.couples)
          if (is_told_of(each, body)) add(sheet, hinge_with_friction(each, body));
      }
    if (shows != Shows::bodies)
      for (const ForceLoop& loop : group_.loops)
        if (!is_of_two(loop)) add(sheet, polygon(loop));
    add_results(sheet, shows);
    add_signs(sheet, shows, language);
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
    constexpr double of_reach = 1.0 / 20;
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
    const Place middle = middle_of(*drawn);
    for (const auto* forces : {&body.known, &body.sought})
      for (const ActingForce& force : *forces) draw(panel, force, middle);
    for (const ActingCouple& each : body.couples)
      panel.couple(of_.label(each), place_of_couple(each, body), of_.value(each),
                   clear_of_link_and_arms(place_of_couple(each, body), body));
    for (const ActingForce& tooth : group_.teeth)
      if (tooth.link == body.link) add_line_of_action(panel, tooth);
    add_steps(panel, body);
    return panel;
  }
  // A couple of friction in a hinge, where its body is the first that has it.
  bool is_told_of(const ActingCouple& couple, const LinkForces& body) const {
    const auto has_it = [&](const LinkForces& each) {
      return std::any_of(each.couples.begin(), each.couples.end(), [&](const ActingCouple& other) {
        return other.kind == couple.kind && other.which == couple.which;
      });
    };
    return couple.kind == ActingCouple::Kind::hinge &&
           &*std::find_if(group_.bodies.begin(), group_.bodies.end(), has_it) == &body;
  }
  // The hinge with its friction circle: force and couple together are the force along a line that touches it.
  FreeBodyPanel hinge_with_friction(const ActingCouple& couple, const LinkForces& body) const {
    constexpr double at_most = 2000;  // mm a metre
    const int point = hinge_of(built_.linkage, couple).point;
    const Place A = of_.at(point);
    Mechanism pin;
    pin.point("pin", A, Mechanism::Joint::none, of_.letter(point));
    FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(pin)));
    panel.at_most(at_most);
    for (const auto* forces : {&body.known, &body.sought})
      for (const ActingForce& force : *forces) {
        const Arrow2 v = of_.vector(force);
        if (force.kind != ActingForce::Kind::hinge || force.point != point || magnitude(v) == 0) continue;
        const Place T = A + (-of_.value(couple) / dot(v, v)) * geometry::quarter_turn(v);
        PolygonSide side = of_.side(force);
        side.quantity.clear();
        panel.force(side, T).friction_circle(A, T,
                                             "$ρ_{" + point_letters(built_.letters.points[index(point)]) + "}$");
      }
    return panel;
  }
  void draw(FreeBodyPanel& panel, const ActingForce& force, const Place& middle) const {
    // Whoever is to solve the sheet is asked for weights.
    const bool is_load = force.kind == ActingForce::Kind::load;
    (panel.*(is_load ? &FreeBodyPanel::load : &FreeBodyPanel::force))(
        of_.side(force), of_.place(force),
        is_of_mass(force) ? FreeBodyPanel::Arrow::starts : of_.there(force, middle));
  }
  void add_line_of_action(FreeBodyPanel& panel, const ActingForce& tooth) const {
    const Arrow2 v = of_.vector(tooth), t = of_.tangent(tooth);
    if (magnitude(v) == 0 || of_.turned_by_teeth(tooth) == 0) return;
    const double out = of_.there(tooth, of_.at(wheel_centre(tooth))) == FreeBodyPanel::Arrow::ends ? -1 : 1;
    panel.turned(of_.place(tooth), std::atan2(out * t.y, out * t.x), std::atan2(out * v.y, out * v.x),
                 of_.pressure_angle(tooth), {}, false);
  }
  int wheel_centre(const ActingForce& tooth) const {
    return built_.linkage.hinge_of(tooth.link, built_.linkage.gears[index(tooth.which)].carrier);
  }
  static JointForces<geometry::Fast>::Hinge hinge_of(const geometry::Linkage& linkage, const ActingCouple& couple) {
    return JointForces<geometry::Fast>(linkage).hinges[index(couple.which)];
  }
  Place place_of_couple(const ActingCouple& couple, const LinkForces& body) const {
    return of_.place(couple, body.link, of_.place(any_force(body)));
  }
  // Of the link from a couple's place.
  std::vector<double> directions(const LinkForces& body) const {
    return body.link == nothing ? std::vector<double>{} : of_.directions(body.link);
  }

  std::vector<double> clear_of_link_and_arms(const Place& couple, const LinkForces& body) const {
    std::vector<double> all = directions(body);
    for (const Moments& each : group_.moments)
      for (const Arm& arm : each.arms) {
        if (each.link != body.link || !of_.has_arm(arm)) continue;
        const Place middle = of_.place(each.about) + 0.5 * to_foot(arm, each.about);
        if (distance(couple, middle) > 0) all.push_back(epure::direction(couple, middle));
      }
    return all;
  }

  Words friction_in(const ActingCouple& couple, int point) const {
    const auto& all = built_.loads->hinge_frictions;
    const auto of = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.point == point; });
    const std::string rho = "$ρ_{" + point_letters(built_.letters.points[index(point)]) + "}$";
    const Words& given = built_.hinge_friction_names[static_cast<std::size_t>(of - all.begin())].amount;
    const Words radius = given.english == rho ? given : format_words("{} = {}", "{} = {}", rho, given);
    const std::string M = of_.symbol(couple), ij = M.substr(M.find('_'));
    return format_words(
        "Friction in {0}, radius of its circle {1}: |{2}| = {3}·$\\it{{R}}{4}, against the turning; so the force "
        "touches the circle.",
        "Attrito in {0}, raggio del suo cerchio {1}: |{2}| = {3}·$\\it{{R}}{4}, contro la rotazione; perciò la forza "
        "è tangente al cerchio.",
        of_.letter(point), radius, M, rho, ij);
  }
  Words pressed(const GroupForces::Pressed& each) const {
    const auto* friction = friction_of(built_, each.force);
    const double holds_back = friction ? s_[friction_force(built_, *friction).name] : 0;
    if (friction && s_[contact(built_, *friction).normal.name] == 0)
      return format_words("Nothing presses on {0}, and so there is no friction.",
                          "Nulla preme su {0}, e quindi non c'è attrito.", of_.line(each.line));
    if (holds_back == 0 && each.force.is_opposite) {
      ActingForce reported = each.force;
      reported.is_opposite = false;
      return format_words("There is no friction: {0} is square to {1}. Here acts its opposite, {2}.",
                          "Non c'è attrito: la {0} è normale a {1}. Qui agisce la sua opposta, {2}.",
                          arrow_of_force(built_, reported), of_.line(each.line), arrow_of_force(built_, each.force));
    }
    if (holds_back == 0)
      return format_words("There is no friction: {} is square to {}.", "Non c'è attrito: la {} è normale a {}.",
                          arrow_of_force(built_, each.force), of_.line(each.line));
    const Contact at = contact(built_, *friction);
    const FrictionName& name =
        built_.friction_names[static_cast<std::size_t>(friction - built_.loads->frictions.data())];
    const std::string phi = friction_angle(built_, *friction);
    const bool is_angle = std::holds_alternative<geometry::Angle>(friction->amount);
    const Words angle = format_words("{}{} = {}", "{}{} = {}", is_angle ? "" : "tan ", phi, name.amount);
    const std::string line = "$" + point_letters(at.line) + "$";
    const bool is_of_block = each.force.kind == ActingForce::Kind::guide;
    const std::string slides = "$" + point_letters(at.slides) + "$", number = of_.number(each.force.link);
    const bool is_on_block = is_of_block && !each.force.is_opposite;
    const Words what = is_on_block ? Words{"link " + number, "il membro " + number} : Words{slides, slides};
    ActingForce on_what_slides = each.force;
    on_what_slides.is_opposite = false;
    const Words turned = format_words(
        "Friction, {0}: {1} slides {2} on {3}, and the force on it, {4}, is turned from the normal to {3} by {5} "
        "against that.",
        "Attrito, {0}: {1} scorre {2} su {3}, e la forza su di esso, {4}, è inclinata di {5} sulla normale a {3}, "
        "contro lo strisciamento.",
        angle, what, holds_back < 0 ? Words{"ahead", "in avanti"} : Words{"back", "all'indietro"}, line,
        arrow_of_force(built_, on_what_slides), phi);
    const Words opposite =
        each.force.is_opposite ? Words{" Here acts its opposite.", " Qui agisce la sua opposta."} : Words{};
    if (!is_of_block || s_[guide_forces(built_, index(each.force.which)).couple.name] == 0) return turned + opposite;
    return turned + opposite +
           format_words(" (The couple {} is taken without friction.)", " (La coppia {} si considera senza attrito.)",
                        guide_forces(built_, index(each.force.which)).couple.symbol);
  }
  Words action(const ActingForce& tooth) const {
    const auto k = index(tooth.which);
    const TwoLinks links = links_of(built_.linkage, tooth);
    const bool is_inside = built_.linkage.gears[k].is_inside;
    if (magnitude(of_.vector(tooth)) == 0)
      return format_words("Nothing presses the teeth of links {} and {} on each other.",
                          "Nulla preme l'uno sull'altro i denti dei membri {} e {}.",
                          of_.number(links.other(tooth.link)), of_.number(tooth.link));
    const std::string alpha = of_.pressure_angle(tooth);
    const Words& given = built_.pressure_angles[k];
    return format_words(
        "Along the line of action through the pitch point, at {} to the common tangent: {}, which presses the tooth "
        "{}.",
        "Lungo la retta d'azione per il centro d'ingranamento, a {} dalla tangente comune: {}, che preme il dente "
        "{}.",
        given.english == alpha ? given : format_words("{} = {}", "{} = {}", alpha, given),
        arrow_of_force(built_, tooth),
        is_inside && is_ring(k, tooth.link)
            ? Words{"outwards, as link " + of_.number(tooth.link) + " is a ring",
                    "verso l'esterno, poiché il membro " + of_.number(tooth.link) + " è una corona"}
            : Words{"towards the wheel's centre", "verso il centro della ruota"});
  }
  bool is_ring(std::size_t gear, int wheel) const {
    const geometry::MeshingLinks& of = built_.linkage.gears[gear];
    return (of.first_teeth > of.second_teeth) == (wheel == of.first);
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
        panel.step(pressed(each), of_.place(each.force));
    for (const ActingForce& tooth : group_.teeth)
      if (tooth.link == body.link) panel.step(action(tooth), of_.place(tooth));
    for (const ForceLoop& loop : group_.loops)
      if (is_of_two(loop) && loop.left.front().force.link == body.link)
        panel.step(format_words("Two forces only: {} = {}.", "Due sole forze: {} = {}.",
                                arrow_of_force(built_, loop.left.front().force),
                                turned_round(arrow_of_force(built_, loop.right.front().force))),
                   of_.place(loop.left.front().force));
    for (const ActingCouple& each : body.couples)
      if (is_told_of(each, body)) {
        const int point = hinge_of(built_.linkage, each).point;
        panel.step_at_couple(friction_in(each, point), of_.at(point), of_.label(each));
      }
    for (const Moments& each : group_.moments) {
      if (each.link != body.link) continue;
      double out = 0;
      for (const Arm& arm : each.arms) draw_arm(panel, arm, each.about, body, out);
      if (const auto* arm = std::get_if<Arm>(&each.sought)) draw_arm(panel, *arm, each.about, body, out);
      panel.step(MomentsInWords(of_, built_, each).all(), of_.place(each.about));
    }
  }
  // From a point to the line of a force.
  Arrow2 to_foot(const Arm& arm, const About& about) const {
    const Arrow2 v = of_.vector(arm.force), from_force = of_.place(about) - of_.place(arm.force);
    return (dot(from_force, v) / dot(v, v)) * v - from_force;
  }
  // One that runs along the link stands beside it, on the side to which it leans, and each further one farther out.
  void draw_arm(FreeBodyPanel& panel, const Arm& arm, const About& about, const LinkForces& body, double& out) const {
    if (!of_.has_arm(arm)) return;
    constexpr double nearly = 0.25, apart = 8;  // radians, mm
    const Arrow2 across = to_foot(arm, about);
    double beside = 0;
    for (const double along : directions(body)) {
      const Arrow2 link{std::cos(along), std::sin(along)};
      const double leans = std::atan2(cross(link, across), dot(link, across));
      if (std::abs(leans) >= nearly) continue;
      out += apart;
      beside = leans < 0 ? -out : out;
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
      constexpr double along = 0.8;  // clear of its letters, and of the numbers of the sides
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
    std::vector<Result> of_hinges;
    if (shows != Shows::polygons) {
      add_inertia(vectors, scalars, told);
      of_hinges = couples_of_hinges(told);
    }
    if (shows != Shows::bodies) add_sought(vectors, scalars, told);
    if (shows != Shows::polygons) add_in_lines(sheet, arms, 3);
    add_in_lines(sheet, parts, 2);
    for (const VectorQuantity& each : vectors) sheet.results.push_back(components(each));
    add_in_lines(sheet, scalars, 2);
    for (Result& each : of_hinges) sheet.results.push_back(std::move(each));
    for (const std::string& each : scalars)
      if (std::find(told.begin(), told.end(), each) == told.end()) told.push_back(each);
    sheet.told = told;
  }
  // The sense of a part that moments give, where no polygon shows it.
  Words turns(const Moments& each) const {
    const auto* of_rod = std::get_if<AcrossRod>(&each.sought);
    if (!of_rod) return {};
    const double moment =
        cross(of_.at(of_rod->pin) - of_.place(each.about), of_.side(of_rod->force, ForcePart::across).v);
    if (moment == 0) return {};
    return format_words("{} acts {} about {}.", "La {} agisce in senso {} attorno a {}.",
                        letters_of_force(built_, of_rod->force, ForcePart::across),
                        moment > 0 ? Words{"counter-clockwise", "antiorario"} : Words{"clockwise", "orario"},
                        of_.about_in_words(each.about));
  }
  void add_signs(PanelSheet& sheet, Shows shows, Language language) const {
    if (shows == Shows::bodies)
      for (const Moments& each : group_.moments) sheet.results.push_back(remark(turns(each).in(language)));
    SignsInWords signs(of_, built_);
    for (const LinkForces& body : group_.bodies) {
      for (const ActingForce& force : body.known) signs.add(force);
      if (shows != Shows::bodies)
        for (const ActingForce& force : body.sought) signs.add(force);
      if (shows != Shows::polygons &&
          std::any_of(body.couples.begin(), body.couples.end(),
                      [](const ActingCouple& each) { return each.kind != ActingCouple::Kind::load; }))
        signs.add_couples();
    }
    for (const Moments& each : group_.moments)
      if (std::holds_alternative<ActingCouple>(each.sought)) signs.add_couples();
    if (const Words all = signs.all(); !all.empty()) sheet.results.push_back(remark(all.in(language)));
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
  // Of friction: "M_34 = −M_43" where the opposite of what is reported is on the sheet.
  std::vector<Result> couples_of_hinges(Names& told) const {
    std::vector<Result> all;
    Names names;
    const auto add = [&](bool with_opposite) {
      for (const LinkForces& body : group_.bodies)
        for (const ActingCouple& each : body.couples) {
          const Quantity M = of_.quantity(each);
          if (each.kind != ActingCouple::Kind::hinge || each.is_opposite != with_opposite ||
              std::find(told.begin(), told.end(), M.name) != told.end())
            continue;
          told.push_back(M.name);
          if (with_opposite)
            all.push_back(value_as(M.symbol + " = −" + of_.symbol(each), M.name));
          else
            names.push_back(M.name);
        }
    };
    add(true);
    add(false);
    if (!names.empty()) all.push_back(values(names));
    return all;
  }
  void add_sought(std::vector<VectorQuantity>& vectors, Names& scalars, Names& told) const {
    for (const LinkForces& body : group_.bodies)
      for (const ActingForce& force : body.sought) {
        const std::string name = name_of_force(built_, force);
        if (std::find(told.begin(), told.end(), name) != told.end()) continue;
        told.push_back(name);
        if (force.kind == ActingForce::Kind::held)
          vectors.push_back(held_force(built_, force.which));
        else if (is_of_links(force)) {
          vectors.push_back(force_of_two(built_, force));
          if (force.kind == ActingForce::Kind::tooth) {
            const TeethParts parts = parts_of_tooth_force(built_, index(force.which));
            scalars.insert(scalars.begin(), {parts.tangential.name, parts.radial.name});
          }
        } else {
          scalars.insert(scalars.begin(), name);
          if (const auto* friction = friction_of(built_, force)) {
            scalars.insert(scalars.begin() + 1,
                           {contact(built_, *friction).normal.name, friction_force(built_, *friction).name});
          }
        }
      }
  }

  const Built& built_;
  const Solution& s_;
  const GroupForces& group_;
  ForceFigures of_;
};

}  // namespace

PanelSheet group_sheet(const Built& built, const Solution& s, const GroupForces& group, Shows shows,
                       Language language) {
  return GroupSheet(built, s, group).sheet(shows, language);
}

Words enumerated_links(const std::vector<std::string>& numbers) {
  Words all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) all = all + (i + 1 == numbers.size() ? Words{" and ", " e "} : Words{", ", ", "});
    all = all + Words{numbers[i], numbers[i]};
  }
  return all;
}

}  // namespace epure::scenes
