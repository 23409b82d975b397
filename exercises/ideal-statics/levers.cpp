// The sliding levers: free bodies with their chained triangles, and the equivalent four-bar.
#include <cmath>
#include <numbers>

#include "exercises/ideal-statics/sheets.h"
#include "exercises/kit/linkages/loaded_figures.h"
#include "exercises/kit/linkages/shared_out.h"

namespace epure::ideal_statics {
namespace {

using Arrow = FreeBodyPanel::Arrow;
using Joint = Mechanism::Joint;

FreeBodyPanel cut_free(const LeverFigure& at, int lever, const PolygonSide& applied, const PolygonSide& contact,
                       const PolygonSide& pivot, const std::optional<SharedOut>& shared) {
  Mechanism body;
  at.add(body, lever, Joint::hinge);
  body.point("C", at.C, Joint::none, "$C$");
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(body)));
  const std::string i = std::to_string(lever), H = "$H_{" + i + "}$";
  panel.to_scale();
  if (lever == at.loaded)
    panel.load(applied, at.attacked(lever));
  else
    panel.effort(applied, at.attacked(lever));
  panel.force(contact, at.C, Arrow::ends).force(pivot, at.hinge(lever), Arrow::ends);
  const std::string arm = lever == 2 ? "A0" : "B0";
  panel.arm(at.hinge(lever), at.C, contact.v, "$b_{" + arm + "}$", at.of.name("arm_normal_" + arm));
  const auto meeting = at.of.point("H_" + i);
  if (shared) {
    shared->draw_strings(panel);
    return panel;
  }
  panel.meeting(at.of.name("H_" + i), H, meeting);
  panel.step(Words{"Lever " + i + ": " + applied.label + " and " + contact.label +
                       ", along the normal $n$, meet in " + H + "; " + pivot.label + " runs through " +
                       at.letters(lever) + " (the normal passes it at the distance $b_{" + arm + "}$) and " + H + ".",
                   "Leva " + i + ": la " + applied.label + " e la " + contact.label +
                       ", lungo la normale $n$, si incontrano in " + H + "; la " + pivot.label + " passa per " +
                       at.letters(lever) + " (la normale ne dista $b_{" + arm + "}$) e " + H + "."},
             meeting.value_or(at.hinge(lever)));
  return panel;
}

PanelSheet polygons(const LeverFigure& at, Language language) {
  const Case& of = at.of;
  const int j = at.loaded, i = at.driven;
  const std::string H_j = "$H_{" + std::to_string(j) + "}$", H_i = "$H_{" + std::to_string(i) + "}$";
  const PolygonSide Q = of.load("Q", at.along("Q", language), "$a$"),
                    contact = of.sought(force_between(i, j), "∥ $n$", "$b$"),
                    pivot_j = of.sought(force_between(1, j), "∥ " + at.letters(j) + H_j),
                    back = reversed(contact, j, i, "$a$"), driving = of.sought(P(), at.along("P", language), "$c$"),
                    pivot_i = of.sought(force_between(1, i), "∥ " + at.letters(i) + H_i);
  const VectorPolygon first = force_polygon(std::to_string(j), {pivot_j}, {Q, contact});
  VectorPolygon second = force_polygon(std::to_string(i), {pivot_i}, {back, driving});
  // Where a meeting point is out of reach the funicular polygon finds what the triangle cannot.
  std::optional<SharedOut> shared_j, shared_i;
  if (is_out_of_reach(of.point("H_" + std::to_string(j)), at.C, at.hinge(j), at.attacked(j)))
    shared_j.emplace(Q, at.attacked(j), contact, at.C, pivot_j, at.hinge(j));
  if (is_out_of_reach(of.point("H_" + std::to_string(i)), at.C, at.hinge(i), at.attacked(i)))
    shared_i.emplace(back, at.C, driving, at.attacked(i), pivot_i, at.hinge(i));
  Panels all =
      panels(levers_with_givens(at, of.load("Q", "", ""), of.known(P(), "", "")),
             cut_free(at, j, Q, contact, pivot_j, shared_j), cut_free(at, i, driving, back, pivot_i, shared_i));
  second.origin = "$b$";
  add_polygons(all, first, second, Q.v + contact.v, {&shared_j, &shared_i}, {"−" + Q.label, contact.label});
  const std::string R_ij = "R_" + std::to_string(i) + std::to_string(j);
  return {
      .panels = std::move(all),
      .results = {of.results({"P"}), of.results({"R_12", "R_13", R_ij}),
                  of.results({"arm_normal_A0", "arm_normal_B0"})},
      .seen =
          {"The two levers, each cut free with the meeting point of its three forces, and their chained triangles",
           "Le due leve, ciascuna isolata con il punto d'incontro delle sue tre forze, e i loro triangoli "
           "concatenati"},
      .told = of.names({"P", "R_12", "R_13", R_ij}),
      .without_part = of.without({"r_2", "r_3"})};
}

// ω2 = 1 rad/s.
PanelSheet virtual_work(const LeverFigure& at) {
  const Case& of = at.of;
  using Where = PolesStep::Where;
  Mechanism four_bar;
  four_bar.point("A0", at.A0, Joint::fixed, "$A_{0}$")
      .point("B0", at.B0, Joint::fixed, "$B_{0}$")
      .point("A", at.A, Joint::hinge, "$A$")
      .point("B", at.B, Joint::hinge, "$B$")
      .point("C", at.C, Joint::none, "$C$")
      .body({"A0", "A"}, 2)
      .body({"B0", "B"}, 3)
      .body({"A", "B"}, 4)
      .axis(at.A0, at.B0);
  if (const auto P23_x = of.s.value(of.name("P23_x")))
    four_bar.point("P23", {*P23_x, 0}, Joint::none, "$P_{23}$").axis(at.A, {*P23_x, 0});
  for (const int lever : {2, 3})
    four_bar.profile(at.centre(lever), at.radius(lever), direction(at.centre(lever), at.C) - 0.7,
                     direction(at.centre(lever), at.C) + 0.7);
  PolesPanel poles(
      of.s, std::make_shared<const Mechanism>(std::move(four_bar)), of.pole("P41"), {"A", "B"},
      {{{"While they touch, the levers move as the four-bar $A_{0}ABB_{0}$ of the profiles' centres; its coupler is "
         "body 4. Velocities are laid off for $ω_{2}$ = 1 rad/s.",
         "Finché si toccano, le leve si muovono come il quadrilatero $A_{0}ABB_{0}$ dei centri dei profili; la "
         "biella è il membro 4. Le velocità si riportano per $ω_{2}$ = 1 rad/s."},
        Where::point,
        "A"},
       {{"$A_{0}A$ and $B_{0}B$ meet in $P_{41}$, the coupler's pole.",
         "$A_{0}A$ e $B_{0}B$ si incontrano in $P_{41}$, polo della biella."},
        Where::pole},
       {{"$ω_{3}$/$ω_{2}$ = ($A_{0}A$/$B_{0}B$)·($P_{41}B$/$P_{41}A$): $v_{A}$ = $ω_{2}$·$A_{0}A$ = "
         "$ω_{4}$·$P_{41}A$, and so in $B$. The normal meets $A_{0}B_{0}$ in $P_{23}$, which gives the same ratio.",
         "$ω_{3}$/$ω_{2}$ = ($A_{0}A$/$B_{0}B$)·($P_{41}B$/$P_{41}A$): $v_{A}$ = $ω_{2}$·$A_{0}A$ = "
         "$ω_{4}$·$P_{41}A$, e così in $B$. La normale incontra $A_{0}B_{0}$ in $P_{23}$, che dà lo stesso "
         "rapporto."},
        Where::tip,
        "B"}});
  const PolygonSide Q = of.load("Q", "", ""), driving = of.known(P(), "", "");
  const std::string i = std::to_string(at.driven), j = std::to_string(at.loaded);
  Mechanism levers = at.whole();
  constexpr double clear = 0.015;                                // m
  const double aside = of.radians("nu") + std::numbers::pi / 2;  // away from the angle of the normal
  levers.point("A", at.A, Joint::none, "$A$").point("B", at.B, Joint::none, "$B$");
  levers.offset("A", at.C, aside, clear, "$r_{2}$").offset("B", at.C, aside, clear, "$r_{3}$");
  FreeBodyPanel arms(std::make_shared<const Mechanism>(std::move(levers)));
  at.directed(arms, "n");
  arms.load(Q, at.attacked(at.loaded)).effort(driving, at.attacked(at.driven));
  arms.arm(at.hinge(at.loaded), at.attacked(at.loaded), Q.v, "$b_{Q}$", of.name("arm_Q"))
      .arm(at.hinge(at.driven), at.attacked(at.driven), at.p, "$b_{P}$", "");
  arms.step({"$\\it{P}$·$v_{P}$ − $\\it{Q}$·$v_{Q}$ = 0, with $v_{P}$ = $ω_{" + i + "}$·$b_{P}$ and $v_{Q}$ = $ω_{" +
                 j + "}$·$b_{Q}$.",
             "$\\it{P}$·$v_{P}$ − $\\it{Q}$·$v_{Q}$ = 0, con $v_{P}$ = $ω_{" + i + "}$·$b_{P}$ e $v_{Q}$ = $ω_{" + j +
                 "}$·$b_{Q}$."},
            at.attacked(at.loaded));
  const VectorPolygon polygon = velocity_polygon(
      {of.moves("B", "⊥ $B_{0}B$", "?")},
      {of.moves("A", "⊥ $A_{0}A$", "$ω_{2}$·$A_{0}A$", "$a$"), of.moves("BA", "⊥ $AB$", "?", "$b$")});
  return {
      .panels = panels(poles, PolygonPanel(of.s, polygon), arms),
      .results = {of.results({"A0A", "B0B"}), of.results({"P41A", "P41B", "P23_x"}),
                  of.results({"omega_3_over_omega_2", "omega_4_over_omega_2"}), of.results({"arm_Q", "v_Q_over_v_P"}),
                  of.results({"P_virtual_work"}), for_comparison(of.results({"P"}))},
      .seen = {"The equivalent four-bar of the sliding levers with its poles, and the polygon of velocities",
               "Il quadrilatero equivalente delle leve striscianti con i suoi poli, e il poligono delle velocità"},
      .told = of.names({"P41_x", "P41_y", "omega_3_over_omega_2", "v_Q_over_v_P", "P_virtual_work"}),
      .without_part = of.without()};
}

}  // namespace

std::vector<SheetMaker> lever_sheets() {
  return {
      {{"levers",
        {"Sliding levers, Q on lever 3", "Leve striscianti, Q sulla leva 3"},
        {"One lever slides on another, with the load on lever 3. There is no friction. Find the force (or couple) "
         "that balances the load and all reactions by cutting the bodies free and drawing force polygons.",
         "Una leva striscia sull'altra, con il carico sulla leva 3. Non c'è attrito. Trovare la forza (o la coppia) "
         "che equilibra il carico e tutte le reazioni, isolando i corpi e disegnando i poligoni delle forze."}},
       [](const Solution& s, Language language) { return polygons(LeverFigure(s, "sliding_levers", 3), language); }},
      {{"levers-virtual-work",
        {"Sliding levers: virtual work", "Leve striscianti: lavori virtuali"},
        {"One lever slides on another, with the load on lever 3. There is no friction. Find the force (or couple) "
         "that balances the load by virtual work.",
         "Una leva striscia sull'altra, con il carico sulla leva 3. Non c'è attrito. Trovare la forza (o la coppia) "
         "che equilibra il carico con i lavori virtuali."}},
       [](const Solution& s, Language) { return virtual_work(LeverFigure(s, "sliding_levers", 3)); }},
      {{"levers-Q-on-2",
        {"Sliding levers, Q on lever 2", "Leve striscianti, Q sulla leva 2"},
        {"One lever slides on another, with the load on lever 2. There is no friction. Find the force (or couple) "
         "that balances the load and all reactions by cutting the bodies free and drawing force polygons.",
         "Una leva striscia sull'altra, con il carico sulla leva 2. Non c'è attrito. Trovare la forza (o la coppia) "
         "che equilibra il carico e tutte le reazioni, isolando i corpi e disegnando i poligoni delle forze."}},
       [](const Solution& s, Language language) {
         return polygons(LeverFigure(s, "sliding_levers_Q_on_2", 2), language);
       }},
      {{"levers-Q-on-2-virtual-work",
        {"Sliding levers, Q on lever 2: virtual work", "Leve striscianti, Q sulla leva 2: lavori virtuali"},
        {"One lever slides on another, with the load on lever 2. There is no friction. Find the force (or couple) "
         "that balances the load by virtual work.",
         "Una leva striscia sull'altra, con il carico sulla leva 2. Non c'è attrito. Trovare la forza (o la coppia) "
         "che equilibra il carico con i lavori virtuali."}},
       [](const Solution& s, Language) { return virtual_work(LeverFigure(s, "sliding_levers_Q_on_2", 2)); }}};
}

}  // namespace epure::ideal_statics
