// Reactions, moments and shear by the funicular polygon; the elastic line by Mohr's second polygon, and the sinking
// of the boat with the column's shortening.
#include "exercises/boat-crane/sheets.h"
#include "exercises/kit/panels/beam_panel.h"
#include "exercises/kit/panels/load_line_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::boat_crane {
namespace {

double length(const Solution& s) { return CGAL::to_double(s.givens()["L"]); }

BeamDiagram cut_free(double L, std::vector<BeamDiagram::Load> loads) {
  const Place middle{1.5 * L, -1};
  return {.letters = {{"$B$", {0, 0}, middle}, {"$C$", {L, 0}, middle}, {"$D$", {3 * L, 0}, middle}},
          .loads = std::move(loads),
          .is_beam = true};
}

BeamDiagram moments(const Solution& s) {
  const double L = length(s), y = s["moment_ordinate"], h = s["pole_distance"];
  return {.name = "$\\it{M}$",
          .runs = {{.points = {{0, 0}, {L, y}, {3 * L, 0}}, .meaning = Meaning::force, .is_area = true},
                   {.points = {{0, 0}, {L, y}}, .meaning = Meaning::force, .letter = "$b$"},
                   {.points = {{L, y}, {3 * L, 0}}, .meaning = Meaning::force, .letter = "$c$"},
                   {.points = {{0, 0}, {3 * L, 0}}, .letter = "$a$"}},
          .ordinates = {{"M_1_mid_BC", "", L / 2, y / 2, 0, h},
                        {"M_C", "$y_{C}$", L, y, 0, h},
                        {"M_1_mid_CD", "", 2 * L, y / 2, 0, h}}};
}

BeamDiagram shear(const Solution& s) {
  const double L = length(s), BC = s["T_1_BC"], CD = s["T_1_CD"];
  return {
      .of_vectors = true,
      .name = "$\\it{T}$",
      .runs = {{.points = {{0, 0}, {0, BC}, {L, BC}, {L, CD}, {3 * L, CD}, {3 * L, 0}},
                .meaning = Meaning::force,
                .is_area = true}},
      .ordinates = {{"T_1_BC", "$\\it{T}_{BC}$", L / 2, 0, BC, 1}, {"T_1_CD", "$\\it{T}_{CD}$", 2 * L, 0, CD, 1}}};
}

LoadLinePanel force_plan(const Solution& s, Language language) {
  const double P = s["P"], b = -s["Y_B"], h = s["pole_distance"];
  return LoadLinePanel(
      {.unit = "N",
       .forces = {{"P", "$\\it{P}$", 0, -P},
                  {"Y_A", "$\\it{Y}_{A}$", -P, b, 1, true},
                  {"Y_B", "$\\it{Y}_{B}$", b, 0, 2, true}},
       .pole = Place{-h, 0},
       .pole_distance = "$h$ = " + figures(h, 4, language) + " N",
       .rays = {{0, "$a$"}, {-P, "$c$"}, {b, "$b$"}},
       .steps = {{{"$\\it{P}$ = $\\it{W}_{b}g$ laid off; a pole $O$ level with its tail, at the distance $h$; the "
                   "rays $a$ and $c$ to tail and tip.",
                   "Riportato $\\it{P}$ = $\\it{W}_{b}g$; un polo $O$ al livello della sua coda, a distanza $h$; i "
                   "raggi $a$ e $c$ alla coda e alla punta."},
                  {-h, 0}},
                 {{"The ray parallel to the closing line $b$ parts the load line: $\\it{Y}_{A}$ closes "
                   "from the tip of $\\it{P}$ to $b$, $\\it{Y}_{B}$ from $b$ to its tail.",
                   "Il raggio parallelo alla chiudente $b$ divide la retta delle forze: "
                   "$\\it{Y}_{A}$ va dalla punta di $\\it{P}$ a $b$, $\\it{Y}_{B}$ da $b$ alla coda."},
                  {0, b},
                  true}}});
}

}  // namespace

PanelSheet reactions_sheet(const Solution& s, Language language) {
  const double L = length(s), y = s["moment_ordinate"];
  BeamPanel beam(3 * L,
                 {cut_free(L, {{"$\\it{R}_{B}$", 0, -1}, {"$\\it{Y}_{A}$", L, 1}, {"$\\it{P}$", 3 * L, -1, true}}),
                  moments(s), shear(s)},
                 {.unit = "N", .longest = s["P"] + s["R_B"], .longest_on_paper = 60});
  beam.lines_at({0, L, 3 * L});
  beam.step(1, {3 * L, 0},
            {"From the line of $\\it{P}$ the strings: $a$ to the line of $B$, $c$ to that of $C$, each parallel to "
             "its ray.",
             "Dalla retta di $\\it{P}$ i lati: $a$ fino alla retta di $B$, $c$ fino a quella di $C$, paralleli ai "
             "raggi."})
      .step(1, {L, y},
            {"The closing line $b$ joins them. Moments are ordinates over $a$ times $h$: $\\it{M}_{C}$ = "
             "−$h$·$y_{C}$, on the side of the fibres in tension.",
             "La chiudente $b$ li unisce. I momenti sono le ordinate su $a$ per $h$: $\\it{M}_{C}$ = −$h$·$y_{C}$, "
             "dalla parte delle fibre tese."})
      .last_step(
          2, {2 * L, s["T_1_CD"]},
          {"The shear: −$\\it{R}_{B}$ up to $C$, there it jumps by $\\it{Y}_{A}$ to $\\it{P}$. ($\\it{N}$ = 0.)",
           "Il taglio: −$\\it{R}_{B}$ fino a $C$, dove salta di $\\it{Y}_{A}$ fino a $\\it{P}$. ($\\it{N}$ = 0.)"});
  const std::string h = figures(s["pole_distance"], 4, language);
  const Words scale =
      Words{"$\\it{M}_{BC}$, $\\it{M}_{CD}$: in the middle of $BC$ and $CD$. An ordinate of 1 m is worth ",
            "$\\it{M}_{BC}$, $\\it{M}_{CD}$: a metà di $BC$ e $CD$. Un'ordinata di 1 m vale "} +
      Words{h, h} + Words{" N m.", " N m."};
  const Words directions{"On crane and beam the arrows show directions, in the plan of forces sizes too.",
                         "Su gru e trave le frecce danno le direzioni, nel piano delle forze anche le intensità."};
  const Words doubled{
      "With 600 kg, as the source computes, the same figure holds when a centimetre is taken for 600 "
      "kg/$\\it{W}_{b}$ times the force.",
      "Con 600 kg, come calcola la fonte, vale la stessa figura se un centimetro si conta per 600 kg/$\\it{W}_{b}$ "
      "volte la forza."};
  return {.panels = panels(loaded_crane(s), force_plan(s, language), beam),
          .results = {values({"P", "Y_A"}), values({"Y_B", "R_B", "X_B"}), values({"T_1_BC", "T_1_CD"}),
                      values({"M_1_mid_BC", "M_1_mid_CD"}), values({"M_C", "N_2"}), remark(scale.in(language)),
                      remark(directions.in(language)), remark(doubled.in(language))},
          .seen = {"The crane, its beam cut free, the plan of forces with pole and rays, the funicular polygon as "
                   "diagram of moments, and the shear beneath",
                   "La gru, la trave isolata, il piano delle forze con polo e raggi, il poligono funicolare come "
                   "diagramma dei momenti, e sotto il taglio"},
          .told = {"P", "Y_A", "Y_B", "M_C", "T_1_BC", "T_1_CD"},
          .without_part = {"s_1", "H_1", "b_1", "s_2", "H_2", "b_2", "sigma_S", "Delta_sigma_L", "Psi", "E"}};
}

namespace {

BeamDiagram elastic_line(const Solution& s) {
  const double L = length(s), n = s["enlargement"], C = s["axis_at_C"], end = s["tangent_at_D"];
  const double xi = s["xi_v_max_BC"], top = C * xi / L + n * s["v_max_BC"];
  // The tangents meet under the centroids of the areas.
  const Place B{0, 0}, V{2 * L / 3, 0}, on_C{L, C}, W{5 * L / 3, C * 3}, D{3 * L, end};
  const double sunk = end + n * s["v_D_carried"];
  constexpr double beside = 6;  // mm
  return {.name = "$nv$",
          .runs = {{.points = {B, V}, .letter = "$t_{B}$", .away_from = on_C},
                   {.points = {V, W}, .letter = "$t_{C}$"},
                   {.points = {W, D}, .letter = "$t_{D}$"},
                   {.points = {B, {3 * L, 3 * C}}, .meaning = Meaning::axis},
                   {.points = {B, {L / 3, 0}, V, on_C}, .meaning = Meaning::locus, .is_cubic = true},
                   {.points = {on_C, W, {7 * L / 3, W.y + (end - W.y) / 2}, D},
                    .meaning = Meaning::locus,
                    .is_cubic = true}},
          .ordinates = {{"v_max_BC", "$nv_{max}$", xi, C * xi / L, top, 1 / n},
                        {"v_D_bending", "$nv_{D,f}$", 3 * L, 3 * C, end, 1 / n},
                        {"", "$nv_{D,r}$", 3 * L, end, sunk, 1 / n, false, Meaning::velocity},
                        {"v_D", "$nv_{D}$", 3 * L, 3 * C, sunk, 1 / n, false, Meaning::force, beside}}};
}

LoadLinePanel weights(const Solution& s, Language language) {
  const double BC = s["moment_area_BC"], CD = s["moment_area_CD"], d = s["elastic_pole_distance"];
  return LoadLinePanel(
      {.unit = "N m²",
       .forces = {{"moment_area_BC", "$\\it{Ω}_{BC}$", 0, BC, 0, true},
                  {"moment_area_CD", "$\\it{Ω}_{CD}$", BC, BC + CD, 0, true}},
       .pole = Place{-d, 0},
       .pole_distance = "$\\it{EJ}_{x1}/n$ = " + figures(d, 4, language) + " N m²",
       .rays = {{0, "$t_{B}$"}, {BC, "$t_{C}$"}, {BC + CD, "$t_{D}$"}},
       .steps = {
           {{"The areas $\\it{Ω}$ of the diagram of moments laid off as forces; pole distance $\\it{EJ}_{x1}/n$.",
             "Le aree $\\it{Ω}$ del diagramma dei momenti riportate come forze; distanza polare $\\it{EJ}_{x1}/n$."},
            {-d, 0}}}});
}

// The beam turns about B as a rigid body as far as C follows the column's head.
LoadLinePanel williot(const Solution& s) {
  constexpr double mm = 1000;
  const double c = -mm * s["column_shortening"], d = mm * s["v_D_carried"];
  return LoadLinePanel(
      {.unit = "mm",
       .si = 1 / mm,
       .forces = {{"column_shortening", "$Δ\\it{H}$", 0, c, 0, false, Meaning::velocity, "$c'$"},
                  {"", "$v_{D,r}$", 0, d, 1, false, Meaning::velocity, "$d'$"}},
       .start = "$b'$",
       .tells_scale = true,
       .steps = {{{"Williot's plan: $B$ stays at $b'$; $C$ goes down by the column's shortening $Δ\\it{H}$ = "
                   "$\\it{Y}_{A}\\it{H}_{0}$/($\\it{EA}_{2}$).",
                   "Diagramma di Williot: $B$ resta in $b'$; $C$ scende dell'accorciamento della colonna $Δ\\it{H}$ "
                   "= $\\it{Y}_{A}\\it{H}_{0}$/($\\it{EA}_{2}$)."},
                  {0, c},
                  true},
                 {{"$b'c'd'$ is similar to $BCD$: the rigid beam carries $D$ three times as far down, by $v_{D,r}$.",
                   "$b'c'd'$ è simile a $BCD$: la trave rigida porta $D$ tre volte più giù, di $v_{D,r}$."},
                  {1, d},
                  true}}});
}

}  // namespace

PanelSheet elastic_sheet(const Solution& s, Language language) {
  const double L = length(s), C = s["axis_at_C"];
  BeamDiagram areas = cut_free(L, {{"$\\it{Ω}_{BC}$", 2 * L / 3, -1}, {"$\\it{Ω}_{CD}$", 5 * L / 3, -1}});
  areas.runs = {
      {.points = {{0, 0}, {L, s["moment_ordinate"]}, {3 * L, 0}}, .meaning = Meaning::force, .is_area = true}};
  areas.ordinates = {{"M_C", "$\\it{M}_{C}$", L, s["moment_ordinate"], 0, s["pole_distance"]}};
  BeamPanel beam(3 * L, {areas, elastic_line(s)});
  beam.lines_at({0, 2 * L / 3, L, 5 * L / 3, 3 * L});
  beam.step(0, {2 * L / 3, 0},
            {"The areas $\\it{Ω}$ act in the centroids of the triangles of moments.",
             "Le aree $\\it{Ω}$ agiscono nei baricentri dei triangoli dei momenti."})
      .step(
          1, {5 * L / 3, 3 * C},
          {"Strings parallel to the rays: the tangents of the elastic line at $B$, $C$ and $D$, $n$ times enlarged.",
           "Lati paralleli ai raggi: le tangenti della linea elastica in $B$, $C$ e $D$, ingrandite $n$ volte."})
      .step(1, {L, C},
            {"The undeformed beam runs through $B$ and $C$; from it the deflections.",
             "La trave indeformata passa per $B$ e $C$; da essa si misurano gli abbassamenti."})
      .step(1, {s["xi_v_max_BC"], C * s["xi_v_max_BC"] / L + s["enlargement"] * s["v_max_BC"]},
            {"$v_{max}$ where the tangent is parallel to it, at $ξ_{v}$ = $\\it{L}$/√3.",
             "$v_{max}$ dove la tangente le è parallela, a $ξ_{v}$ = $\\it{L}$/√3."})
      .last_step(1, {3 * L, s["tangent_at_D"]},
                 {"The boat goes down by bending and with the column: $v_{D}$ = $v_{D,f}$ + $v_{D,r}$.",
                  "La barca scende per flessione e con la colonna: $v_{D}$ = $v_{D,f}$ + $v_{D,r}$."});
  return {.panels = panels(weights(s, language), williot(s), beam),
          .results = {values({"M_C"}), values({"moment_area_BC", "moment_area_CD"}), values({"theta_B", "theta_C"}),
                      values({"theta_D", "xi_v_max_BC"}), workshop_values({"J_x1"}),
                      workshop_values({"v_max_BC", "v_D_bending"}), workshop_values({"column_shortening", "v_D"}),
                      remark("$n$ = " + short_number(s["enlargement"], language))},
          .seen = {"The elastic line of the beam by Mohr's second funicular polygon, and Williot's plan of the "
                   "column's shortening",
                   "La linea elastica della trave con il secondo poligono funicolare di Mohr, e il diagramma di "
                   "Williot dell'accorciamento della colonna"},
          .told = {"theta_B", "theta_C", "theta_D", "v_max_BC", "v_D_bending", "column_shortening", "v_D"},
          .without_part = {"sigma_S", "Delta_sigma_L", "Psi"}};
}

}  // namespace epure::boat_crane
