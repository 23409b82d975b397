// Fairbairn's mechanism: polygons of lever and crank, and virtual work by the pole of crank and lever.
#include <cmath>
#include <numbers>

#include "exercises/ideal-statics/sheets.h"
#include "exercises/kit/linkages/loaded_figures.h"
#include "exercises/kit/linkages/shared_out.h"

namespace epure::ideal_statics {
namespace {

using Arrow = FreeBodyPanel::Arrow;
using Joint = Mechanism::Joint;

PanelSheet polygons(const Solution& s, const std::string& name) {
  const Case of(s, name);
  const Place A = of.place("A"), B = of.place("B"), C = of.place("C"), D = of.place("D");
  PolygonSide F = of.load("F", "∥ $x$", "$a$");
  F.label = force_between(5, 4).arrow();
  const PolygonSide R_34 = of.sought(force_between(3, 4), "⊥ $CD$", "$b$"),
                    R_14 = of.sought(force_between(1, 4), "∥ $CH$"), R_32 = reversed(R_34, 3, 2),
                    R_12 = of.sought(force_between(1, 2), "∥ $\\it{R}_{32}$");
  FreeBodyPanel on_4 = lever_cut_free(of), on_2 = crank_cut_free(of);
  on_4.to_scale().load(F, D).force(R_34, B, Arrow::ends).force(R_14, C, Arrow::ends);
  const auto H = of.point("H");
  std::optional<SharedOut> shared;
  if (is_out_of_reach(H, B, C, D)) shared.emplace(F, D, R_34, B, R_14, C);
  if (!shared) on_4.meeting(of.name("H"), "$H$", H);
  on_2.to_scale().larger().at_most(200).force(R_32, B).force(R_12, A);
  on_2.couple("$\\it{M}$", A, of["M"]).arm(A, B, R_32.v, "$d$", of.name("d"));
  FreeBodyPanel all(fairbairn_figure(of)), on_6 = ram_cut_free(of);
  all.at_most(100);
  const PolygonSide load = of.load("F", "", ""), R_56 = reaction(load, force_between(5, 6).arrow(), "$\\it{F}$");
  on_6.to_scale().at_most(50).load(load, end_of_ram(of)).force(R_56, D);
  on_6.step({"The ram is held by $\\vec{\\it{F}}$ and the slot's force alone, both along $x$ through $D$: "
             "$\\vec{\\it{R}}_{56}$ = −$\\vec{\\it{F}}$.",
             "La slitta è in equilibrio per la $\\vec{\\it{F}}$ e la forza della guida a croce, entrambe lungo $x$ "
             "per $D$: $\\vec{\\it{R}}_{56}$ = −$\\vec{\\it{F}}$."},
            D);
  const Words ram{
      "On the lever $\\vec{\\it{R}}_{54}$ = $\\vec{\\it{F}}$. Block 3 presses square to the lever, in $B$.",
      "Sulla leva $\\vec{\\it{R}}_{54}$ = $\\vec{\\it{F}}$. Il corsoio 3 preme in $B$, normale alla leva."};
  on_4.step(shared ? ram : ram + decimal(" ") + meet_in_H, shared ? D : *H);
  if (shared) shared->draw_strings(on_4);
  on_2.moments({"Crank: $\\vec{\\it{R}}_{32}$ and $\\vec{\\it{R}}_{12}$ are a couple with the arm $d$; $\\it{M}$ = "
                "$\\it{R}_{32}$·$d$.",
                "Manovella: la $\\vec{\\it{R}}_{32}$ e la $\\vec{\\it{R}}_{12}$ sono una coppia di braccio $d$; "
                "$\\it{M}$ = $\\it{R}_{32}$·$d$."},
               A);
  Panels shown = panels(all, on_6, on_4, on_2);
  if (shared)
    shown.push_back(std::make_unique<SharedLoadPanel>(shared->polygon("−" + F.label)));
  else
    shown.push_back(std::make_unique<PolygonPanel>(s, force_polygon("4", {R_14}, {F, R_34})));
  return {.panels = std::move(shown),
          .results = {of.results({"F_23", "d", "M"}), of.results({"R_14", "R_12"})},
          .seen = {"Fairbairn's mechanism, its ram, lever and crank cut free, and the triangle of the lever's forces",
                   "La guida di Fairbairn, slitta, leva e manovella isolate, e il triangolo delle forze della leva"},
          .told = of.names({"F_23", "d", "M", "R_14", "R_12"}),
          .without_part = of.without()};
}

// ω2 = 1 rad/s.
PanelSheet virtual_work(const Solution& s, const std::string& name) {
  const Case of(s, name);
  const Place A = of.place("A"), B = of.place("B"), C = of.place("C"), D = of.place("D"), P24 = of.place("P24");
  Mechanism drawn;
  drawn.point("C", C, Joint::fixed, "$C$")
      .point("A", A, Joint::fixed, "$A$")
      .point("B", B, Joint::corner, "")
      .point("end", end_of_lever(of), Joint::corner, "")
      .point("P24", P24, Joint::none, "$P_{24}$")
      .body({"A", "B"}, 2)
      .body({"C", "end"}, 4)
      .axis(C, P24)
      .axis(B, P24)
      .right_angle("B", "P24", "C");
  FreeBodyPanel poles(with_ram(std::move(drawn), of));
  poles.step({"The normal to the lever in $B$ meets the line $CA$ in $P_{24}$: crank and lever have one velocity "
              "there, $ω_{2}$·$P_{24}A$ = $ω_{4}$·$P_{24}C$. Velocities are laid off for $ω_{2}$ = 1 rad/s.",
              "La normale alla leva in $B$ incontra la retta $CA$ in $P_{24}$: vi hanno la stessa velocità manovella "
              "e leva, $ω_{2}$·$P_{24}A$ = $ω_{4}$·$P_{24}C$. Le velocità si riportano per $ω_{2}$ = 1 rad/s."},
             P24);
  poles.load(of.load("F", "", ""), D);
  const Arrow2 crank = B - A, frame = C - A;
  poles.couple("$\\it{M}$", A, of["M"], {std::atan2(crank.y, crank.x), std::atan2(frame.y, frame.x)});
  poles.step(
      {"$\\it{M}$·$ω_{2}$ = $\\it{F}$·$v_{D6}$: the couple supplies what the force takes. This gives $\\it{M}$.",
       "$\\it{M}$·$ω_{2}$ = $\\it{F}$·$v_{D6}$: la coppia fornisce quel che la forza prende. Ciò dà la $\\it{M}$."},
      D);
  const std::string v_D4 = "$v_{B4}$·$CD$/$CB$";
  ChainedPolygonsPanel velocities(velocity_polygon(
      {of.moves("B4", "⊥ $CD$", "?")},
      {of.moves("B2", "⊥ $AB$", "$ω_{2}$·$AB$", "$b_{2}$"), of.moves("B42", "∥ $CD$", "?", "$b_{4}$")}));
  velocities.then(velocity_polygon({of.moves("D6", "∥ $x$", "?")}, {of.moves("D5", "⊥ $CD$", v_D4, "$d_{5}$"),
                                                                    of.moves("D65", "⊥ $x$", "?", "$d_{6}$")}),
                  {0, 0});
  return {.panels = panels(poles, velocities),
          .results = {of.results({"P24C", "P24A"}), of.results({"omega_4_over_omega_2", "v_D6_over_omega_2"}),
                      of.results({"M_virtual_work"}), for_comparison(of.results({"M"}))},
          .seen = {"Fairbairn's mechanism with the pole of crank and lever, and the polygons of velocities",
                   "La guida di Fairbairn con il polo di manovella e leva, e i poligoni delle velocità"},
          .told = of.names({"P24C", "P24A", "omega_4_over_omega_2", "v_D6_over_omega_2", "M_virtual_work"}),
          .without_part = of.without()};
}

}  // namespace

std::vector<SheetMaker> fairbairn_sheets() {
  return {
      {{"fairbairn",
        {"Fairbairn's mechanism", "Guida di Fairbairn"},
        {"Fairbairn's mechanism carries its load. There is no friction. Find the force (or couple) that balances the "
         "load and all reactions by cutting the bodies free and drawing force polygons.",
         "La guida di Fairbairn porta il suo carico. Non c'è attrito. Trovare la forza (o la coppia) che equilibra "
         "il carico e tutte le reazioni, isolando i corpi e disegnando i poligoni delle forze."}},
       [](const Solution& s, Language) { return polygons(s, "fairbairn"); }},
      {{"fairbairn-virtual-work",
        {"Fairbairn's mechanism: virtual work", "Guida di Fairbairn: lavori virtuali"},
        {"Fairbairn's mechanism carries its load. There is no friction. Find the force (or couple) that balances the "
         "load by virtual work.",
         "La guida di Fairbairn porta il suo carico. Non c'è attrito. Trovare la forza (o la coppia) che equilibra "
         "il carico con i lavori virtuali."}},
       [](const Solution& s, Language) { return virtual_work(s, "fairbairn"); }},
      {{"fairbairn-short-lever",
        {"Fairbairn's mechanism, shorter lever", "Guida di Fairbairn, leva più corta"},
        {"Fairbairn's mechanism with the shorter lever carries its load. There is no friction. Find the force (or "
         "couple) that balances the load and all reactions by cutting the bodies free and drawing force polygons.",
         "La guida di Fairbairn con la leva più corta porta il suo carico. Non c'è attrito. Trovare la forza (o la "
         "coppia) che equilibra il carico e tutte le reazioni, isolando i corpi e disegnando i poligoni delle "
         "forze."}},
       [](const Solution& s, Language) { return polygons(s, "fairbairn_short_lever"); }}};
}

}  // namespace epure::ideal_statics
