// The wedge that lifts a rod in its collar, which answers with one force or with two.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/ideal-statics/sheets.h"
#include "exercises/kit/linkages/loaded_figures.h"
#include "exercises/kit/panels/shared_load_panel.h"

namespace epure::ideal_statics {
namespace {

using Arrow = FreeBodyPanel::Arrow;
using Joint = Mechanism::Joint;

struct Forces {
  PolygonSide Q, R_23, R_32, P, R_12;
};
Forces forces(const Case& of) {
  const PolygonSide R_23 = of.sought(force_between(2, 3), "∥ $r_{2}$", "$b$");
  return {of.load("Q", "∥ $r_{1}$", "$a$"), R_23, reversed(R_23, 3, 2, "$a$"), of.sought(P(), "∥ $x$", "$c$"),
          of.sought(force_between(1, 2), "⊥ $x$")};
}

FreeBodyPanel wedge_cut_free(const WedgeFigure& at, const Forces& on) {
  Mechanism wedge;
  wedge.point("O", {0, 0}, Joint::none, "$O$");
  add_wedge(wedge, at);
  constexpr double beyond = 0.03, outwards = 0.09;  // m
  wedge.axis({0, 0}, {outwards * at.sine, outwards * at.cosine}, "$r_{2}$")
      .axis({at.back, at.line_of_P}, {at.right.x + beyond, at.line_of_P}, "$r_{3}$");
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(wedge)));
  const double x_H = at.line_of_P * at.sine / at.cosine;
  panel.to_scale()
      .at_most(200)
      .force(on.R_32, {0, 0}, Arrow::ends)
      .effort(on.P, {at.back, at.line_of_P}, Arrow::ends);
  panel.force(on.R_12, {x_H, at.floor}, Arrow::ends).meeting("", "$H_{2}$", Place{x_H, at.line_of_P});
  panel.step({"Wedge: $\\vec{\\it{R}}_{32}$ = −$\\vec{\\it{R}}_{23}$ along $r_{2}$ and $\\vec{\\it{P}}$ along "
              "$r_{3}$ meet in $H_{2}$; the floor's force, square to it, passes there.",
              "Cuneo: la $\\vec{\\it{R}}_{32}$ = −$\\vec{\\it{R}}_{23}$ lungo $r_{2}$ e la $\\vec{\\it{P}}$ lungo "
              "$r_{3}$ si incontrano in $H_{2}$; vi passa la reazione del piano, ad esso normale."},
             {x_H, at.line_of_P});
  return panel;
}

FreeBodyPanel rod_cut_free(const WedgeFigure& at, const Forces& on) {
  Mechanism rod;
  rod.point("O", {0, 0}, Joint::none, "$O$");
  add_rod(rod, at);
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(rod)));
  panel.to_scale().at_most(200).load(on.Q, {0, at.top}, Arrow::ends).force(on.R_23, {0, 0}, Arrow::ends);
  return panel;
}

PanelSheet one_force(const Solution& s, Language) {
  const Case of(s, "wedge_collar");
  const WedgeFigure at(of);
  const Forces on = forces(of);
  const PolygonSide R_13 = of.sought(force_between(1, 3), "∥ $x$");
  FreeBodyPanel rod = rod_cut_free(at, on);
  rod.force(R_13, {0, 0}, Arrow::ends);
  rod.step({"Rod: $\\vec{\\it{Q}}$ along $r_{1}$ and $\\vec{\\it{R}}_{23}$ along the normal $r_{2}$ meet in $O$; the "
            "collar's force, square to the rod, passes there.",
            "Asta: la $\\vec{\\it{Q}}$ lungo $r_{1}$ e la $\\vec{\\it{R}}_{23}$ lungo la normale $r_{2}$ si "
            "incontrano in $O$; vi passa la reazione del collare, normale all'asta."},
           {0, 0});
  ChainedPolygonsPanel polygons(force_polygon("3", {R_13}, {on.Q, on.R_23}));
  VectorPolygon of_wedge = force_polygon("2", {on.R_12}, {on.R_32, on.P});
  of_wedge.origin = "$b$";
  polygons.then(of_wedge, on.Q.v + on.R_23.v);
  return {.panels = panels(whole(at, of, of.known(P(), "", ""), 200, Dimensioned::yes), rod, wedge_cut_free(at, on),
                           polygons),
          .results = {of.results({"P", "R_12"}), of.results({"R_13", "R_23"})},
          .seen = {"The wedge and the rod in its collar, both cut free, and the triangles of their forces",
                   "Il cuneo e l'asta nel collare, entrambi isolati, e i triangoli delle loro forze"},
          .told = of.names({"P", "R_12", "R_13", "R_23"}),
          .without_part = of.without()};
}

// The wedge moves by 1 m/s.
PanelSheet virtual_work_of_wedge(const Solution& s, Language language) {
  const Case of(s, "wedge_collar");
  const VectorPolygon displacements = velocity_polygon(
      {of.moves("3", "∥ $r_{1}$", "?")},
      {of.moves("2", "∥ $x$", "1 m/s", "$2$"), of.moves("32", Words{"∥ face", "∥ faccia"}.in(language), "?", "$3$")});
  FreeBodyPanel mechanism = whole(WedgeFigure(of), of, of.known(P(), "", ""), 500, Dimensioned::no);
  mechanism.step({"The wedge moves along $x$, the rod along $r_{1}$, and on each other they slide along the face: "
                  "$v_{Q}$ : $v_{P}$ = tan $θ$. $\\it{P}$·$v_{P}$ − $\\it{Q}$·$v_{Q}$ = 0, with $v_{P}$ = $v_{2}$ "
                  "and $v_{Q}$ = $v_{3}$.",
                  "Il cuneo si muove lungo $x$, l'asta lungo $r_{1}$, e l'uno sull'altra scorrono lungo la faccia: "
                  "$v_{Q}$ : $v_{P}$ = tg $θ$. $\\it{P}$·$v_{P}$ − $\\it{Q}$·$v_{Q}$ = 0, con $v_{P}$ = $v_{2}$ e "
                  "$v_{Q}$ = $v_{3}$."},
                 {0, 0});
  return {
      .panels = panels(mechanism, PolygonPanel(s, displacements)),
      .results = {of.results({"v_Q_over_v_P"}), of.results({"P_virtual_work"}), for_comparison(of.results({"P"}))},
      .seen = {"The wedge and the rod in its collar, and the polygon of their virtual velocities",
               "Il cuneo e l'asta nel collare, e il poligono delle loro velocità virtuali"},
      .told = of.names({"v_Q_over_v_P", "P_virtual_work"}),
      .without_part = of.without({"w", "y_lower", "y_upper"})};
}

PanelSheet two_forces(const Solution& s, Language) {
  const Case of(s, "wedge_collar_two_point", "wedge_collar");
  const WedgeFigure at(of);
  const Forces on = forces(of);
  const PolygonSide upper = of.sought(R_13_upper(), "∥ $x$"), lower = of.sought(R_13_lower(), "∥ $x$");
  FreeBodyPanel rod = rod_cut_free(at, on);
  rod.force(upper, {-at.w / 2, at.upper}, Arrow::ends).force(lower, {at.w / 2, at.lower}, Arrow::ends);
  const auto string = [&](const std::string& from, const std::string& to, const std::string& letters) {
    rod.string(of.place(from), of.place(to), letters);
  };
  string("on_upper", "on_resultant", "1′");
  string("on_resultant", "on_lower", "2′");
  string("on_lower", "on_upper", "3′");
  // The lines of action as far as the strings.
  rod.string({0, 0}, of.place("on_resultant"), "").string({at.w / 2, at.lower}, of.place("on_lower"), "");
  PolygonSide R_13 = of.known(force_between(1, 3), "∥ $x$", "?");
  R_13.quantity.clear();
  ChainedPolygonsPanel polygons(force_polygon("3", {R_13}, {on.Q, on.R_23}));
  SharedLoadPanel shared({{}, R_13.label, R_13.v}, {upper.quantity, upper.label, upper.v},
                         {lower.quantity, lower.label, lower.v}, of.vector("pole"), "N");
  shared.named({"1", "2", "3"}, "$O_{f}$");
  shared.step({"A pole $O_{f}$ beside $\\vec{\\it{R}}_{13}$, and the rays 1 and 2 to its ends. "
               "Funicular polygon on the rod: 1′ parallel to 1, from the line of $\\vec{\\it{R}}^{u}_{13}$ "
               "to that of $\\vec{\\it{R}}_{13}$ "
               "through $O$; 2′ parallel to 2, to the line of $\\vec{\\it{R}}^{l}_{13}$; 3′ closes "
               "it.",
               "Un polo $O_{f}$ accanto alla $\\vec{\\it{R}}_{13}$, e i raggi 1 e 2 ai suoi estremi. "
               "Poligono funicolare sull'asta: 1′ parallela a 1, dalla retta della $\\vec{\\it{R}}^{u}_{13}$ "
               "a quella della "
               "$\\vec{\\it{R}}_{13}$ per $O$; 2′ parallela a 2, fino alla retta della "
               "$\\vec{\\it{R}}^{l}_{13}$; 3′ lo chiude."},
              SharedLoadPanel::At::pole);
  shared.step({"The ray 3 parallel to 3′ parts $\\vec{\\it{R}}_{13}$ into $\\vec{\\it{R}}^{u}_{13}$ and "
               "$\\vec{\\it{R}}^{l}_{13}$.",
               "Il raggio 3 parallelo a 3′ divide la $\\vec{\\it{R}}_{13}$ in $\\vec{\\it{R}}^{u}_{13}$ e "
               "$\\vec{\\it{R}}^{l}_{13}$."},
              SharedLoadPanel::At::between);
  VectorPolygon of_wedge = force_polygon("2", {on.R_12}, {on.R_32, on.P});  // as with one force
  of_wedge.origin = "$b$";
  polygons.then(of_wedge, on.Q.v + on.R_23.v);
  rod.larger().at_most(500);
  return {.panels = panels(whole(at, of, of.known(P(), "", ""), 200, Dimensioned::yes), rod, polygons, shared),
          .results = {of.results({"P", "R_12"}), of.results({"R_13_upper", "R_13_lower"}),
                      of.results({"R_13_resultant_x"})},
          .seen = {"The wedge and the rod in its collar, which answers with two forces, the rod cut free, and the "
                   "polygons of their forces",
                   "Il cuneo e l'asta nel collare, che reagisce con due forze, l'asta isolata, e i poligoni delle "
                   "loro forze"},
          .told = of.names({"P", "R_12", "R_13_upper", "R_13_lower"}),
          .without_part = of.without()};
}

}  // namespace

std::vector<SheetMaker> wedge_sheets() {
  return {
      {{"wedge",
        {"Wedge and collar", "Cuneo e collare"},
        {"A wedge lifts a rod in its collar. There is no friction. Find the force (or couple) that balances the load "
         "and all reactions by cutting the bodies free and drawing force polygons.",
         "Un cuneo solleva un'asta nel suo collare. Non c'è attrito. Trovare la forza (o la coppia) che equilibra il "
         "carico e tutte le reazioni, isolando i corpi e disegnando i poligoni delle forze."}},
       one_force},
      {{"wedge-virtual-work",
        {"Wedge: virtual work", "Cuneo: lavori virtuali"},
        {"A wedge lifts a rod in its collar. There is no friction. Find the force (or couple) that balances the load "
         "by virtual work.",
         "Un cuneo solleva un'asta nel suo collare. Non c'è attrito. Trovare la forza (o la coppia) che equilibra il "
         "carico con i lavori virtuali."}},
       virtual_work_of_wedge},
      {{"two-forces",
        {"Collar with two forces", "Collare con due forze"},
        {"A wedge lifts a rod in its collar, which answers with two forces. There is no friction. Find the force (or "
         "couple) that balances the load and all reactions by cutting the bodies free and drawing force polygons.",
         "Un cuneo solleva un'asta nel suo collare, che risponde con due forze. Non c'è attrito. Trovare la forza (o "
         "la coppia) che equilibra il carico e tutte le reazioni, isolando i corpi e disegnando i poligoni delle "
         "forze."}},
       two_forces}};
}

}  // namespace epure::ideal_statics
