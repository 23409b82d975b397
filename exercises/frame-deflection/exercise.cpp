// A frame loaded at right angles to its plane: bending and torsion, and how far its end sinks.
#include "exercises/frame-deflection/routes.h"
#include "exercises/kit/panels/displacement_plan_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/space_diagram_panel.h"
#include "exercises/kit/panels/strung_beams_panel.h"
#include "exercises/kit/panels/sum_panel.h"

namespace epure {
namespace frame_deflection {
namespace {

// With the polar moment of area for the torsion constant, which it is for circles alone.
double deflection_with_polar_moment() {
  const double L_1 = 1.2, L_2 = 0.8, phi = 0.05, s = 0.01, H = 0.05, P = 300, E = 210e9, G = E / 2.6;
  const double J_x1 = s * H * H * H / 12, J_y1 = H * s * s * s / 12, J_p1 = J_x1 + J_y1;
  const double J_x2 = 3.14159265358979323846 * phi * phi * phi * phi / 64, J_p2 = 2 * J_x2;
  return P * (2 * L_2 * L_2 * L_2 / (3 * E * J_x1) + L_1 * L_1 * L_2 / (G * J_p1) + L_1 * L_1 * L_1 / (3 * E * J_x2) +
              L_2 * L_2 * L_1 / (G * J_p2));
}

std::vector<Printed> printed_by_the_source() {
  const Words why{
      "the source takes J_p1 = J_x1 + J_y1, the polar moment of area, for the torsion constant of the rectangle; "
      "only of a circle are the two one",
      "la fonte prende J_p1 = J_x1 + J_y1, il momento polare, per la costante di torsione del rettangolo; le due "
      "coincidono soltanto per il cerchio"};
  return {{"G", "8.077×10^4 MPa", "analytic"},
          {"J_x1", "1.042×10^5 mm^4", "analytic"},
          {"J_x2", "3.068×10^5 mm^4", "analytic"},
          {"J_p2", "6.136×10^5 mm^4", "analytic"},
          {"M_z_bar_2", "240 N·m", "analytic"},
          {"U", "7.726 J", "virtual work", 0, Explanation{why, [] { return 150 * deflection_with_polar_moment(); }}},
          {"delta_A", "51.509 mm", "virtual work", 0, Explanation{why, deflection_with_polar_moment}}};
}

// Evenly spaced ordinates: at both ends and in the middle, or at the ends of a constant torque.
std::vector<DiagramOrdinate> ordinates(const Solution& s, const std::vector<Quantity>& of) {
  std::vector<DiagramOrdinate> all;
  for (const Quantity& each : of) all.push_back({s[each.name], each.name});
  return all;
}

struct SpaceEnds {
  SpacePoint from, to;
};
std::array<SpaceEnds, 3> in_space(const Solution& s) {
  const auto bars = problem(s.givens()).bars();
  std::array<SpaceEnds, 3> all;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto point = [](const geometry::Point<Rational>& P) {
      return SpacePoint{CGAL::to_double(P.x), CGAL::to_double(P.y), 0};
    };
    all[i] = {point(bars[i].from), point(bars[i].to())};
  }
  return all;
}

// By its number, with its length.
std::string named(int bar) { return std::to_string(bar) + " ($\\it{L}_{" + (bar == 2 ? "1" : "2") + "}$)"; }

SpaceDiagramPanel bending_panel(const Solution& s) {
  const auto at = in_space(s);
  const std::array<Words, 3> told{
      Words{"Cut at $ξ$ and keep the piece beyond: only $\\it{P}$ acts on it. In bar 1 $A$ stands across from $O$, "
            "so the arm along the bar is $ξ$: $\\it{M}_{f}$ = $\\it{P}$·$ξ$.",
            "Si taglia in $ξ$ e si tiene la parte oltre il taglio: vi agisce solo $\\it{P}$. Nella barra 1 $A$ sta "
            "di fronte ad $O$, il braccio lungo la barra è $ξ$: $\\it{M}_{f}$ = $\\it{P}$·$ξ$."},
      Words{
          "Bar 2: the arm is what is left of it, $\\it{M}_{f}$ = −$\\it{P}$·($\\it{L}_{1}$ + $\\it{L}_{2}$ − $ξ$).",
          "Barra 2: il braccio è quanto ne resta, $\\it{M}_{f}$ = −$\\it{P}$·($\\it{L}_{1}$ + $\\it{L}_{2}$ − $ξ$)."},
      Words{"Bar 3 likewise: $\\it{M}_{f}$ = −$\\it{P}$·($\\it{L}_{1}$ + 2$\\it{L}_{2}$ − $ξ$), zero at $A$. All are "
            "laid off on the side of the fibres in tension, positive below.",
            "Così la barra 3: $\\it{M}_{f}$ = −$\\it{P}$·($\\it{L}_{1}$ + 2$\\it{L}_{2}$ − $ξ$), nullo in $A$. Tutti "
            "si riportano dalla parte delle fibre tese, i positivi sotto."}};
  std::vector<SpaceBar> bars;
  for (int i = 1; i <= 3; ++i)
    bars.push_back({at[i - 1].from, at[i - 1].to, named(i),
                    ordinates(s, {bending(nodes[i - 1], i), bending("mid", i), bending(nodes[i], i)}), told[i - 1]});
  return {bars, {nodes.begin(), nodes.end()}, "$\\it{M}_{f}$", SpaceDiagramPanel::Positive::downwards};
}

SpaceDiagramPanel torsion_panel(const Solution& s) {
  const auto at = in_space(s);
  const std::array<Words, 3> told{
      Words{"$\\it{P}$ passes the axis of bar 1 at the distance $\\it{L}_{1}$: $\\it{M}_{t}$ = "
            "$\\it{P}$·$\\it{L}_{1}$.",
            "$\\it{P}$ passa a distanza $\\it{L}_{1}$ dall'asse della barra 1: $\\it{M}_{t}$ = "
            "$\\it{P}$·$\\it{L}_{1}$."},
      Words{
          "The axis of bar 2 at $\\it{L}_{2}$: $\\it{M}_{t}$ = $\\it{P}$·$\\it{L}_{2}$. At a corner what bends one "
          "bar twists the other, so its $\\it{M}_{t}$ is the $\\it{M}_{f}$ at the end of bar 1.",
          "L'asse della barra 2 a distanza $\\it{L}_{2}$: $\\it{M}_{t}$ = $\\it{P}$·$\\it{L}_{2}$. In un nodo ciò "
          "che inflette una barra torce l'altra: il suo $\\it{M}_{t}$ è l'$\\it{M}_{f}$ all'estremo della barra 1."},
      Words{"Bar 3 points at the load: no torque.", "L'asse della barra 3 passa per il carico: non c'è torsione."}};
  std::vector<SpaceBar> bars;
  for (int i = 1; i <= 3; ++i)
    bars.push_back({at[i - 1].from, at[i - 1].to, named(i), ordinates(s, {torsion(i), torsion(i)}), told[i - 1]});
  return {bars, {nodes.begin(), nodes.end()}, "$\\it{M}_{t}$", SpaceDiagramPanel::Positive::upwards};
}

PanelSheet moments_sheet(const Solution& s, Language language) {
  const SpaceDiagramPanel bending = bending_panel(s);
  const Words halved{
      "Lengths along $x$ and $z$ at scale, those along $y$ at 45° and halved; all ordinates upright.",
      "In scala le lunghezze lungo $x$ e $z$, a 45° e dimezzate quelle lungo $y$; tutte le ordinate in verticale."};
  const Words whole{"All lengths at scale, those along $y$ at 45°; all ordinates upright.",
                    "In scala tutte le lunghezze, a 45° quelle lungo $y$; tutte le ordinate in verticale."};
  const Words& axonometry = bending.halves_depth() ? halved : whole;
  const Words axes{
      "$\\it{M}_{f}$ bends a bar and $\\it{M}_{t}$ twists it, whichever way it lies; the clamp's couples are "
      "about the drawn axes through $O$.",
      "$\\it{M}_{f}$ inflette la barra e $\\it{M}_{t}$ la torce, comunque sia disposta; le coppie "
      "dell'incastro sono intorno agli assi disegnati, per $O$."};
  return {.panels = panels(bending, torsion_panel(s)),
          .results = {values({"R_O_z", "M_O_x", "M_O_y"}), values({"M_x_B_bar_1", "M_x_B_bar_2", "M_x_C_bar_3"}),
                      values({"M_z_bar_1", "M_z_bar_2", "M_z_bar_3"}), remark(axes.in(language)),
                      remark(axonometry.in(language))},
          .seen = {"The frame in axonometry with the diagrams of bending and torsion on its bars",
                   "Il telaio in assonometria con i diagrammi di flessione e torsione sulle barre"},
          .told = {"R_O_z", "M_O_x", "M_x_B_bar_1", "M_x_B_bar_2", "M_x_C_bar_3", "M_z_bar_1", "M_z_bar_2"},
          .without_part = {"phi", "s_r", "H_r", "E", "nu"}};
}

std::array<Place, 4> corners(const Solution& s, const std::string& of, int bar) {
  std::array<Place, 4> all;
  for (int k = 0; k < 4; ++k) all[k] = s.place(of + "_" + std::to_string(bar) + "_" + std::to_string(k));
  return all;
}

StrungBeamsPanel strung_panel(const Solution& s, Language language) {
  const std::array<std::string, 3> ends{"w_B", "delta_bending_2", "delta_bending_3"};
  std::vector<StrungBeam> beams;
  for (int i = 1; i <= 3; ++i) {
    const std::string& end = ends[i - 1];
    const double weight = s[elastic_weight(i).name];
    const bool at_start = i > 1;  // the other triangle has no height
    beams.push_back({.length = s.place("own_" + std::to_string(i) + "_3").x,
                     .from = std::string("$") + nodes[i - 1] + "$",
                     .to = std::string("$") + nodes[i] + "$",
                     .moments = {s[bending(nodes[i - 1], i).name], s[bending(nodes[i], i).name]},
                     .weights = {at_start ? weight : 0, at_start ? 0 : weight},
                     .corners = corners(s, "own", i),
                     .weight = elastic_weight(i).symbol,
                     .quantity = end,
                     .letters = s.described(end).symbol,
                     .counts_down = i > 1});
  }
  const Words areas{
      "The area of each $\\it{M}_{f}$ diagram over $\\it{EJ}$ is an elastic weight, in the line of the triangle's "
      "centroid, a third of the bar from its greater side: $α_{1}$ = $\\it{P}\\it{L}_{2}^{2}$/(2$\\it{EJ}_{x1}$) and "
      "so on.",
      "L'area di ogni diagramma $\\it{M}_{f}$ divisa per $\\it{EJ}$ è un peso elastico, sulla verticale del "
      "baricentro del triangolo, a un terzo della barra dal lato maggiore: $α_{1}$ = "
      "$\\it{P}\\it{L}_{2}^{2}$/(2$\\it{EJ}_{x1}$) e così via."};
  const Words pole{
      "The weights upright, positive upwards, and a pole $\\it{Q}$ at the distance $h$: 1 rad at the scale of the "
      "weights, times the scale of lengths over that of displacements. Ray 1 is level, ray 2 goes to the weight's "
      "end.",
      "I pesi in verticale, i positivi in su, e un polo $\\it{Q}$ alla distanza $h$: 1 rad alla scala dei pesi, per "
      "la scala delle lunghezze su quella degli spostamenti. Il raggio 1 è orizzontale, il raggio 2 va all'estremo "
      "del peso."};
  const Words strings{
      "Strings parallel to the rays meet on the weight's line. The elastic line touches the first where the bar "
      "begins and the last where it ends.",
      "I lati paralleli ai raggi si incontrano sulla verticale del peso. La linea elastica tocca il primo dove la "
      "barra comincia e l'ultimo dove finisce."};
  const Words deviation{
      "At the far end the last string shows how far the bar leaves its first tangent: $w_{B}$, $δ_{f2}$, $δ_{f3}$.",
      "All'estremo l'ultimo lato dà quanto la barra si scosta dalla prima tangente: $w_{B}$, $δ_{f2}$, $δ_{f3}$."};
  return {beams, {areas, pole, strings, deviation}, language};
}

PanelSheet strings_sheet(const Solution& s, Language language) {
  return {.panels = panels(strung_panel(s, language)),
          .results = {workshop_values({"J_x1", "J_x2"}), values({"alpha_1", "alpha_2", "alpha_3"}),
                      workshop_values({"w_B"}), workshop_values({"delta_bending_2", "delta_bending_3"})},
          .seen = {"Mohr's second funicular polygon of each bar, under its diagram of bending",
                   "Il secondo poligono funicolare di Mohr di ogni barra, sotto il diagramma della flessione"},
          .told = {"w_B", "delta_bending_2", "delta_bending_3"},
          .without_part = {"nu"}};
}

DisplacementPlanPanel plan_panel(const Solution& s) {
  const auto bar = [&](int i) {
    const std::string number = std::to_string(i);
    return PlannedBar{.corners = corners(s, "chain", i),
                      .tangent = s.place("tangent_" + number),
                      .turned = {},
                      .bends = i > 1 ? bending_share(i).name : "",
                      .bent = i > 1 ? bending_share(i).symbol : "",
                      .bending_counts_down = true,
                      .rise = rise(nodes[i]).name,
                      .end = rise(nodes[i]).symbol,
                      .end_letters = std::string("$") + nodes[i] + "$",
                      .told_turned = {},
                      .told_bent = {}};
  };
  PlannedBar first = bar(1), second = bar(2), third = bar(3);
  first.told_bent = {"Bar 1 leaves the clamp level and bends: $B$ moves by $w_{B}$.",
                     "La barra 1 esce orizzontale dall'incastro e si inflette: $B$ si sposta di $w_{B}$."};
  second.turned = "|$θ_{Bx}$|·$\\it{L}_{1}$ = $δ_{t1}$";
  second.told_turned = {
      "The twist of bar 1 turns bar 2 with $B$, by $θ_{Bx}$ = −$\\it{M}_{t1}\\it{L}_{2}$/$\\it{GJ}_{t1}$: its first "
      "tangent, with $C$, goes down by |$θ_{Bx}$|·$\\it{L}_{1}$ = $δ_{t1}$.",
      "La torsione della barra 1 fa ruotare con $B$ la barra 2, di $θ_{Bx}$ = "
      "−$\\it{M}_{t1}\\it{L}_{2}$/$\\it{GJ}_{t1}$: la sua prima tangente, in $C$, scende di |$θ_{Bx}$|·$\\it{L}_{1}$ "
      "= $δ_{t1}$."};
  second.told_bent = {"It bends away from the tangent by $δ_{f2}$ (second polygon): $w_{C}$.",
                      "Si scosta dalla tangente di $δ_{f2}$ (secondo poligono): $w_{C}$."};
  third.turned = "|$θ_{Cy}$|·$\\it{L}_{2}$";
  third.told_turned = {
      "Bar 3 turns with $C$, by $θ_{Cy}$: $α_{1}$ of bar 1 and the twist $\\it{M}_{t2}\\it{L}_{1}$/$\\it{GJ}_{p2}$ "
      "of bar 2. It begins at this slope.",
      "La barra 3 ruota con $C$, di $θ_{Cy}$: $α_{1}$ della barra 1 e la torsione "
      "$\\it{M}_{t2}\\it{L}_{1}$/$\\it{GJ}_{p2}$ della 2. Comincia con questa pendenza."};
  third.told_bent = {"It bends away by $δ_{f3}$, and the plan closes on $w_{A}$ = −$δ_{A}$.",
                     "Si scosta di $δ_{f3}$, e il diagramma si chiude su $w_{A}$ = −$δ_{A}$."};
  return {"$O$", {first, second, third}};
}

PanelSheet plan_sheet(const Solution& s, Language language) {
  const Words linear{
      "Everything is linear in $\\it{P}$: rotations count as small, and moments are those of the frame before it "
      "gives way.",
      "Tutto è lineare in $\\it{P}$: le rotazioni si trattano come piccole, e i momenti sono quelli del telaio "
      "indeformato."};
  const Words unfolded{"The bars stand one behind another in one line, unfolded, each with its length.",
                       "Le barre stanno una dopo l'altra su una retta, sviluppate, ognuna con la sua lunghezza."};
  return {.panels = panels(plan_panel(s)),
          .results = {table({"", "$θ_{x}$ (rad)", "$θ_{y}$ (rad)", "$w$ (m)"},
                            {{"$B$", {"theta_B_x", "theta_B_y", "w_B"}},
                             {"$C$", {"theta_C_x", "theta_C_y", "w_C"}},
                             {"$A$", {"theta_A_x", "theta_A_y", "w_A"}}}),
                      values({"delta_A"}), remark(unfolded.in(language)), remark(linear.in(language))},
          .seen = {"The displacement plan of the chain of bars, which closes on the displacement of A",
                   "Il piano degli spostamenti della catena di barre, che si chiude sullo spostamento di A"},
          .told = {"w_B", "w_C", "w_A", "delta_A"}};
}

PanelSheet shares_sheet(const Solution& s, Language language) {
  const auto named = [&](const Words& name, const std::string& quantity) {
    return Part{name + decimal(", " + s.described(quantity).symbol), s[quantity], quantity};
  };
  const auto unread = [](Part part) {
    part.quantity.clear();
    return part;
  };
  const auto share = [&](const std::string& of, int bar) {
    const Words kind = of == "bending" ? Words{"bending ", "flessione "} : Words{"torsion ", "torsione "};
    return named(kind + decimal(std::to_string(bar)), "delta_" + of + "_" + std::to_string(bar));
  };
  const Part f1 = share("bending", 1), t1 = share("torsion", 1), f2 = share("bending", 2), t2 = share("torsion", 2),
             f3 = share("bending", 3);
  const Part whole = named({"in all", "in tutto"}, "delta_A"),
             t1_of_source = unread(named({"torsion 1", "torsione 1"}, "delta_torsion_1_p")),
             whole_of_source = unread(named({"in all", "in tutto"}, "delta_A_p"));
  const Words shares{
      "By virtual work $δ_{fi}$ = ∫$\\it{M}_{f}m_{f}$d$ξ$/$\\it{EJ}_{xi}$ and $δ_{ti}$ = "
      "$\\it{M}_{ti}m_{ti}\\it{L}$/$\\it{GJ}_{i}$: $δ_{f1}$ = $δ_{f3}$ = "
      "$\\it{P}\\it{L}_{2}^{3}$/(3$\\it{EJ}_{x1}$), "
      "$δ_{t1}$ = $\\it{P}\\it{L}_{1}^{2}\\it{L}_{2}$/$\\it{GJ}_{t1}$, $δ_{f2}$ = "
      "$\\it{P}\\it{L}_{1}^{3}$/(3$\\it{EJ}_{x2}$), $δ_{t2}$ = $\\it{P}\\it{L}_{2}^{2}\\it{L}_{1}$/$\\it{GJ}_{p2}$.",
      "Per i lavori virtuali $δ_{fi}$ = ∫$\\it{M}_{f}m_{f}$d$ξ$/$\\it{EJ}_{xi}$ e $δ_{ti}$ = "
      "$\\it{M}_{ti}m_{ti}\\it{L}$/$\\it{GJ}_{i}$: $δ_{f1}$ = $δ_{f3}$ = "
      "$\\it{P}\\it{L}_{2}^{3}$/(3$\\it{EJ}_{x1}$), "
      "$δ_{t1}$ = $\\it{P}\\it{L}_{1}^{2}\\it{L}_{2}$/$\\it{GJ}_{t1}$, $δ_{f2}$ = "
      "$\\it{P}\\it{L}_{1}^{3}$/(3$\\it{EJ}_{x2}$), $δ_{t2}$ = $\\it{P}\\it{L}_{2}^{2}\\it{L}_{1}$/$\\it{GJ}_{p2}$."};
  const Words mistake{
      "The source takes $\\it{J}_{p1}$ = $\\it{J}_{x1}$ + $\\it{J}_{y1}$ for $\\it{J}_{t1}$. But the sections of a "
      "rectangle warp: its torsion constant is less than the polar moment, and bar 1 twists as much more.",
      "La fonte prende $\\it{J}_{p1}$ = $\\it{J}_{x1}$ + $\\it{J}_{y1}$ per $\\it{J}_{t1}$. Ma le sezioni di un "
      "rettangolo si ingobbano: la costante di torsione è minore del momento polare, e la barra 1 si torce "
      "altrettanto di più."};
  const Words series{
      "De Saint-Venant: $\\it{J}_{t1}$ = $\\it{H}_{r}s_{r}^{3}$(⅓ − (64$s_{r}$/($π^{5}\\it{H}_{r}$))·"
      "Σ tanh($kπ\\it{H}_{r}$/(2$s_{r}$))/$k^{5}$), $k$ = 1, 3, 5 …",
      "De Saint-Venant: $\\it{J}_{t1}$ = $\\it{H}_{r}s_{r}^{3}$(⅓ − (64$s_{r}$/($π^{5}\\it{H}_{r}$))·"
      "Σ tanh($kπ\\it{H}_{r}$/(2$s_{r}$))/$k^{5}$), $k$ = 1, 3, 5 …"};
  return {.panels = panels(SumPanel(
              {{.name = {"Deflection of $A$, with $\\it{J}_{t1}$", "Abbassamento di $A$, con $\\it{J}_{t1}$"},
                .parts = {f1, t1, f2, t2, f3},
                .whole = whole,
                .steps = {shares}},
               {.name = {"As the source has it, with $\\it{J}_{p1}$", "Come la fonte, con $\\it{J}_{p1}$"},
                .parts = {unread(f1), t1_of_source, unread(f2), unread(t2), unread(f3)},
                .whole = whole_of_source,
                .steps = {mistake}}},
              "m")),
          .theory = {{{"Torsion of the rectangle", "Torsione del rettangolo"}, {remark(series.in(language))}}},
          .results = {workshop_values({"J_t1", "J_p1"}), workshop_values({"J_x1", "J_x2", "J_p2"}),
                      values({"U_1", "U_2", "U_3"}), values({"U", "delta_A"}), values({"delta_A_p"})},
          .seen = {"The five shares of the deflection of A, with the torsion constant and as the source has them",
                   "Le cinque parti dell'abbassamento di A, con la costante di torsione e come le ha la fonte"},
          .told = {"delta_bending_1", "delta_torsion_1", "delta_bending_2", "delta_torsion_2", "delta_bending_3",
                   "delta_A", "U", "J_t1"}};
}

}  // namespace
}  // namespace frame_deflection

std::unique_ptr<Exercise> make_frame_deflection() {
  using namespace frame_deflection;
  Description about{
      .id = "frame-deflection",
      .title = {"A frame loaded across its plane", "Un telaio caricato fuori del piano"},
      .document = "pisa",
      .item = "Quesito 1",
      .source = {"Pisa, mid-term test of 14 June 2006, question 1",
                 "Pisa, verifica intermedia del 14/6/2006, quesito 1"},
      .question = {"A plane frame is clamped in O and loaded in A at right angles to its plane. Draw bending and "
                   "torsional moments and find how far A sinks, with the shares of bending and torsion of each bar.",
                   "Un telaio piano è incastrato in O e caricato in A perpendicolarmente al suo piano. Disegnare i "
                   "momenti flettenti e torcenti e trovare di quanto si abbassa A, con i contributi della flessione "
                   "e della torsione di ogni asta."},
      .givens = stated_givens(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{problem(givens)}, rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"moments",
         {"Bending and torsion", "Flessione e torsione"},
         {"A plane frame is clamped in O and loaded in A at right angles to its plane. Draw its bending and "
          "torsional moments.",
          "Un telaio piano è incastrato in O e caricato in A perpendicolarmente al suo piano. Disegnarne i momenti "
          "flettenti e torcenti."}},
        moments_sheet},
       {{"second-polygon",
         {"Mohr's second polygon", "Secondo poligono di Mohr"},
         {"A plane frame is clamped in O and loaded in A at right angles to its plane. Find the shares of bending in "
          "the sinking of A by Mohr's second polygon.",
          "Un telaio piano è incastrato in O e caricato in A perpendicolarmente al suo piano. Trovare i contributi "
          "della flessione all'abbassamento di A con il secondo poligono di Mohr."}},
        strings_sheet},
       {{"displacement-plan",
         {"Displacement plan", "Piano degli spostamenti"},
         {"A plane frame is clamped in O and loaded in A at right angles to its plane. Find how far A sinks by the "
          "displacement plan.",
          "Un telaio piano è incastrato in O e caricato in A perpendicolarmente al suo piano. Trovare di quanto si "
          "abbassa A con il piano degli spostamenti."}},
        plan_sheet},
       {{"shares",
         {"Five shares of the deflection", "Cinque parti dell'abbassamento"},
         {"A plane frame is clamped in O and loaded in A at right angles to its plane. Find the shares of bending "
          "and torsion of each bar in the sinking of A.",
          "Un telaio piano è incastrato in O e caricato in A perpendicolarmente al suo piano. Trovare i contributi "
          "della flessione e della torsione di ogni asta all'abbassamento di A."}},
        shares_sheet}});
}

}  // namespace epure
