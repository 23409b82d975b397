#include <array>
#include <cmath>
#include <numbers>

#include "exercises/friction-efficiency/both_motions.h"
#include "exercises/friction-efficiency/sheets.h"
#include "exercises/kit/linkages/shared_out.h"
#include "exercises/kit/panels/mechanism_panel.h"

namespace epure::friction_efficiency {

namespace {

// The wedge in the direct motion: the face's force turned from its normal, P, and the floor's through where they
// meet.
FreeBodyPanel wedge_cut_free(const Case& of, const WedgeFigure& at) {
  Mechanism block;
  block.point("O", {0, 0}, Joint::none, "$O$");
  add_wedge(block, at);
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(block)));
  const PolygonSide R_32 = reversed(of.known(moving(force_between(2, 3), direct), "", ""), 3, 2),
                    R_12 = of.known(moving(force_between(1, 2), direct), "", "");
  // Where R_32 and P meet, from the triangle of directions.
  const Place H{R_32.v.y == 0 ? 0 : at.line_of_P * R_32.v.x / R_32.v.y, at.line_of_P};
  const Place foot{H.x + (at.floor - H.y) * R_12.v.x / R_12.v.y, at.floor};
  panel.to_scale().at_most(200).effort(of.known(P_of(direct), "", ""), {at.back, at.line_of_P}, Arrow::ends);
  press(panel, of, R_32, {0, 0}, std::numbers::pi / 2 - of.radians("theta"), -of.vector("v_32"), "23", "$r_{2}$");
  press(panel, of, R_12, foot, -std::numbers::pi / 2, of.vector("v_21"), "21");
  panel.meeting("", "$H_{2}$", H);
  return panel;
}

WedgeFigure figure_of(const Case& of) { return WedgeFigure(of, geometry::to_double(of.s.givens().angle("phi"))); }

}  // namespace

PanelSheet wedge(const Solution& s, Language language) {
  const Case of(s, "wedge_collar");
  const WedgeFigure at = figure_of(of);
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
  Mechanism rod;
  rod.point("O", {0, 0}, Joint::none, "$O$");
  add_rod(rod, at);
  FreeBodyPanel on_rod(std::make_shared<const Mechanism>(std::move(rod)));
  const PolygonSide Q = of.load("Q", "", ""), R_23 = of.known(moving(chain.contact, direct), "", "");
  on_rod.to_scale().at_most(200).load(Q, {0, at.top}, Arrow::ends);
  press(on_rod, of, R_23, {0, 0}, normal, of.vector("v_32"), "32", "$r_{2}$");
  press(on_rod, of, of.known(moving(chain.on_loaded, direct), "", ""), {0, 0}, 0, of.vector("v_31"), "31");
  on_rod.step(turned_against, {0, 0});
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"}));
  if (of.s.value(of.name("jamming_friction_angle_deg"))) results.push_back(remark(locks_from_and_jams.in(language)));
  return {.panels = panels(whole(at, of, of.known(P_of(direct), "", ""), 200, Dimensioned::yes), on_rod,
                           wedge_cut_free(of, at), polygons(of, chain, direct), polygons(of, chain, retrograde)),
          .results = results,
          .seen = {"Wedge and rod cut free with their friction cones, and the polygons of the direct and of the "
                   "retrograde motion",
                   "Cuneo e asta isolati con i coni d'attrito, e i poligoni del moto diretto e del retrogrado"},
          .told = of.names({"P_i", "P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
          .without_part = of.without({}, {"phi"})};
}

PanelSheet two_forces(const Solution& s, Language language) {
  const Case of(s, "wedge_collar_two_point", "wedge_collar");
  const WedgeFigure at = figure_of(of);
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
    panel.captioned(name_of(motion_of(suffix)));
    if (K) {  // the two that together are what leads from b to the origin
      VectorPolygon of_collar = force_polygon("3", {}, {second, first});
      of_collar.origin = "$b$";
      panel.then(of_collar, Q.v + R_23.v);
    }
    if (!K && suffix == direct) {
      const PolygonSide minus = reaction(sum, "−" + sum.label, "$\\it{R}_{13}$");
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
  on_rod.to_scale().at_most(200).load(of.load("Q", "", ""), {0, at.top}, Arrow::ends);
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
  if (K) on_rod.line_to({0, 0}, *K, "$OK$").turned({0, 0}, 0, direction(Place{0, 0}, *K), "$κ$", "$x$", false);
  if (const auto other = of.point("K_retrograde"))
    on_rod.otherwise(of.name("K_retrograde"), "$K'$", other,
                     {{{-at.w / 2, at.upper}, of.vector("R_13_upper_retrograde")},
                      {{at.w / 2, at.lower}, of.vector("R_13_lower_retrograde")},
                      {{0, 0}, Place{0, 0} - *other}},
                     false);
  if (K)
    on_rod.step({"The collar's forces meet in $K$, $\\vec{\\it{Q}}$ and $\\vec{\\it{R}}_{23}$ in $O$: the collar's "
                 "two together run along $OK$, Culmann's line, at $κ$ from $x$.",
                 "Le forze del collare si incontrano in $K$, $\\vec{\\it{Q}}$ e $\\vec{\\it{R}}_{23}$ in $O$: le due "
                 "del collare insieme corrono lungo $OK$, la retta di Culmann, a $κ$ da $x$."},
                {0, 0});
  all.insert(all.begin(), std::make_unique<FreeBodyPanel>(wedge_cut_free(of, at)));
  all.insert(all.begin(), std::make_unique<FreeBodyPanel>(std::move(on_rod)));
  std::vector<Result> results = efficiencies(of, "P", language);
  results.push_back(of.results({"K_direct_x", "K_direct_y", "culmann_angle_direct_deg"}));
  results.push_back(of.results({"self_locking_friction_angle_deg", "jamming_friction_angle_deg"}));
  if (of.s.value(of.name("jamming_friction_angle_deg"))) results.push_back(remark(locks_from_and_jams.in(language)));
  return {
      .panels = std::move(all),
      .results = results,
      .seen =
          {"The rod with the two forces of its collar and Culmann's line, the wedge cut free, and the polygons of "
           "the direct and of the retrograde motion",
           "L'asta con le due forze del collare e la retta di Culmann, il cuneo isolato, e i poligoni del "
           "moto diretto e del retrogrado"},
      .told = of.names({"P_direct", "P_retrograde", "eta_direct", "eta_retrograde"}),
      .without_part = of.without({}, {"phi"})};
}

}  // namespace epure::friction_efficiency
