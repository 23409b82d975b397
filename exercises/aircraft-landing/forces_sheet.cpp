// The forces on aircraft and wheel at touch-down, and after the wheel has taken hold.
#include "exercises/aircraft-landing/landing.h"
#include "exercises/aircraft-landing/sheets.h"
#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::aircraft_landing {
namespace {

// Level and upright sides in turn: weight and flaps down, friction and drag back, the reaction up; the inertia force
// closes. Flaps that lift act upwards, and friction that has to slow down the wheel acts forwards.
VectorPolygon around(const Solution& s, const std::string& letter, const std::string& v, const std::string& N,
                     const std::string& F, const std::string& a, const std::string& prime) {
  const Landing of(s.givens());
  const double M = CGAL::to_double(of.M()), g = CGAL::to_double(of.g), square = s[v] * s[v];
  const double c_x = CGAL::to_double(of.c_x), c_y = CGAL::to_double(of.c_y);
  const bool at_first = N == "N_0", lifts = of.c_y < 0, is_forwards = s[F] < 0;
  const auto force = [](std::string quantity, std::string label, std::string direction, std::string magnitude,
                        Arrow2 along) {
    return PolygonSide{.quantity = std::move(quantity),
                       .label = std::move(label),
                       .direction = std::move(direction),
                       .magnitude = std::move(magnitude),
                       .v = along,
                       .length = epure::magnitude(along)};
  };
  std::vector<PolygonSide> right{
      force("", "$\\vec{\\it{P}}$", "↓", "$\\it{M}g$", {0, -M * g}),
      force(at_first ? "F_y_0" : "", "$\\vec{\\it{F}}_{y}$", lifts ? "↑" : "↓",
            lifts ? "|$c_{y}$|$v^{2}$" : "$c_{y}v^{2}$", {0, -c_y * square}),
      force(F, "$\\vec{\\it{F}}" + prime + "$", is_forwards ? "→" : "←",
            at_first      ? "$f_{r}\\it{N}$"
            : is_forwards ? "|$\\it{F}'$|"
                          : "$\\it{F}'$",
            {-s[F], 0}),
      force(at_first ? "F_x_0" : "", "$\\vec{\\it{F}}_{x}$", "←", "$c_{x}v^{2}$", {-c_x * square, 0}),
      force(N, "$\\vec{\\it{N}}$", "↑", lifts ? "$\\it{P}$ − |$\\it{F}_{y}$|" : "$\\it{P}+\\it{F}_{y}$", {0, s[N]})};
  const PolygonSide inertia{.label = "−$\\it{M}\\vec{a}" + prime + "$",
                            .direction = "?",
                            .magnitude = "?",
                            .v = {-M * s[a], 0},
                            .length = M * std::abs(s[a])};
  return force_polygon(letter, {inertia}, std::move(right));
}

// The aircraft as a box on its wheel, going to the right, with the forces of its polygon.
FreeBodyPanel cut_free(const Solution& s, const VectorPolygon& polygon) {
  using Joint = Mechanism::Joint;
  using Arrow = FreeBodyPanel::Arrow;
  const double R = CGAL::to_double(Landing(s.givens()).R), half = 3 * R, low = 2 * R, high = 4 * R;
  const Place middle{0, 3 * R};
  Mechanism drawn;
  drawn.point("C", {0, 0}, Joint::none, "").point("G", {0, R}, Joint::mass, "").disc("G", "C", true);
  drawn.point("1", {-half, low}, Joint::corner, "")
      .point("2", {half, low}, Joint::corner, "")
      .point("3", {half, high}, Joint::corner, "")
      .point("4", {-half, high}, Joint::corner, "")
      .point("leg", {0, low}, Joint::corner, "")
      .body({"G", "leg"})
      .body({"1", "2", "3", "4"});
  FreeBodyPanel body(std::make_shared<const Mechanism>(std::move(drawn)));
  const std::vector<PolygonSide>& on = polygon.right;
  body.force(on[0], middle)
      .force(on[1], {-half / 2, high}, Arrow::ends)
      .force(on[2], just_above_ground(R))
      .force(on[3], {half, middle.y}, Arrow::ends)
      .force(on[4], {s["u"], 0}, Arrow::ends)
      .force(polygon.left.front(), middle);
  return body;
}

}  // namespace

PanelSheet forces_sheet(const Solution& s, Language language) {
  const Words moments{
      "$\\it{M}$ = $m_{a}$ + $m_{r}$. Moments about the hub, $\\it{N}$ standing $u$ = $f_{v}\\it{R}$ ahead: "
      "$\\it{J}_{r}α$ = $\\it{F}\\it{R}$ − $\\it{N}u$. As soon as $ω\\it{R}$ = $v$ the wheel rolls; then friction "
      "only keeps it in step, and falls to $\\it{F}'$ = $\\it{J}_{r}a'$/$\\it{R}^{2}$ + $f_{v}\\it{N}$.",
      "$\\it{M}$ = $m_{a}$ + $m_{r}$. Momenti rispetto al mozzo, con $\\it{N}$ avanti di $u$ = $f_{v}\\it{R}$: "
      "$\\it{J}_{r}α$ = $\\it{F}\\it{R}$ − $\\it{N}u$. Appena $ω\\it{R}$ = $v$ la ruota rotola; allora l'attrito la "
      "tiene solo al passo e scende a $\\it{F}'$ = $\\it{J}_{r}a'$/$\\it{R}^{2}$ + $f_{v}\\it{N}$."};
  const Words grip = s["adheres"] == 1 ? Words{"|$\\it{F}'$| ≤ $f_{a}\\it{N}$: the wheel adheres.",
                                               "|$\\it{F}'$| ≤ $f_{a}\\it{N}$: la ruota aderisce."}
                                       : Words{"|$\\it{F}'$| > $f_{a}\\it{N}$: the wheel does not adhere.",
                                               "|$\\it{F}'$| > $f_{a}\\it{N}$: la ruota non aderisce."};
  const Words upwards = Landing(s.givens()).c_y < 0
                            ? Words{"$\\it{F}_{y0}$ < 0: counted downwards, it acts upwards.",
                                    "$\\it{F}_{y0}$ < 0: contata verso il basso, agisce verso l'alto."}
                            : Words{};
  ChainedPolygonsPanel rolling(around(s, "2", "v_s", "N_s", "F_after", "a_after", "'"));
  rolling.likewise({"Once the wheel rolls, likewise, with the friction $\\vec{\\it{F}}'$ that keeps it in step and "
                    "the acceleration $\\vec{a}'$.",
                    "Quando la ruota rotola, allo stesso modo, con l'attrito $\\vec{\\it{F}}'$ che la tiene al passo "
                    "e l'accelerazione $\\vec{a}'$."},
                   {0, 0});
  const Words names{
      "$\\vec{\\it{P}}$ weight, $\\vec{\\it{F}}_{y}$ and $\\vec{\\it{F}}_{x}$ downward force and drag of the flaps, "
      "$\\vec{\\it{F}}$ friction, $\\vec{\\it{N}}$ reaction of the ground.",
      "$\\vec{\\it{P}}$ peso, $\\vec{\\it{F}}_{y}$ e $\\vec{\\it{F}}_{x}$ forza verso il basso e resistenza dei "
      "flap, "
      "$\\vec{\\it{F}}$ attrito, $\\vec{\\it{N}}$ reazione del terreno."};
  const VectorPolygon first = around(s, "1", "v_0", "N_0", "F_0", "a_0", "");
  return {
      .panels = panels(cut_free(s, first), PolygonPanel(s, first), rolling),
      .results = {remark(names.in(language)), values({"F_x_0", "F_y_0"}), remark(upwards.in(language)),
                  values({"N_0", "F_0"}), values({"a_0", "omega_dot_0"}), remark(moments.in(language)),
                  values({"N_s", "F_after"}), remark(sense_after(s).in(language)),
                  values({"a_after", "F_after_over_N"}), values({"u"}), remark(grip.in(language))},
      .seen = {"The aircraft with its forces, and their polygons at touch-down and after the wheel has taken hold",
               "L'aereo con le sue forze, e i loro poligoni al contatto e dopo che la ruota ha aderito"},
      .told = {"N_0", "F_0", "a_0", "N_s", "F_after", "a_after"},
      .without_part = {"Delta_t"}};
}

}  // namespace epure::aircraft_landing
