// The sheets: bodies cut free in the direct motion with their friction cones, the polygons of both motions over those
// without friction, the details of the pins, and the efficiencies over the friction angle.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "exercises/friction-efficiency/exercise.h"
#include "exercises/friction-efficiency/motion.h"
#include "exercises/kit/linkages/loaded_figures.h"
#include "exercises/kit/linkages/shared_out.h"
#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/mechanism_panel.h"

namespace epure::friction_efficiency {
namespace {

using namespace loaded;
using Arrow = FreeBodyPanel::Arrow;
using Joint = Mechanism::Joint;

const std::string direct = "_direct", retrograde = "_retrograde";

VectorQuantity moving(const VectorQuantity& quantity, const std::string& suffix) {
  return in(suffix == direct ? Motion::direct : Motion::retrograde, quantity);
}
VectorQuantity P_of(const std::string& suffix) { return moving(applied_force("P", {}), suffix); }
// What body i does to body j, known from the polygon before: the same force the other way, or passed on by a link.
PolygonSide passed_on(const PolygonSide& force, const VectorQuantity& known, int i, int j, const std::string& suffix,
                      const std::string& tip = {}) {
  PolygonSide side = reaction(force, moving(force_between(i, j), suffix).arrow(), known.length().symbol);
  side.tip = tip;
  return side;
}

// "φ from r₂": turned by the friction angle.
std::string turned_from(const std::string& normal, Language language) {
  return "$φ$ " + Words{"from ", "da "}.in(language) + normal;
}

// A contact's force that presses on a body in X from outside: its angle with the normal, which stands on the same
// side. `v` is the sliding of body j on body i, "ji", against which the force is turned.
void press(FreeBodyPanel& panel, const Case& of, const PolygonSide& R, const Place& X, double normal, const Arrow2& v,
           const std::string& ji) {
  panel.force(R, X, Arrow::ends);
  if (is_zero(of.s.givens().angle("phi")) || magnitude(R.v) == 0) return;
  const double force = std::atan2(-R.v.y, -R.v.x);
  panel.turned(X, force - std::remainder(force - normal, std::numbers::pi), force, "$φ$");
  panel.sliding(X, v, -R.v, "$\\vec{v}_{" + ji + "}$");
}

const Words the_other_way{"Retrograde motion: the same polygons with the forces turned the other way.",
                          "Moto retrogrado: gli stessi poligoni con le forze ruotate dall'altra parte."};
// The same where lines of action are to be found anew.
Words other_lines(const std::string& english, const std::string& italian) {
  return {"Retrograde motion: forces turned the other way, dashed on the bodies, with " + english + ".",
          "Moto retrogrado: forze ruotate dall'altra parte, a tratti sui corpi, con " + italian + "."};
}
// What the retrograde motion has in place of something.
std::string prime(const std::string& suffix) { return suffix == retrograde ? "'" : ""; }

// Where the polygon of a body begins.
std::string origin(const std::string& body, const std::string& suffix) {
  return "$O" + prime(suffix) + "_{" + body + "}$";
}

// A chain of vectors from the origin on, for what lies under a polygon.
std::vector<Arrow2> laid_end_to_end(const std::vector<Arrow2>& vectors) {
  std::vector<Arrow2> corners{{0, 0}};
  for (const Arrow2& v : vectors) corners.push_back(corners.back() + v);
  return corners;
}

// Two bodies in one chain: the load Q, the contact's force, the reaction on the loaded body; back the contact's
// force, the effort, the reaction on the driven one.
struct Chain {
  std::string loaded, driven;                    // letters of the bodies
  VectorQuantity contact, on_loaded, on_driven;  // R_ij
  int passed_by;  // the body that acts on the driven one by the contact's force turned round
  std::string along_Q, along_contact, along_loaded, along_driven, along_P;
  Words other_way = the_other_way;
};
struct Sides {
  PolygonSide Q, contact, on_loaded, back, P, on_driven;

  VectorPolygon first(const Chain& chain) const { return force_polygon(chain.loaded, {on_loaded}, {Q, contact}); }
  VectorPolygon second(const Chain& chain) const {
    VectorPolygon polygon = force_polygon(chain.driven, {on_driven}, {back, P});
    polygon.origin = "$b$";
    return polygon;
  }
};
Sides sides(const Case& of, const Chain& chain, const std::string& suffix) {
  const PolygonSide contact = of.sought(moving(chain.contact, suffix), chain.along_contact, "$b$");
  return {of.load("Q", chain.along_Q, "$a$"),
          contact,
          of.sought(moving(chain.on_loaded, suffix), chain.along_loaded),
          passed_on(contact, chain.contact, chain.passed_by, std::stoi(chain.driven), suffix, "$a$"),
          of.sought(P_of(suffix), chain.along_P, "$c$"),
          of.sought(moving(chain.on_driven, suffix), chain.along_driven)};
}
ChainedPolygonsPanel polygons(const Case& of, const Chain& chain, const std::string& suffix) {
  const Sides on = sides(of, chain, suffix);
  const PolygonSide& Q = on.Q;
  VectorPolygon first = on.first(chain);
  first.origin = origin(chain.loaded, suffix);
  ChainedPolygonsPanel panel(std::move(first));
  panel.then(on.second(chain), Q.v + on.contact.v);
  const Arrow2 ideal_contact = of.vector(chain.contact.name + "_ideal"), b = Q.v + ideal_contact;
  panel.over(laid_end_to_end({Q.v, ideal_contact, of.vector(chain.on_loaded.name + "_ideal")}));
  panel.over({b, b - ideal_contact, b - ideal_contact + of.vector("P_ideal"), b});
  if (suffix == retrograde) panel.likewise(chain.other_way, Q.v);
  return panel;
}

// What the sign of the effort in the retrograde motion says: it holds the load back, or the load alone does not drive
// the mechanism back.
Result what_its_sign_says(const Case& of, const std::string& effort, Language language) {
  const auto retrograde_effort = of.s.value(of.name(effort + retrograde)), ideal = of.s.value(of.name(effort + "_i"));
  if (!retrograde_effort || !ideal || *ideal <= 0) return remark("");
  const std::string letter = "$\\it{" + effort + "}$", primed = "$\\it{" + effort + "}'$";
  const Words holds =
                  format_words(" > 0: like {} it holds the load back.", " > 0: come {} trattiene il carico.", letter),
              at_limit{" = 0: exactly at the limit of self-locking.",
                       " = 0: esattamente al limite dell'arresto spontaneo."},
              pushes = format_words(
                  " < 0: self-locking. The load alone does not drive it back: {} must push the "
                  "other way.",
                  " < 0: arresto spontaneo. Il carico da solo non lo fa tornare indietro: {} deve "
                  "spingere nel verso opposto.",
                  primed);
  const Words& says = *retrograde_effort > 0 ? holds : *retrograde_effort == 0 ? at_limit : pushes;
  return remark(primed + says.in(language));
}

std::vector<Result> efficiencies(const Case& of, const std::string& effort, Language language) {
  return {of.results({effort + "_i"}), of.results({effort + direct, effort + retrograde}),
          of.results({"eta_direct", "eta_retrograde"}),
          remark("$η_{D}$ = $\\it{" + effort + "}_{i}$/$\\it{" + effort + "}$, $η_{R}$ = $\\it{" + effort +
                 "}'$/$\\it{" + effort + "}_{i}$"),
          what_its_sign_says(of, effort, language)};
}
const Words turned_against{
    "Body $j$ slides on $i$ as $\\vec{v}_{ji}$ shows; the force on it is turned by $φ$ against that. Dashed "
    "polygons: without friction.",
    "Il corpo $j$ striscia su $i$ come mostra $\\vec{v}_{ji}$; la forza su di esso è ruotata di $φ$ in verso "
    "contrario. Poligoni a tratti: senza attrito."};

PanelSheet wedge(const Solution& s, Language language) {
  const Case of(s, "wedge_collar");
  const WedgeFigure at(of);
  const double normal = std::numbers::pi / 2 - of.radians("theta");
  const Chain chain{"3",
                    "2",
                    force_between(2, 3),
                    force_between(1, 3),
                    force_between(1, 2),
                    3,
                    "∥ $r_{1}$",
                    turned_from("$r_{2}$", language),
                    turned_from("$x$", language),
                    turned_from("⊥ $x$", language),
                    "∥ $x$"};
  Mechanism rod, block;
  rod.point("O", {0, 0}, Joint::none, "$O$");
  add_rod(rod, at);
  block.point("O", {0, 0}, Joint::none, "$O$");
  add_wedge(block, at);
  FreeBodyPanel on_rod(std::make_shared<const Mechanism>(std::move(rod))),
      on_wedge(std::make_shared<const Mechanism>(std::move(block)));
  const PolygonSide Q = of.load("Q", "", ""), R_23 = of.known(moving(chain.contact, direct), "", ""),
                    R_32 = reversed(R_23, 3, 2), R_12 = of.known(moving(chain.on_driven, direct), "", ""),
                    P = of.known(P_of(direct), "", "");
  on_rod.to_scale().at_most(200).load(Q, {0, at.top}, Arrow::ends);
  const Arrow2 v_32 = of.vector("v_32"), v_31 = of.vector("v_31"), v_21 = of.vector("v_21");
  press(on_rod, of, R_23, {0, 0}, normal, v_32, "32");
  press(on_rod, of, of.known(moving(chain.on_loaded, direct), "", ""), {0, 0}, 0, v_31, "31");
  on_rod.step(turned_against, {0, 0});
  // Where R_32 and P meet, from the triangle of directions.
  const Place H{R_32.v.y == 0 ? 0 : at.line_of_P * R_32.v.x / R_32.v.y, at.line_of_P};
  const Place foot{H.x + (at.floor - H.y) * R_12.v.x / R_12.v.y, at.floor};
  on_wedge.to_scale().at_most(200).effort(P, {at.left.x, at.line_of_P}, Arrow::ends);
  press(on_wedge, of, R_32, {0, 0}, normal, -v_32, "23");
  press(on_wedge, of, R_12, foot, -std::numbers::pi / 2, v_21, "21");
  on_wedge.meeting("", "$\\it{H}_{2}$", H);
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"}));
  return {.panels = panels(on_rod, on_wedge, polygons(of, chain, direct), polygons(of, chain, retrograde)),
          .results = results,
          .seen = {"Wedge and rod cut free with their friction cones, and the polygons of the direct and of the "
                   "retrograde motion",
                   "Cuneo e asta isolati con i coni d'attrito, e i poligoni del moto diretto e del retrogrado"},
          .told = of.names({"P_i", "P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
          .without_part = of.without({}, {"phi"})};
}

PanelSheet two_forces(const Solution& s, Language language) {
  const Case of(s, "wedge_collar_two_point", "wedge_collar");
  const WedgeFigure at(of);
  const VectorQuantity upper = force_between(1, 3, "upper", "^{{u}}"), lower = force_between(1, 3, "lower", "^{{l}}");
  Mechanism rod;
  rod.point("O", {0, 0}, Joint::none, "$O$");
  add_rod(rod, at);
  FreeBodyPanel on_rod(std::make_shared<const Mechanism>(std::move(rod)));
  const auto K = of.point("K_direct");  // without friction at infinity
  std::optional<SharedOut> shared;
  const auto R = [](const VectorQuantity& force) { return moving(force, direct).arrow(); };
  const std::string on_rod_sum =
                        "$\\vec{\\it{Q}}$ + " + R(force_between(2, 3)) + " + " + R(force_between(1, 3)) + " = 0: ",
                    split = R(force_between(1, 3)) + " = " + R(upper) + " + " + R(lower) + ": ",
                    on_wedge_sum = "−" + R(force_between(2, 3)) + " + " + P_of(direct).arrow() + " + " +
                                   R(force_between(1, 2)) + " = 0: ";
  const std::array<Words, 3> three_polygons{
      Words{on_rod_sum + "$φ$ from $r_{2}$ through $a$, ∥ $OK$ through $O_{3}$, to $b$.",
            on_rod_sum + "$φ$ da $r_{2}$ per $a$, ∥ $OK$ per $O_{3}$, fino a $b$."},
      Words{split + "$φ$ from $x$ through $O_{3}$ and $b$, to $d$.",
            split + "$φ$ da $x$ per $O_{3}$ e $b$, fino a $d$."},
      Words{on_wedge_sum + "∥ $x$ through $a$, $φ$ from ⊥ $x$ through $b$, to $c$.",
            on_wedge_sum + "∥ $x$ per $a$, $φ$ da ⊥ $x$ per $b$, fino a $c$."}};
  const auto polygon = [&](const std::string& suffix) {
    const PolygonSide Q = of.load("Q", "∥ $r_{1}$", "$a$"),
                      R_23 = of.sought(moving(force_between(2, 3), suffix), turned_from("$r_{2}$", language), "$b$"),
                      first = of.sought(moving(upper, suffix), turned_from("$x$", language)),
                      second = of.sought(moving(lower, suffix), turned_from("$x$", language), "$d$");
    PolygonSide sum = of.sought(moving(upper, suffix), K ? "∥ $OK" + prime(suffix) + "$" : "∥ $x$");
    sum.quantity.clear();
    sum.label = moving(force_between(1, 3), suffix).arrow();
    sum.length.reset();
    sum.v = first.v + second.v;
    VectorPolygon of_rod = force_polygon("3", {sum}, {Q, R_23});
    of_rod.origin = origin("3", suffix);
    ChainedPolygonsPanel panel(std::move(of_rod));
    PolygonSide minus = reaction(sum, "−" + sum.label, "$\\it{R}_{13}$");
    minus.tip = "$b$";
    if (K) panel.then(force_polygon("3", {first}, {minus, second}), {0, 0});
    if (!K && suffix == direct) {
      shared.emplace(minus, Place{0, 0}, first, Place{-at.w / 2, at.upper}, second, Place{at.w / 2, at.lower});
    }
    VectorPolygon of_wedge = force_polygon(
        "2", {of.sought(moving(force_between(1, 2), suffix), turned_from("⊥ $x$", language))},
        {passed_on(R_23, force_between(2, 3), 3, 2, suffix, "$a$"), of.sought(P_of(suffix), "∥ $x$", "$c$")});
    of_wedge.origin = "$b$";
    panel.then(of_wedge, Q.v + R_23.v);
    const Arrow2 contact = of.vector("R_23_ideal");
    panel.over(laid_end_to_end({Q.v, contact, of.vector("R_13_lower_ideal"), of.vector("R_13_upper_ideal")}));
    if (K && suffix == direct)  // three polygons, told in a step each
      panel.likewise(three_polygons[0], Q.v + 0.5 * R_23.v)
          .step(three_polygons[1], -0.5 * first.v)
          .step(three_polygons[2], Q.v + 0.5 * of_wedge.right.back().v);
    if (suffix == retrograde) panel.likewise(other_lines("$K'$ and $OK'$", "$K'$ e $OK'$"), Q.v);
    return panel;
  };
  on_rod.to_scale().load(of.load("Q", "", ""), {0, at.top}, Arrow::ends);
  press(on_rod, of, of.known(moving(force_between(2, 3), direct), "", ""), {0, 0},
        std::numbers::pi / 2 - of.radians("theta"), of.vector("v_32"), "32");
  const Arrow2 v_31 = of.vector("v_31");
  press(on_rod, of, of.known(moving(upper, direct), "", ""), {-at.w / 2, at.upper}, 0, v_31, "31");
  press(on_rod, of, of.known(moving(lower, direct), "", ""), {at.w / 2, at.lower}, 0, v_31, "31");
  on_rod.step(turned_against, {-at.w / 2, at.upper});
  on_rod.meeting(of.name("K_direct"), "$K$", K);
  Panels all = panels(polygon(direct), polygon(retrograde));
  if (shared) {
    shared->draw_strings(on_rod);
    all.insert(all.begin() + 1,
               std::make_unique<SharedLoadPanel>(shared->polygon(moving(force_between(1, 3), direct).arrow())));
  }
  if (K) on_rod.line_to({0, 0}, *K, "$OK$");
  if (const auto other = of.point("K_retrograde"))
    on_rod.otherwise(of.name("K_retrograde"), "$K'$", other,
                     {{{-at.w / 2, at.upper}, of.vector("R_13_upper_retrograde")},
                      {{at.w / 2, at.lower}, of.vector("R_13_lower_retrograde")},
                      {{0, 0}, Place{0, 0} - *other}});
  if (K)
    on_rod.step(
        {"The collar's forces meet in $K$, $\\vec{\\it{Q}}$ and $\\vec{\\it{R}}_{23}$ in $O$: the collar's two "
         "together run along $OK$, Culmann's line.",
         "Le forze del collare si incontrano in $K$, $\\vec{\\it{Q}}$ e $\\vec{\\it{R}}_{23}$ in $O$: le due del "
         "collare insieme corrono lungo $OK$, la retta di Culmann."},
        {0, 0});
  all.insert(all.begin(), std::make_unique<FreeBodyPanel>(std::move(on_rod)));
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"K_direct_x", "K_direct_y", "culmann_angle_direct_deg"}));
  results.push_back(of.results({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"}));
  return {.panels = std::move(all),
          .results = results,
          .seen = {"The rod with the two forces of its collar and Culmann's line, and the polygons of the direct and "
                   "of the retrograde motion",
                   "L'asta con le due forze del collare e la retta di Culmann, e i poligoni del moto diretto e del "
                   "retrogrado"},
          .told = of.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
          .without_part = of.without({}, {"phi"})};
}

PanelSheet double_slider(const Solution& s, Language language) {
  const Case of(s, "double_slider_pins", "double_slider"), ideal(s, "double_slider");
  const double r = CGAL::to_double(s.givens()["double_slider_pins.r"]), rho = of["friction_circle_radius"];
  const Chain chain{"2",
                    "4",
                    force_between(3, 2),
                    force_between(1, 2),
                    force_between(1, 4),
                    3,
                    "⊥ $x$",
                    Words{"by both circles", "per i due cerchi"}.in(language),
                    turned_from("$x$", language),
                    turned_from("⊥ $x$", language),
                    "∥ $x$"};
  // The pin and its friction circle, with the line of the link's force.
  const auto detail = [&](const std::string& X, bool is_reversed) {
    const Place P = of.place(X), other = of.place(X == "A" ? "B" : "A");
    const Arrow2 along = (1 / distance(P, other)) * (other - P);
    Mechanism pin;
    pin.point(X, P, Joint::none, "$" + X + "$")
        .point("rim", {P.x + r, P.y}, Joint::corner, "")
        .point("circle", {P.x, P.y - rho}, Joint::corner, "");
    pin.disc(X, "rim", false).disc(X, "circle", false).axis(P + -1.5 * r * along, P + 1.5 * r * along, "$AB$");
    FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(pin)));
    PolygonSide R = of.known(moving(chain.contact, direct), "", "");
    R.quantity.clear();
    panel.force(is_reversed ? reversed(R, 3, 4) : R, of.place("on_" + X + direct));
    return panel;
  };
  // The angles at which the forces of the guides leave their normals.
  const auto with_guides = [&](const std::string& suffix) {
    ChainedPolygonsPanel panel = polygons(of, chain, suffix);
    const Arrow2 R_12 = of.vector(chain.on_loaded.name + suffix), R_14 = of.vector(chain.on_driven.name + suffix),
                 b = -R_12;
    constexpr double downwards = -std::numbers::pi / 2;
    panel.angle({0, 0}, 0, std::atan2(b.y, b.x), "$φ$").angle(b, downwards, std::atan2(-R_14.y, -R_14.x), "$φ$");
    return panel;
  };
  FreeBodyPanel whole(double_slider_figure(of));
  whole.load(of.load("Q", "", ""), of.place("A")).effort(of.known(P_of(direct), "", ""), of.place("B"), Arrow::ends);
  FreeBodyPanel A = detail("A", false), B = detail("B", true);
  A.step({"The pins turn in the link: its force touches both friction circles, $ρ$ = $r$ sin $φ$, on the sides on "
          "which it hinders their turning; so it "
          "crosses $AB$ at the angle $δ$, sin $δ$ = 2$ρ$/$l$.",
          "I perni ruotano nell'asta: la sua forza è tangente ai due cerchi d'attrito, $ρ$ = $r$ sen $φ$, dalle "
          "parti che ne ostacolano la rotazione; perciò "
          "taglia $AB$ sotto l'angolo $δ$, sen $δ$ = 2$ρ$/$l$."},
         of.place("on_A" + direct));
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"friction_circle_radius", "link_line_tilt_angle_deg"}));
  const auto row = [&](const Words& hinges, const Case& each) {
    return Row{hinges.in(language), each.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"})};
  };
  results.push_back(
      table({Words{"hinges", "cerniere"}.in(language), "$\\it{P}$ (N)", "$\\it{P}'$ (N)", "$η_{D}$", "$η_{R}$"},
            {row({"with friction", "con attrito"}, of), row({"ideal", "ideali"}, ideal)}));
  const auto limits = [&](const Words& hinges, const Case& each) {
    return Row{hinges.in(language), each.names({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"})};
  };
  results.push_back(table({Words{"hinges", "cerniere"}.in(language), "$φ_{R}$ (°)", "$φ_{D}$ (°)"},
                          {limits({"with friction", "con attrito"}, of), limits({"ideal", "ideali"}, ideal)}));
  return {
      .panels = panels(whole, A, B, with_guides(direct), with_guides(retrograde)),
      .results = results,
      .seen =
          {"The double slider, its pins with their friction circles, and the polygons of the direct and of the "
           "retrograde motion",
           "Il doppio pattino, i suoi perni con i cerchi d'attrito, e i poligoni del moto diretto e del retrogrado"},
      .told = of.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
      .without_part = of.without({}, {"phi", "double_slider_pins.r"})};
}

PanelSheet levers(const Solution& s, const std::string& name, int loaded_lever, Language language) {
  const LeverFigure at(s, name, loaded_lever);
  const Case& of = at.of;
  const double nu = of.radians("nu");
  const std::string j = std::to_string(at.loaded), i = std::to_string(at.driven);
  const auto H = [](int lever, const std::string& suffix) {
    return "$\\it{H}" + prime(suffix) + "_{" + std::to_string(lever) + "}$";
  };
  const auto hinge_line = [&](int lever, const std::string& suffix) {
    if (of.point("H_" + std::to_string(lever) + suffix)) return "∥ " + at.letters(lever) + H(lever, suffix);
    return std::string(lever == at.loaded ? "$δ_{Q}$" : "$δ_{P}$");  // parallel forces
  };
  const std::string other_H = H(2, retrograde), other_H_3 = H(3, retrograde);
  const auto chained = [&](const std::string& suffix) {
    return Chain{j,
                 i,
                 force_between(at.driven, at.loaded),
                 force_between(1, at.loaded),
                 force_between(1, at.driven),
                 at.loaded,
                 "$δ_{Q}$",
                 turned_from("$n$", language),
                 hinge_line(at.loaded, suffix),
                 hinge_line(at.driven, suffix),
                 "$δ_{P}$",
                 other_lines(other_H + " and " + other_H_3, other_H + " e " + other_H_3)};
  };
  const Chain chain = chained(direct);
  const PolygonSide contact = of.known(moving(chain.contact, direct), "", "");
  const Sides on = sides(of, chain, direct), back = sides(of, chained(retrograde), retrograde);
  // Where the lines of a body's forces do not meet on the sheet: in the direct motion, or in the retrograde one,
  // unless that needs no effort, or is the same without friction.
  const auto shared_out = [&](int lever, const std::string& suffix, const Sides& by) -> std::optional<SharedOut> {
    const auto H_of = of.point("H_" + std::to_string(lever) + suffix);
    const bool is_same = suffix == retrograde && is_zero(s.givens().angle("phi"));
    if (is_same || magnitude(by.P.v) == 0 || !is_out_of_reach(H_of, at.C, at.hinge(lever), at.attacked(lever)))
      return {};
    SharedOut shared = lever == at.loaded
                           ? SharedOut(by.Q, at.attacked(lever), by.contact, at.C, by.on_loaded, at.hinge(lever))
                           : SharedOut(by.back, at.C, by.P, at.attacked(lever), by.on_driven, at.hinge(lever));
    return suffix == retrograde ? shared.otherwise() : shared;
  };
  const auto shared_j = shared_out(at.loaded, direct, on), shared_i = shared_out(at.driven, direct, on),
             other_j = shared_out(at.loaded, retrograde, back), other_i = shared_out(at.driven, retrograde, back);
  const auto body = [&](int lever) {
    const bool is_loaded = lever == at.loaded;
    Mechanism drawn;
    at.add(drawn, lever, Joint::hinge);
    drawn.point("C", at.C, Joint::none, "$C$");
    FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(drawn)));
    const std::string k = std::to_string(lever);
    panel.to_scale();
    if (is_loaded)
      panel.load(of.load("Q", "", ""), at.attacked(lever));
    else
      panel.effort(of.known(P_of(direct), "", ""), at.attacked(lever));
    const Arrow2 v = of.vector("sliding");  // of the loaded lever on the other
    press(panel, of, is_loaded ? contact : reversed(contact, at.loaded, at.driven), at.C, nu, is_loaded ? v : -v,
          is_loaded ? j + i : i + j);
    panel.force(of.known(moving(force_between(1, lever), direct), "", ""), at.hinge(lever), Arrow::ends);
    if (const auto& shared = is_loaded ? shared_j : shared_i)
      shared->draw_strings(panel);
    else
      panel.meeting(of.name("H_" + k + direct), H(lever, direct), of.point("H_" + k + direct));
    panel.otherwise(of.name("H_" + k + retrograde), H(lever, retrograde), of.point("H_" + k + retrograde),
                    {{at.attacked(lever), of.vector(is_loaded ? "Q" : "P_ideal")},
                     {at.C, of.vector(chain.contact.name + retrograde)},
                     {at.hinge(lever), of.vector("R_1" + k + retrograde)}});
    if (const auto& other = is_loaded ? other_j : other_i) other->draw_strings(panel);
    return panel;
  };
  FreeBodyPanel first = body(at.loaded);
  first.step(turned_against, at.C);
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"contact_force_angle_direct_deg", "contact_force_angle_retrograde_deg"}));
  results.push_back(of.results({"self_locking_friction_angle_deg"}));
  Panels all = panels(first, body(at.driven));
  const auto add_motion = [&](const std::string& suffix, const Sides& by, const std::optional<SharedOut>& of_loaded,
                              const std::optional<SharedOut>& of_driven) {
    const Chain in_motion = chained(suffix);
    if (!of_loaded && !of_driven) {
      all.push_back(std::make_unique<ChainedPolygonsPanel>(polygons(of, in_motion, suffix)));
      return;
    }
    VectorPolygon first_polygon = by.first(in_motion);
    first_polygon.origin = origin(in_motion.loaded, suffix);
    add_polygons(all, first_polygon, by.second(in_motion), by.Q.v + by.contact.v, {&of_loaded, &of_driven},
                 {"−" + by.Q.label, by.contact.label});
  };
  add_motion(direct, on, shared_j, shared_i);
  add_motion(retrograde, back, other_j, other_i);
  return {
      .panels = std::move(all),
      .results = results,
      .seen =
          {"The two levers cut free with the friction cone of their contact, and the polygons of the direct and of "
           "the retrograde motion",
           "Le due leve isolate con il cono d'attrito del contatto, e i poligoni del moto diretto e del retrogrado"},
      .told = of.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
      .without_part = of.without({"r_2", "r_3"}, {"phi"})};
}

PanelSheet fairbairn(const Solution& s, const std::string& name, Language language) {
  const Case of(s, name);
  const Place A = of.place("A"), B = of.place("B"), C = of.place("C"), D = of.place("D");
  const auto shared_out = [&](const std::string& suffix) -> std::optional<SharedOut> {
    const bool is_same = suffix == retrograde && is_zero(s.givens().angle("phi"));
    if (is_same || !is_out_of_reach(of.point("H" + suffix), B, C, D)) return {};
    const auto known = [&](int i, int j) { return of.known(moving(force_between(i, j), suffix), "", ""); };
    SharedOut shared(passed_on(known(5, 6), force_between(5, 6), 5, 4, suffix), D, known(3, 4), B, known(1, 4), C);
    return suffix == retrograde ? shared.otherwise() : shared;
  };
  const auto shared = shared_out(direct), other = shared_out(retrograde);
  const auto polygon = [&](const std::string& suffix) {
    const std::string H = of.point("H" + suffix) ? "∥ $CH" + prime(suffix) + "$" : turned_from("$x$", language);
    const PolygonSide F = of.load("F", "∥ $x$", "$a$"),
                      R_56 = of.sought(moving(force_between(5, 6), suffix), turned_from("$x$", language), "$b$"),
                      R_16 = of.sought(moving(force_between(1, 6), suffix), turned_from("⊥ $x$", language)),
                      R_54 = passed_on(R_56, force_between(5, 6), 5, 4, suffix, "$a$"),
                      R_34 = of.sought(moving(force_between(3, 4), suffix), turned_from("⊥ $CD$", language), "$c$"),
                      R_14 = of.sought(moving(force_between(1, 4), suffix), H);
    VectorPolygon of_ram = force_polygon("6", {R_16}, {F, R_56});
    of_ram.origin = origin("6", suffix);
    ChainedPolygonsPanel panel(std::move(of_ram));
    VectorPolygon second = force_polygon("4", {R_14}, {R_54, R_34});
    second.origin = "$b$";
    if (!(suffix == direct ? shared : other)) panel.then(second, F.v + R_56.v);
    const Arrow2 ideal = of.vector("R_34_ideal"), b = F.v + of.vector("R_56_ideal");
    panel.over({b, b + F.v, b + F.v + ideal, b});
    if (suffix == retrograde) panel.likewise(other_lines("$\\it{H}'$ and $d'$", "$\\it{H}'$ e $d'$"), F.v);
    return panel;
  };
  Mechanism lever, crank;
  lever.point("C", C, Joint::hinge, "$C$")
      .point("B", B, Joint::none, "$B$")
      .point("D", D, Joint::hinge, "$D$")
      .point("end", end_of_lever(of), Joint::corner, "")
      .body({"C", "end"}, 4);
  crank.point("A", A, Joint::hinge, "$A$").point("B", B, Joint::hinge, "$B$").body({"A", "B"}, 2);
  FreeBodyPanel on_4(std::make_shared<const Mechanism>(std::move(lever))),
      on_2(std::make_shared<const Mechanism>(std::move(crank)));
  const PolygonSide R_34 = of.known(moving(force_between(3, 4), direct), "", ""),
                    R_54 = reversed(of.known(moving(force_between(5, 6), direct), "", ""), 5, 4),
                    R_32 = reversed(R_34, 3, 2);
  on_4.to_scale().at_most(50).force(of.known(moving(force_between(1, 4), direct), "", ""), C, Arrow::ends);
  press(on_4, of, R_34, B, -of.radians("theta"), of.vector("v_43"), "43");
  press(on_4, of, R_54, D, 0, of.vector("v_56"), "56");
  if (shared)
    shared->draw_strings(on_4);
  else
    on_4.meeting(of.name("H_direct"), "$\\it{H}$", of.point("H_direct"));
  const Arrow2 other_R_34 = of.vector("R_34" + retrograde);
  on_4.otherwise(of.name("H" + retrograde), "$\\it{H}'$", of.point("H" + retrograde),
                 {{B, other_R_34}, {D, of.vector("R_56" + retrograde)}, {C, of.vector("R_14" + retrograde)}});
  if (other) other->draw_strings(on_4);
  on_4.step(turned_against, of.point("H_direct").value_or(B));
  on_2.to_scale().at_most(50).force(R_32, B).force(reaction(R_32, "$\\vec{\\it{R}}_{12}$", ""), A);
  on_2.couple("$\\it{M}$", A, of["M_direct"]).arm(A, B, R_32.v, "$d$", of.name("d_direct"));
  on_2.otherwise("", "", {}, {{B, other_R_34}}).arm(A, B, other_R_34, "$d'$", of.name("d_retrograde"));
  on_2.moments({"$\\it{M}$ = $\\it{F}_{23}$·$d$.", "$\\it{M}$ = $\\it{F}_{23}$·$d$."}, A);
  FreeBodyPanel all(fairbairn_figure(of));
  all.to_scale().at_most(50);
  std::vector<Result> results = efficiencies(of, "M", language);
  results.push_back(of.results({"F_23_direct", "d_direct"}));
  results.push_back(of.results({"F_23_retrograde", "d_retrograde"}));
  results.push_back(of.results({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"}));
  Panels shown = panels(all, on_4, on_2, polygon(direct));
  if (shared)
    shown.push_back(std::make_unique<SharedLoadPanel>(shared->polygon(moving(force_between(5, 6), direct).arrow())));
  shown.push_back(std::make_unique<ChainedPolygonsPanel>(polygon(retrograde)));
  if (other)
    shown.push_back(
        std::make_unique<SharedLoadPanel>(other->polygon(moving(force_between(5, 6), retrograde).arrow())));
  return {.panels = std::move(shown),
          .results = results,
          .seen = {"Fairbairn's mechanism, its lever and crank cut free, and the polygons of ram and lever in the "
                   "direct and in the retrograde motion",
                   "La guida di Fairbairn, leva e manovella isolate, e i poligoni di slitta e leva nel moto "
                   "diretto e nel retrogrado"},
          .told = of.names({"M_direct", "M_retrograde", "eta_direct", "eta_retrograde"}),
          .without_part = of.without({}, {"phi"})};
}

// The efficiencies of all mechanisms over the friction angle, those given as they are.
PanelSheet over_friction_angle(const Solution& s, Language language) {
  struct Plotted {
    std::string name;
    Words label;
  };
  const std::vector<Plotted> all{{"wedge_collar", {"wedge", "cuneo"}},
                                 {"wedge_collar_two_point", {"two forces", "due forze"}},
                                 {"double_slider", {"double slider", "doppio pattino"}},
                                 {"double_slider_pins", {"with pins", "con perni"}},
                                 {"sliding_levers", {"levers", "leve"}},
                                 {"fairbairn", {"Fairbairn", "Fairbairn"}}};
  // Every limit stands on the charts.
  const auto limit_of = [&](const Plotted& each, int k) {
    const std::string name = each.name + (k == 0 ? ".jamming" : ".self_locking") + "_friction_angle_deg";
    return s.has(name) ? s.value(name) : std::nullopt;
  };
  double farthest = 0;
  for (const Plotted& each : all)
    for (const int k : {0, 1}) farthest = std::max(farthest, limit_of(each, k).value_or(0));
  const int most = std::min(90, 10 * (static_cast<int>(farthest / 10) + 1));
  std::map<std::string, std::vector<drawings::Datum>> runs;
  for (const Plotted& each : all) {
    double degrees = 0;
    for (const ValuesByName& values : values_at_friction_angles(
             s.givens(), most, each.name, {each.name + ".eta" + direct, each.name + ".eta" + retrograde})) {
      degrees += 1;
      for (const auto& [quantity, value] : values) {
        if (value <= 0 || value > 1) continue;
        auto& run = runs[quantity];
        if (degrees == 1) run.push_back({0, 1});  // without friction nothing is lost
        const bool goes_on = run.empty() || run.back().x == degrees - 1;
        if (goes_on) run.push_back({degrees, value});
      }
    }
  }
  const double phi = geometry::degrees(s.givens().angle("phi"));
  const auto chart = [&](int k) {
    drawings::Chart drawn{.x = {.quantity = "$φ$",
                                .unit = "°",
                                .low = 0,
                                .high = static_cast<double>(most),
                                .steps = drawings::degree_steps},
                          .y = {.quantity = k == 0 ? "$η_{D}$" : "$η_{R}$", .unit = "", .low = 0, .high = 1}};
    std::vector<ChartPanel::Read> read;
    for (const Plotted& each : all) {
      const std::string eta = each.name + ".eta" + (k == 0 ? direct : retrograde);
      auto& run = runs[eta];
      const std::string limit = each.name + (k == 0 ? ".jamming" : ".self_locking") + "_friction_angle_deg";
      if (const auto angle = limit_of(each, k)) {
        run.push_back({*angle, 0});
        read.push_back({run.back(), limit, {}});
        // Which one it is, its curve says; two that lie on each other are one mark.
        const bool stands = std::any_of(drawn.markers.begin(), drawn.markers.end(), [&](const auto& marker) {
          return marker.at.x == *angle && marker.at.y == 0;
        });
        if (!stands)
          drawn.markers.push_back(
              {.at = run.back(), .label = k == 0 ? "$φ_{D}$" : "$φ_{R}$", .shape = drawings::PointShape::diamond});
      }
      if (const auto value = s.value(eta); value && *value > 0 && phi <= most) {
        read.push_back({{phi, *value}, {}, eta});
        drawn.markers.push_back({.at = read.back().at, .meaning = Meaning::force});
      }
      if (!run.empty())
        drawn.curves.push_back(
            {.name = "eta_" + each.name, .runs = {run}, .meaning = Meaning::force, .label = each.label.in(language)});
    }
    drawn.verticals = {{.at = phi, .label = "$φ$"}};
    return ChartPanel(drawn, read);
  };
  std::vector<Row> rows;
  for (const Plotted& each : all) {
    const std::string jamming = each.name + ".jamming_friction_angle_deg";
    rows.push_back({each.label.in(language),
                    {each.name + ".eta_direct", each.name + ".eta_retrograde",
                     each.name + ".self_locking_friction_angle_deg", s.has(jamming) ? jamming : ""},
                    "–"});
  }
  return {.panels = panels(chart(0), chart(1)),
          .results = {table({"", "$η_{D}$", "$η_{R}$", "$φ_{R}$ (°)", "$φ_{D}$ (°)"}, rows),
                      remark(Words{
                          "$η_{R}$ = 0 at the friction angle $φ_{R}$, from which the mechanism is "
                          "self-locking; $η_{D}$ = 0 at $φ_{D}$, where it jams and no force moves it.",
                          "$η_{R}$ = 0 all'angolo d'attrito $φ_{R}$, dal quale il meccanismo è "
                          "irreversibile; $η_{D}$ = 0 all'angolo $φ_{D}$, dove s'impunta e nessuna forza lo muove."}
                                 .in(language))},
          .seen = {"The efficiencies of the direct and of the retrograde motion over the friction angle",
                   "I rendimenti del moto diretto e del retrogrado in funzione dell'angolo d'attrito"},
          .told = {"wedge_collar.eta_direct", "wedge_collar.eta_retrograde"},
          .without_part = Case(s, "none").without({}, {"phi"})};
}

}  // namespace

std::vector<SheetMaker> sheets() {
  return {
      {{"wedge",
        {"Wedge and collar", "Cuneo e collare"},
        {"A wedge lifts a rod in its collar. All pairs rub. Find the driving force in direct motion, the force that "
         "holds back in retrograde motion by force polygons, and both efficiencies.",
         "Un cuneo solleva un'asta nel suo collare. In tutte le coppie c'è attrito. Trovare con i poligoni delle "
         "forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i due rendimenti."}},
       wedge},
      {{"two-forces",
        {"Collar with two forces", "Collare con due forze"},
        {"A wedge lifts a rod in its collar, which answers with two forces. All pairs rub. Find the driving force in "
         "direct motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "Un cuneo solleva un'asta nel suo collare, che risponde con due forze. In tutte le coppie c'è attrito. "
         "Trovare con i poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto "
         "retrogrado, e i due rendimenti."}},
       two_forces},
      {{"double-slider",
        {"Double slider", "Doppio pattino"},
        {"A bar joins two sliders. All pairs rub. Find the driving force in direct motion, the force that holds back "
         "in retrograde motion by force polygons, and both efficiencies.",
         "Un'asta unisce due pattini. In tutte le coppie c'è attrito. Trovare con i poligoni delle forze la forza "
         "motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i due rendimenti."}},
       double_slider},
      {{"levers",
        {"Sliding levers, Q on lever 3", "Leve striscianti, Q sulla leva 3"},
        {"One lever slides on another, with the load on lever 3. All pairs rub. Find the driving force in direct "
         "motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "Una leva striscia sull'altra, con il carico sulla leva 3. In tutte le coppie c'è attrito. Trovare con i "
         "poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i "
         "due rendimenti."}},
       [](const Solution& s, Language language) { return levers(s, "sliding_levers", 3, language); }},
      {{"levers-Q-on-2",
        {"Sliding levers, Q on lever 2", "Leve striscianti, Q sulla leva 2"},
        {"One lever slides on another, with the load on lever 2. All pairs rub. Find the driving force in direct "
         "motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "Una leva striscia sull'altra, con il carico sulla leva 2. In tutte le coppie c'è attrito. Trovare con i "
         "poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i "
         "due rendimenti."}},
       [](const Solution& s, Language language) { return levers(s, "sliding_levers_Q_on_2", 2, language); }},
      {{"fairbairn",
        {"Fairbairn's mechanism", "Guida di Fairbairn"},
        {"Fairbairn's mechanism carries its load. All pairs rub. Find the driving force in direct motion, the force "
         "that holds back in retrograde motion by force polygons, and both efficiencies.",
         "La guida di Fairbairn porta il suo carico. In tutte le coppie c'è attrito. Trovare con i poligoni delle "
         "forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, e i due rendimenti."}},
       [](const Solution& s, Language language) { return fairbairn(s, "fairbairn", language); }},
      {{"fairbairn-short-lever",
        {"Fairbairn's mechanism, shorter lever", "Guida di Fairbairn, leva più corta"},
        {"Fairbairn's mechanism with the shorter lever carries its load. All pairs rub. Find the driving force in "
         "direct motion, the force that holds back in retrograde motion by force polygons, and both efficiencies.",
         "La guida di Fairbairn con la leva più corta porta il suo carico. In tutte le coppie c'è attrito. Trovare "
         "con i poligoni delle forze la forza motrice nel moto diretto, la forza che trattiene nel moto retrogrado, "
         "e i due rendimenti."}},
       [](const Solution& s, Language language) { return fairbairn(s, "fairbairn_short_lever", language); }},
      {{"efficiencies",
        {"Efficiency and friction angle", "Rendimento e angolo d'attrito"},
        {"All pairs of the wedge and its collar rub. Find how the efficiencies depend on the friction angle, and at "
         "which one self-locking and jamming begin.",
         "In tutte le coppie del cuneo e del collare c'è attrito. Trovare come i rendimenti dipendono dall'angolo "
         "d'attrito, e a quale iniziano l'arresto spontaneo e l'impuntamento."}},
       over_friction_angle}};
}

}  // namespace epure::friction_efficiency
