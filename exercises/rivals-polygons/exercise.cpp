// Rivals' theorem on the centred slider-crank: velocity and acceleration of B, then of a point G of the coupler, by
// vector polygons that are built one step a picture.
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/rivals-polygons/pictures.h"
#include "exercises/rivals-polygons/routes.h"

namespace epure {
namespace rivals_polygons {
namespace {

std::vector<GivenSpec> givens() {
  return {{"r", {"crank A₀A", "manovella A₀A"}, "m", "0.2", Range::positive, "$r$"},
          {"l", {"coupler AB", "biella AB"}, "m", "0.5", Range::positive, "$l$"},
          {"AG", {"distance of G from A, towards B", "distanza di G da A, verso B"}, "m", "0.25", Range::any, "$AG$"},
          {"n",
           {"crank speed, counter-clockwise", "velocità della manovella, antioraria"},
           "rpm",
           "360",
           Range::any,
           "$n$"},
          {"alpha_2",
           {"angular acceleration of the crank", "accelerazione angolare della manovella"},
           "rad/s^2",
           "0",
           Range::any,
           "$α_{2}$"},
          {"phi",
           {"crank angle from the outer dead centre", "angolo di manovella dal punto morto esterno"},
           "deg",
           "30",
           Range::any,
           "$φ$"}};
}

// How the coupler turns is drawn beside it, or how its rotation grows.
struct CouplerArc {
  std::string rate, symbol;
};
const CouplerArc rotation{"omega_3", "$ω_{3}$"}, growth{"alpha_3", "$α_{3}$"};

std::shared_ptr<const Mechanism> mechanism(const Solution& s, const CouplerArc& arc) {
  using Joint = Mechanism::Joint;
  const Instant instant(s.givens());
  const double r = CGAL::to_double(instant.crank.lengths.r), b = s.place("B").x;
  Mechanism linkage;
  linkage.point("A0", s.place("A0"), Joint::fixed, "$A_{0}$")
      .point("A", s.place("A"), Joint::hinge, "$A$")
      .point("B", s.place("B"), Joint::block, "$B$")
      .point("G", s.place("G"), Joint::none, "$G$")
      .body({"A0", "A"}, 2)
      .body({"A", "B"}, 3)
      .body({"A", "G"})  // beyond A or B, when G lies there
      .guide("B", 0)
      .axis({std::min(-r, b), 0}, {std::max(r, b), 0})
      .path("A0", "A")
      .angle("A0", 0, std::fmod(geometry::to_double(instant.crank.crank), 2 * std::numbers::pi), "$φ$")
      .turning("A0", "A", sign_of(instant.crank.n), "$ω_{2}$");
  if (s[arc.rate] != 0) linkage.turning_found("A", "B", s[arc.rate], arc.symbol);
  return std::make_shared<const Mechanism>(std::move(linkage));
}

PolygonSide v_A(const Solution& s) { return side(s, velocity("A"), "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "$a'$"); }

// An unknown side has a line, which its vector does not tell when it is zero.
PolygonSide on_line(PolygonSide side, const Arrow2& along) {
  side.along = along;
  return side;
}
PolygonSide after_normal_part(PolygonSide side) {
  side.square = true;
  return side;
}
Arrow2 across_AB(const Solution& s) { return geometry::quarter_turn(s.place("B") - s.place("A")); }
constexpr Arrow2 guide{1, 0};

VectorPolygon velocity_of_B(const Solution& s) {
  return velocity_polygon({on_line(side(s, velocity("B"), "∥ $A_{0}B$", "?"), guide)},
                          {v_A(s), on_line(side(s, velocity("BA"), "⊥ $BA$", "?", "$b'$"), across_AB(s))});
}

VectorPolygon velocity_of_G(const Solution& s) {
  return velocity_polygon({side(s, velocity("G"), "?", "?")},
                          {v_A(s), side(s, velocity("GA"), "⊥ $GA$", "|$ω_{3}$|·$AG$", "$g'$")});
}

// a_A in its two parts, of which the second is none at constant speed; then what is relative to A.
VectorPolygon accelerations(const Solution& s, const PolygonSide& sought, const PolygonSide& normal,
                            const PolygonSide& tangential) {
  const bool speeds_up = Instant(s.givens()).crank_speeds_up();
  return acceleration_polygon(
      {sought}, {side(s, normal_acceleration("A"), "∥ $AA_{0}$", "$ω^{2}_{2}$·$A_{0}A$", speeds_up ? "" : "$a'$"),
                 after_normal_part(side(s, tangential_acceleration("A"), speeds_up ? "⊥ $A_{0}A$" : "–",
                                        speeds_up ? "|$α_{2}$|·$A_{0}A$" : "0", "$a'$")),
                 normal, after_normal_part(tangential)});
}

VectorPolygon acceleration_of_B(const Solution& s) {
  return accelerations(s, on_line(side(s, acceleration("B"), "∥ $A_{0}B$", "?"), guide),
                       side(s, normal_acceleration("BA"), "∥ $BA$", "$ω^{2}_{3}$·$AB$"),
                       on_line(side(s, tangential_acceleration("BA"), "⊥ $BA$", "?", "$b'$"), across_AB(s)));
}

VectorPolygon acceleration_of_G(const Solution& s) {
  return accelerations(s, side(s, acceleration("G"), "?", "?"),
                       side(s, normal_acceleration("GA"), "∥ $GA$", "$ω^{2}_{3}$·$AG$"),
                       side(s, tangential_acceleration("GA"), "⊥ $GA$", "|$α_{3}$|·$AG$", "$g'$"));
}

// The quantities of the sides, in their order.
std::vector<std::string> told(const VectorPolygon& polygon) {
  std::vector<std::string> names;
  for (const auto* chain : {&polygon.right, &polygon.left})
    for (const PolygonSide& side : *chain)
      if (side.is_drawn()) names.push_back(side.quantity);
  return names;
}

PanelSheet sheet(const Solution& s, const CouplerArc& arc, const VectorPolygon& polygon,
                 const std::vector<int>& figures, const Words& seen, const Words& formula, Language language) {
  std::vector<std::string> rates{"omega_2", rotation.rate};
  if (arc.rate != rotation.rate) rates.push_back(arc.rate);
  PanelSheet shown{
      .panels = panels(MechanismPanel(mechanism(s, arc))),
      .results = {values(rates), values({polygon.left.front().quantity}),
                  remark(formula.in(language) +
                         Words{" Counter-clockwise is positive.", " Positivi in verso antiorario."}.in(language))},
      .seen = seen,
      .told = told(polygon)};
  add_pictures(shown.panels, polygon, figures);
  return shown;
}

const Words omega_3_from_polygon = {"$ω_{2}$ = 2π·$n$/60; |$ω_{3}$| = $v_{BA}$ / $AB$.",
                                    "$ω_{2}$ = 2π·$n$/60; |$ω_{3}$| = $v_{BA}$ / $AB$."};
const Words alpha_3_from_polygon = {"$ω_{2}$ = 2π·$n$/60; |$α_{3}$| = $a^{t}_{BA}$ / $AB$.",
                                    "$ω_{2}$ = 2π·$n$/60; |$α_{3}$| = $a^{t}_{BA}$ / $AB$."};

PanelSheet velocity_of_B_sheet(const Solution& s, Language language) {
  return sheet(s, rotation, velocity_of_B(s), {2, 3, 4},
               {"The slider-crank, and the polygon of the velocities of B in three pictures",
                "Il manovellismo, e il poligono delle velocità di B in tre figure"},
               omega_3_from_polygon, language);
}

PanelSheet velocity_of_G_sheet(const Solution& s, Language language) {
  return sheet(s, rotation, velocity_of_G(s), {5, 6, 7, 8},
               {"The slider-crank, and the polygon of the velocities of G in four pictures",
                "Il manovellismo, e il poligono delle velocità di G in quattro figure"},
               {"$ω_{2}$ = 2π·$n$/60; $ω_{3}$ from the velocity of $B$ (sheet 1).",
                "$ω_{2}$ = 2π·$n$/60; $ω_{3}$ dalla velocità di $B$ (tavola 1)."},
               language);
}

PanelSheet acceleration_of_B_sheet(const Solution& s, Language language) {
  PanelSheet shown = sheet(s, growth, acceleration_of_B(s), {9, 10},
                           {"The slider-crank, and the polygon of the accelerations of B, a step a picture",
                            "Il manovellismo, e il poligono delle accelerazioni di B, un passo per figura"},
                           alpha_3_from_polygon, language);
  const std::string wrong = figures(s["a_B_as_printed"], 4, language), right = figures(s["a_B"], 4, language);
  shown.results.push_back(
      remark(format_words("Remark. The source's equation (1) has $\\vec{{a}}_{{A}}$ besides $\\vec{{a}}^{{n}}_{{A}}$ "
                          "+ $\\vec{{a}}^{{t}}_{{A}}$, which are its parts. Drawn so, it would give "
                          "$a^{{(1)}}_{{B}}$ = {} m/s² instead of $a_{{B}}$ = {} m/s². Its table 3 has it right.",
                          "Osservazione. La (1) della fonte ha $\\vec{{a}}_{{A}}$ oltre ad $\\vec{{a}}^{{n}}_{{A}}$ "
                          "+ $\\vec{{a}}^{{t}}_{{A}}$, che ne sono le parti. Disegnata così darebbe "
                          "$a^{{(1)}}_{{B}}$ = {} m/s² invece di $a_{{B}}$ = {} m/s². La sua tabella 3 è giusta.",
                          wrong, right)
                 .in(language)));
  return shown;
}

PanelSheet acceleration_of_G_sheet(const Solution& s, Language language) {
  return sheet(s, growth, acceleration_of_G(s), {},
               {"The slider-crank, and the polygon of the accelerations of G, a step a picture",
                "Il manovellismo, e il poligono delle accelerazioni di G, un passo per figura"},
               {"$ω_{2}$ = 2π·$n$/60; $α_{3}$ from the acceleration of $B$ (sheet 3).",
                "$ω_{2}$ = 2π·$n$/60; $α_{3}$ dall'accelerazione di $B$ (tavola 3)."},
               language);
}

Description description() {
  return {
      .id = "rivals-polygons",
      .title = {"Slider-crank: Rivals' theorem", "Manovellismo: teorema di Rivals"},
      .document = "macchine",
      .item = "Teoremi di Rivals e Coriolis",
      .source = {"Machines, exercises: Theorems of Rivals and Coriolis",
                 "Macchine, esercizi: Teoremi di Rivals e Coriolis"},
      .question =
          {"Find velocity and acceleration of B and of G by Rivals' theorem, adding vectors one by one.",
           "Trovare velocità e accelerazione di B e di G con il teorema di Rivals, sommando i vettori uno per uno."},
      .givens = givens(),
      .printed = {}};  // the source solves it in letters
}

}  // namespace
}  // namespace rivals_polygons

std::unique_ptr<Exercise> make_rivals_polygons() {
  using namespace rivals_polygons;
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{Instant(givens)}, rung); };
  return exercise_of_panels(
      description(), solve,
      {{{"velocity-of-B",
         {"Velocity of B, step by step", "Velocità di\u00a0B, passo per passo"},
         {"Find the velocity of B by Rivals' theorem, adding vectors one by one.",
          "Trovare la velocità di B con il teorema di Rivals, sommando i vettori uno per uno."}},
        velocity_of_B_sheet},
       {{"velocity-of-G",
         {"Velocity of G, step by step", "Velocità di\u00a0G, passo per passo"},
         {"Find the velocity of G by Rivals' theorem, adding vectors one by one.",
          "Trovare la velocità di G con il teorema di Rivals, sommando i vettori uno per uno."}},
        velocity_of_G_sheet},
       {{"acceleration-of-B",
         {"Acceleration of B, step by step", "Accelerazione di\u00a0B, passo per passo"},
         {"Find the acceleration of B by Rivals' theorem, adding vectors one by one.",
          "Trovare l'accelerazione di B con il teorema di Rivals, sommando i vettori uno per uno."}},
        acceleration_of_B_sheet},
       {{"acceleration-of-G",
         {"Acceleration of G, step by step", "Accelerazione di\u00a0G, passo per passo"},
         {"Find the acceleration of G by Rivals' theorem, adding vectors one by one.",
          "Trovare l'accelerazione di G con il teorema di Rivals, sommando i vettori uno per uno."}},
        acceleration_of_G_sheet}});
}

}  // namespace epure
