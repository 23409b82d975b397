// Pin in a slot: a slotted lever hinged at O drives a disc, at whose centre B a pin is fixed, along the guide on
// which it rolls. Velocities and accelerations by construction, forces by Newton and Euler, the couple by the balance
// of powers too.
#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/sum_panel.h"
#include "exercises/pin-in-slot/printed.h"
#include "exercises/pin-in-slot/relative_pole_panel.h"
#include "exercises/pin-in-slot/routes.h"

namespace epure {
namespace pin_in_slot {
namespace {

using Joint = Mechanism::Joint;

double sense(const Angle& clockwise) { return -sign_of(clockwise); }

// With arc arrows for a rate of the lever and one of the disc.
std::shared_ptr<const Mechanism> mechanism(const Solution& s, const std::string& of_disc, const std::string& symbol) {
  const Place O = s.place("O"), B = s.place("B"), D = s.place("D");
  const double R = B.y;
  Mechanism drawn;
  drawn.point("O", O, Joint::fixed, "$O$")
      .point("A", s.place("A"), Joint::mass, "$A$")
      .point("B", B, Joint::hinge, "$B$")
      .point("D", D, Joint::none, "$D$")
      .slotted({"A", "O", "B"}, 2)
      .disc("B", "D", true, 3)
      .axis(O, D)
      .axis({std::min(O.x, B.x - R), R}, {B.x + R, R}, "$y$ = $\\it{R}$")
      .angle("O", 0, s["lever_angle"], "$α$")
      .turning("O", "B", sense(s.givens().angle("omega")), "$ω$")
      .turning_found("B", "D", s[of_disc], symbol);
  return std::make_shared<const Mechanism>(std::move(drawn));
}

const Words along_guide{"∥ guide", "∥ guida"}, upright{"vertical", "verticale"};

// An unknown of known direction; where it is zero, its line is drawn all the same.
PolygonSide unknown(const Solution& s, const VectorQuantity& quantity, const std::string& direction,
                    const Arrow2& along, const std::string& tip = {}) {
  PolygonSide side = epure::side(s, quantity, direction, "?", tip);
  side.along = along;
  return side;
}

// Of what is not reported: no ruler reads it.
PolygonSide drawn(const Solution& s, const VectorQuantity& quantity, const std::string& direction,
                  const std::string& magnitude, const std::string& tip = {}) {
  PolygonSide side = epure::side(s, quantity, direction, magnitude, tip);
  side.quantity.clear();
  return side;
}

Section signs(Language language) {
  return {{"Signs", "Segni"},
          {remark(Words{
              "Counter-clockwise is positive: $ω_{2}$ = −$ω$, $α_{2}$ = −d$ω$/d$t$, as $ω$, d$ω$/d$t$ and $\\it{C}$ "
              "are the source's, clockwise. Components with their sign: $v_{B}$, $a_{B}$ along the guide, $v_{rel}$, "
              "$a_{rel}$ along the slot, away from $O$.",
              "Positivo il verso antiorario: $ω_{2}$ = −$ω$, $α_{2}$ = −d$ω$/d$t$, perché $ω$, d$ω$/d$t$ e $\\it{C}$ "
              "sono quelle della fonte, orarie. Componenti con il loro segno: $v_{B}$, $a_{B}$ lungo la guida, "
              "$v_{rel}$, $a_{rel}$ lungo l'asola, uscendo da $O$."}
                      .in(language))}};
}

PanelSheet velocity_sheet(const Solution& s, Language language) {
  const Arrow2 slot = s.vector("slot");
  const VectorPolygon polygon = velocity_polygon(
      {unknown(s, v_B(), along_guide.in(language), {1, 0})},
      {side(s, v_Bstar(), "⊥ $OB$", "|$ω$|·$OB$", "$b*$"), unknown(s, v_rel(), "∥ $OB$", slot, "$b'$")});
  return {.panels = panels(RelativePolePanel(s, mechanism(s, "omega_disc", "$ω_{3}$")), PolygonPanel(s, polygon)),
          .theory = {signs(language)},
          .results = {remark(Words{"sin $α$ = $\\it{R}$ / $OB$", "sen $α$ = $\\it{R}$ / $OB$"}.in(language)),
                      values({"lever_angle"}), values({"v_B", "b_dot", "omega_disc"})},
          .seen = {"The slotted lever with the disc it rolls, and the polygon of the velocities of the pin B",
                   "Il glifo con il disco che fa rotolare, e il poligono delle velocità del piolo B"},
          .told = {"v_B", "b_dot", "omega_disc"},
          .without_part = {"M1", "M2", "J2", "omega_dot", "g"}};
}

// The tangential part first: so neighbours are square to each other, and a_cor never runs back over it.
VectorPolygon accelerations(const Solution& s, Language language) {
  PolygonSide coriolis = side(s, a_cor(), "⊥ $OB$", "2|$ω$·$v_{rel}$|", "$c$");
  coriolis.square = true;
  VectorPolygon polygon = acceleration_polygon(
      {unknown(s, a_B(), along_guide.in(language), {1, 0})},
      {drawn(s, a_Bstar_t(), "⊥ $OB$", "|d$ω$/d$t$|·$OB$"), drawn(s, a_Bstar_n(), "∥ $BO$", "$ω^{2}$·$OB$"), coriolis,
       unknown(s, a_rel(), "∥ $OB$", s.vector("slot"), "$b'$")});
  polygon.images = {{.absolute = side(s, a_Bstar(), {}, {}, "$b*$"),
                     .relative = {},
                     .explained = {"$\\vec{a}_{B*}$, from $O_{a}$ to $b*$, has the first two as its parts.",
                                   "La $\\vec{a}_{B*}$, da $O_{a}$ a $b*$, ha per parti le prime due."}}};
  return polygon;
}

PanelSheet acceleration_sheet(const Solution& s, Language language) {
  const Words remarks{
      "$\\vec{a}_{cor}$ is $\\vec{v}_{rel}$ turned by 90° in the sense of $ω$, times 2|$ω$|. The disc's pole $D$ "
      "stays below $B$, so $a_{B}$ = −$α_{3}$·$\\it{R}$.",
      "$\\vec{a}_{cor}$ è $\\vec{v}_{rel}$ ruotata di 90° nel verso di $ω$, moltiplicata per 2|$ω$|. Il polo $D$ del "
      "disco resta "
      "sotto $B$, perciò $a_{B}$ = −$α_{3}$·$\\it{R}$."};
  return {.panels = panels(MechanismPanel(mechanism(s, "alpha_disc", "$α_{3}$")),
                           PolygonPanel(s, accelerations(s, language))),
          .theory = {signs(language)},
          .results = {values({"b_dot", "b_ddot"}), values({"a_B", "alpha_disc"}), remark(remarks.in(language))},
          .seen = {"The polygon of the accelerations of the pin B, with the Coriolis acceleration",
                   "Il poligono delle accelerazioni del piolo B, con l'accelerazione di Coriolis"},
          .told = {"a_B", "b_ddot", "alpha_disc"},
          .without_part = {"M1", "M2", "J2", "g"}};
}

struct Forces {
  PolygonSide T_13, F_B, W_B, R_23, N_13;  // on the disc
  PolygonSide R_32, W_A, F_A, R_12;        // on the lever
};
Forces forces(const Solution& s, Language language) {
  const std::string &guide = along_guide.in(language), &vertical = upright.in(language);
  const PolygonSide R_23 = unknown(s, pin_in_slot::R_23(), "⊥ $OB$", geometry::quarter_turn(s.vector("slot")), "$e$");
  return {.T_13 = side(s, T_13(), guide, "$\\it{J}_{B}$|$α_{3}$|/$\\it{R}$"),
          .F_B = drawn(s, inertia_force("B"), guide, "$\\it{M}_{B}$|$a_{B}$|"),
          .W_B = drawn(s, weight("B"), vertical, "$\\it{M}_{B}g$"),
          .R_23 = R_23,
          .N_13 = unknown(s, N_13(), vertical, {0, 1}),
          .R_32 = reaction(R_23, "$\\vec{\\it{R}}_{32}$", "$\\it{R}_{23}$"),
          .W_A = drawn(s, weight("A"), vertical, "$\\it{M}_{A}g$"),
          .F_A = drawn(s, inertia_force("A"), "∥ $\\vec{a}_{A}$", "$\\it{M}_{A}a_{A}$", "$l$"),
          .R_12 = side(s, R_12(), "?", "?")};
}

FreeBodyPanel disc_cut_free(const Solution& s, const Forces& on) {
  using Arrow = FreeBodyPanel::Arrow;
  const Place B = s.place("B"), D = s.place("D");
  Mechanism disc;
  disc.point("B", B, Joint::hinge, "$B$").point("D", D, Joint::none, "$D$").disc("B", "D", false, 3);
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(disc)));
  panel.force(on.W_B, B).force(on.F_B, B).force(on.R_23, B, Arrow::ends);
  panel.force(on.T_13, D).force(on.N_13, D, Arrow::ends);
  if (s.givens()["J2"] != 0) panel.couple("−$\\it{J}_{B}α_{3}$", B, -s["alpha_disc"]);
  panel.moments({"The disc cut free. Moments about $B$: $\\it{T}_{13}$·$\\it{R}$ = $\\it{J}_{B}$|$α_{3}$|.",
                 "Il disco isolato. Momenti in $B$: $\\it{T}_{13}$·$\\it{R}$ = $\\it{J}_{B}$|$α_{3}$|."},
                D);
  return panel;
}

FreeBodyPanel lever_cut_free(const Solution& s, const Forces& on) {
  const Place O = s.place("O"), A = s.place("A"), B = s.place("B");
  Mechanism lever;
  lever.point("O", O, Joint::hinge, "$O$")
      .point("A", A, Joint::mass, "$A$")
      .point("B", B, Joint::none, "$B$")
      .slotted({"A", "O", "B"}, 2);
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(lever)));
  panel.force(on.W_A, A).force(on.F_A, A).force(on.R_32, B, FreeBodyPanel::Arrow::ends).force(on.R_12, O);
  panel.couple("$\\it{C}$", O, -s["C"], {direction(O, A), direction(O, B)});
  // The disc, when it is braked, drives the lever on.
  const std::string moments = "$\\it{C}$ = " + std::string(on.R_23.v.x < 0 ? "−" : "") +
                              "$\\it{R}_{23}$·$OB$ + $\\it{W}_{A}$·$AO$ cos $α$ + $\\it{M}_{A}$·$AO^{2}$·d$ω$/d$t$.";
  panel.moments(
      Words{"The lever cut free; its moments about $O$, clockwise: ", "Il glifo isolato; i momenti in $O$, orari: "} +
          moments,
      O);
  return panel;
}

Result friction(const Solution& s, Language language) {
  if (s.value("required_friction_coefficient"))
    return remark(Words{"To roll without slipping it takes $f$ ≥ $f_{min}$ = $\\it{T}_{13}$/$\\it{N}_{13}$.",
                        "Senza strisciare rotola se $f$ ≥ $f_{min}$ = $\\it{T}_{13}$/$\\it{N}_{13}$."}
                      .in(language));
  return remark(
      Words{"$\\it{N}_{13}$ ≤ 0: the guide would have to hold the disc down. It cannot, and the disc lifts off.",
            "$\\it{N}_{13}$ ≤ 0: la guida dovrebbe trattenere il disco. Non può, e il disco si stacca."}
          .in(language));
}

PanelSheet forces_sheet(const Solution& s, Language language) {
  const Forces on = forces(s, language);
  const Words letters{
      "$\\vec{\\it{W}}$: weights; $\\vec{\\it{F}}$ = −$\\it{M}\\vec{a}$: inertia; $\\vec{\\it{R}}_{23}$: of 2 on 3. "
      "On the bodies "
      "they show directions only.",
      "$\\vec{\\it{W}}$: pesi; $\\vec{\\it{F}}$ = −$\\it{M}\\vec{a}$: inerzia; $\\vec{\\it{R}}_{23}$: del 2 sul 3. "
      "Sui corpi "
      "mostrano solo le direzioni."};
  return {.panels = panels(disc_cut_free(s, on),
                           PolygonPanel(s, force_polygon("3", {on.N_13}, {on.T_13, on.F_B, on.W_B, on.R_23})),
                           lever_cut_free(s, on),
                           PolygonPanel(s, force_polygon("2", {on.R_12}, {on.R_32, on.W_A, on.F_A}))),
          .results = {components(acceleration("A")),
                      values({"slot_force_on_pin", "ground_normal_force", "ground_friction_force"}),
                      values({"pivot_force", "C", "required_friction_coefficient"}), friction(s, language),
                      remark(letters.in(language))},
          .seen = {"Disc and lever cut free, and the polygons of their forces",
                   "Disco e glifo isolati, e i poligoni delle loro forze"},
          .told = {"slot_force_on_pin", "ground_normal_force", "ground_friction_force", "pivot_force", "C"}};
}

// v_B/ω over OB: the parabola OB²/R, and the straight line that meets it at this instant.
drawings::Chart v_B_over_OB(const Solution& s, Language language) {
  const double R = s.place("B").y, b = CGAL::to_double(s.givens()["OB"]), far = 1.6 * b, k = b / R;
  constexpr int pieces = 200;
  drawings::Curve parabola{
      .name = "v_B_true", .runs = {{}}, .meaning = Meaning::velocity, .label = "$OB^{2}$/$\\it{R}$"};
  for (int i = 0; i <= pieces; ++i) {
    const double x = R + (far - R) * i / pieces;
    parabola.runs.back().push_back({x, x * x / R});
  }
  drawings::Curve straight{.name = "v_B_constant_k",
                           .runs = {{{R, k * R}, {far, k * far}}},
                           .meaning = Meaning::velocity,
                           .line = drawings::LineType::dashed,
                           .label = "$k$·$OB$"};
  const Words now{"now", "ora"};
  return {.x = {.quantity = "$OB$", .unit = "m", .low = R, .high = far},
          .y = {.quantity = "$v_{B}$/$ω$", .unit = "m", .low = 0, .high = far * far / R},
          .curves = {parabola, straight},
          .markers = {{.at = {b, k * b}, .label = now.in(language), .meaning = Meaning::velocity}}};
}

// C as a sum of torques, as it is and as the source has it.
std::vector<Sum> balances(const Solution& s) {
  const Part of_M1{{"inertia of $\\it{M}_{A}$", "inerzia di $\\it{M}_{A}$"}, s["of_M1"]};
  const Part of_weight{{"weight of $\\it{M}_{A}$", "peso di $\\it{M}_{A}$"}, s["gravity_torque"], "gravity_torque"};
  const auto of_disc = [&](const std::string& name) {
    return Part{{"inertia of the disc", "inerzia del disco"}, s[name]};
  };
  const Words C = decimal("$\\it{C}$");
  const Words right = decimal("$v_{B}$ = $ω$·$OB^{2}$/$\\it{R}$"),
              mistaken = decimal("$v_{B}$ = $k$·$ω$·$OB$, ") + Words{"$k$ constant", "$k$ costante"};
  return {{.name = right,
           .parts = {of_M1, of_disc("of_disc"), of_weight},
           .whole = {C, s["C"], "C"},
           .steps = {{"Divided by $ω$ the balance reads $\\it{C}$ as a sum of torques. At every instant sin $α$ = "
                      "$\\it{R}$/$OB$, so that $v_{B}$ = $ω$·$OB$/sin $α$ = $ω$·$OB^{2}$/$\\it{R}$: the parabola.",
                      "Diviso per $ω$, il bilancio dà $\\it{C}$ come somma di coppie. In ogni istante sen $α$ = "
                      "$\\it{R}$/$OB$, quindi $v_{B}$ = $ω$·$OB$/sen $α$ = $ω$·$OB^{2}$/$\\it{R}$: la parabola."}}},
          {.name = mistaken,
           .parts = {of_M1, of_disc("of_disc_k"), {of_weight.name, of_weight.value}},
           .whole = {C, s["C_k"]},
           .steps = {{"The source puts $v_{B}$ = $k$·$ω$·$OB$ into $\\it{E}_{k}$, with $k$ = 1/sin $α$, which holds "
                      "at this instant only, and differentiates as if $k$ were constant. The straight line meets the "
                      "parabola here, but rises half as steeply: half of the term in $v_{rel}$ is lost.",
                      "La fonte pone $v_{B}$ = $k$·$ω$·$OB$ in $\\it{E}_{k}$, con $k$ = 1/sen $α$, che vale solo in "
                      "questo istante, e deriva come se $k$ fosse costante. La retta incontra qui la parabola, ma "
                      "sale la metà: si perde metà del termine in $v_{rel}$."}}}};
}

PanelSheet balance_sheet(const Solution& s, Language language) {
  return {.panels = panels(ChartPanel(v_B_over_OB(s, language)), SumPanel(balances(s), "N m")),
          .theory = {{{"Balance", "Bilancio"},
                      {remark("$\\it{C}$·$ω$ − $\\it{M}_{A}g$·$AO$ cos $α$·$ω$ = d$\\it{E}_{k}$/d$t$"),
                       remark("$\\it{E}_{k}$ = ½($\\it{M}_{A}$·$AO^{2}$·$ω^{2}$ + ($\\it{M}_{B}$ + "
                              "$\\it{J}_{B}$/$\\it{R}^{2}$)·$v^{2}_{B}$)")}}},
          .results = {values({"kinetic_energy", "kinetic_power"}), values({"C"})},
          .seen = {"The couple C by the balance of powers, correct and with the source's mistake, and v_B/ω over OB, "
                   "where they part",
                   "La coppia C dal bilancio delle potenze, corretto e con l'errore della fonte, e v_B/ω in funzione "
                   "di OB, dove si separano"},
          .told = {"C", "kinetic_energy", "kinetic_power"}};
}

}  // namespace
}  // namespace pin_in_slot

std::unique_ptr<Exercise> make_pin_in_slot() {
  using namespace pin_in_slot;
  Description about{
      .id = "pin-in-slot",
      .title = {"Pin in a slot: lever and rolling disc", "Glifo e disco che rotola"},
      .document = "glifo",
      .item = "1",
      .source = {"Slotted lever (glifo), exercise 1", "Glifo, primo esercizio"},
      .question =
          {"A slotted lever moves a rolling disc by the disc's pin $B$. Find velocities and accelerations with "
           "Coriolis' theorem, and the driving torque by force polygons and by the balance of powers.",
           "Il glifo muove per mezzo del perno $B$ il disco che rotola. Trovare velocità e accelerazioni con il "
           "teorema di Coriolis, e la coppia motrice con i poligoni delle forze e con il bilancio delle potenze."},
      .givens = stated_givens(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{instant(givens)}, rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"kinematics",
         {"Velocities", "Velocità"},
         {"A slotted lever moves a rolling disc by the disc's pin $B$. Find the velocities with the theorem of "
          "relative motion.",
          "Il glifo muove per mezzo del perno $B$ il disco che rotola. Trovare le velocità con il teorema dei moti "
          "relativi."}},
        velocity_sheet},
       {{"acceleration",
         {"Accelerations", "Accelerazioni"},
         {"A slotted lever moves a rolling disc by the disc's pin $B$. Find the accelerations with Coriolis' "
          "theorem.",
          "Il glifo muove per mezzo del perno $B$ il disco che rotola. Trovare le accelerazioni con il teorema di "
          "Coriolis."}},
        acceleration_sheet},
       {{"forces",
         {"Forces (Newton-Euler)", "Forze (Newton-Eulero)"},
         {"A slotted lever moves a rolling disc by the disc's pin $B$. Find the driving torque by force polygons.",
          "Il glifo muove per mezzo del perno $B$ il disco che rotola. Trovare la coppia motrice con i poligoni "
          "delle forze."}},
        forces_sheet},
       {{"power-balance",
         {"Balance of powers", "Bilancio delle potenze"},
         {"A slotted lever moves a rolling disc by the disc's pin $B$. Find the driving torque by the balance of "
          "powers.",
          "Il glifo muove per mezzo del perno $B$ il disco che rotola. Trovare la coppia motrice con il bilancio "
          "delle potenze."}},
        balance_sheet}});
}

}  // namespace epure
