#include "exercises/slider-crank-velocity/exercise.h"

#include <fmt/format.h>

#include "exercises/kit/linkages/slider_crank_mechanism.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/slider-crank-velocity/routes.h"

namespace epure {
namespace slider_crank_velocity {
namespace {

using Where = PolesStep::Where;

std::vector<PolesStep> steps_of_poles(const Solution& s, Language language) {
  const std::string phi = short_number(s["crank_angle_phi_deg"], language);
  std::vector<PolesStep> steps{
      {{fmt::format("Crank at $φ$ = {}°. $A$ on its circle, $B$ on the guide by the arc of radius $l$ about $A$.",
                    phi),
        fmt::format(
            "Manovella a $φ$ = {}°. $A$ sulla sua circonferenza, $B$ sulla guida con l'arco di raggio $l$ da $A$.",
            phi)},
       Where::point,
       "A"},
      {{"$C$ by the arcs $AC$ and $BC$, on the left of $AB$. $M$ halves $AB$.",
        "$C$ con gli archi $AC$ e $BC$, a sinistra di $AB$. $M$ è il punto medio di $AB$."},
       Where::point,
       "C"},
      {{"$A$ moves perpendicularly to the crank: $P_{0}$ lies on the line $A_{0}A$.",
        "$A$ si muove normalmente alla manovella: $P_{0}$ sta sulla retta $A_{0}A$."},
       Where::ray,
       "A"}};
  const auto add = [&](const Words& text, Where where, const std::string& of = {}) {
    steps.push_back({text, where, of});
  };
  if (!s.point("P0")) {
    add({"The perpendicular to the guide through $B$ is parallel to it: $P_{0}$ is at infinity.",
         "La normale alla guida per $B$ le è parallela: $P_{0}$ è all'infinito."},
        Where::ray, "B");
    add({"The coupler translates: $ω_{3}$ = 0, and every point has the velocity of $A$.",
         "La biella trasla: $ω_{3}$ = 0, e ogni punto ha la velocità di $A$."},
        Where::tip, "C");
    return steps;
  }
  add({"$B$ moves along the guide: $P_{0}$ lies on the perpendicular to it through $B$.",
       "$B$ si muove lungo la guida: $P_{0}$ sta sulla normale alla guida per $B$."},
      Where::ray, "B");
  add({"$v_{A}$ = |$ω_{2}$|·$A_{0}A$, |$ω_{3}$| = $v_{A}$ / $P_{0}A$.",
       "$v_{A}$ = |$ω_{2}$|·$A_{0}A$, |$ω_{3}$| = $v_{A}$ / $P_{0}A$."},
      Where::tip, "A");
  add({"$v_{X}$ = |$ω_{3}$|·$P_{0}X$, perpendicular to the ray $P_{0}X$.",
       "$v_{X}$ = |$ω_{3}$|·$P_{0}X$, normale al raggio $P_{0}X$."},
      Where::tip, "C");
  return steps;
}

PanelSheet poles_sheet(const Solution& s, Language language) {
  const SliderCrankInstant instant = slider_crank_instant(s.givens());
  PolesPanel::Kind kind = PolesPanel::of_velocity("P0");
  kind.longest_on_paper = 32;  // mm: reads well and stays clear of the other points
  kind.times_smaller = 2.6;    // one standard scale
  PolesPanel poles(s, slider_crank_mechanism(s, instant), kind, {"A", "B", "C", "M"}, steps_of_poles(s, language));
  poles.on_lines({{s.place("A0"), "A"}, {s.place("B"), "B"}}).turning(s.value("omega_3").value_or(0), "$ω_{3}$");
  const Place A = s.place("A"), B = s.place("B"), C = s.place("C");
  return {.panels = panels(FoundByArcs(std::move(poles), {{A, B}, {A, C}, {B, C}})),
          .results = {values({"omega_2", "omega_3"}),
                      by_point({"A", "B", "C", "M"}, {{"$P_{0}X$ (m)", "P0{}"}, {"$v_{X}$ (m/s)", "v_{}"}}),
                      remark(swing_in_words(s, language))},
          .seen = {"The slider-crank, its pole P₀ by two lines, and the velocities of A, B, C and M perpendicular to "
                   "their rays",
                   "Il manovellismo, il polo P₀ con due rette, e le velocità di A, B, C e M normali ai loro raggi"},
          .told = {"crank_angle_phi_deg", "omega_3", "P0_x", "P0_y", "v_A", "v_B", "v_C", "v_M"}};
}

VectorPolygon velocities(const Solution& s, const SliderCrankInstant& instant, Language language) {
  VectorPolygon polygon = velocity_polygon({side(s, velocity("B"), parallel_to_guide(instant, language), "?")},
                                           {side(s, velocity("A"), "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "$a'$"),
                                            side(s, velocity("BA"), "⊥ $BA$", "?", "$b'$")});
  polygon.images = {
      image(
          s, velocity("C"), velocity("CA"), "$c'$",
          {"$c'$: perpendicular to $AC$ through $a'$, perpendicular to $BC$ through $b'$. The triangle $a'b'c'$ is "
           "the image of $ABC$.",
           "$c'$: normale ad $AC$ per $a'$, normale a $BC$ per $b'$. Il triangolo $a'b'c'$ è l'immagine di $ABC$."}),
      image(s, velocity("M"), velocity("MA"), "$m'$",
            {"$m'$ halves $a'b'$, as $M$ halves $AB$.", "$m'$ è il punto medio di $a'b'$, come $M$ di $AB$."})};
  polygon.images.back().relative.label.clear();  // it lies on v_BA
  polygon.images.push_back({.absolute = {.v = s.vector("v_C")},
                            .relative = {.label = velocity("CB").arrow(), .v = s.vector("v_C") - s.vector("v_B")}});
  return polygon;
}

// What a ruler reads on the diagram beside what the method of poles has found.
class DiagramBesidePoles : public PolygonPanel {
 public:
  DiagramBesidePoles(const Solution& solution, VectorPolygon polygon)
      : PolygonPanel(solution, std::move(polygon)), solution_(solution) {}

  std::optional<MeasuredTable> measured(const Readings& readings) const override {
    MeasuredTable table{{"Comparison of the two methods", "Confronto dei due metodi"},
                        {},
                        {"poles", "poli"},
                        {"diagram, on the sheet", "diagramma, sul foglio"}};
    for (const char* name : {"v_A", "v_BA", "v_B", "v_CA", "v_C", "v_M"})
      if (const auto by_poles = solution_.value(name, "poles"); by_poles && readings.is_unit(name))
        table.rows.push_back({solution_.described(name).symbol + " (m/s)", *by_poles, readings[name]});
    return table;
  }

 private:
  const Solution& solution_;
};

// Asked of who solves the sheet; the solved one tells them in the table of the diagram.
Result told_in_the_table(const std::vector<std::string>& names) {
  return {[](const Solution&, Language) { return std::nullopt; }, names};
}

PanelSheet polar_diagram_sheet(const Solution& s, Language language) {
  const SliderCrankInstant instant = slider_crank_instant(s.givens());
  DiagramBesidePoles polygon(s, velocities(s, instant, language));
  polygon.with_equations({{{{"$\\vec{v}_{C}$", "?", "?", ""},
                            {"$\\vec{v}_{A}$", "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "="},
                            {"$\\vec{v}_{CA}$", "⊥ $CA$", "|$ω_{3}$|·$CA$", "+"}}},
                          {{{"$\\vec{v}_{M}$", "?", "?", ""},
                            {"$\\vec{v}_{A}$", "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "="},
                            {"$\\vec{v}_{MA}$", "⊥ $MA$", "|$ω_{3}$|·$MA$", "+"}}}});
  return {
      .panels = panels(
          MechanismPanel(slider_crank_mechanism(s, instant, {s.value("omega_3").value_or(0), "$ω_{3}$"})), polygon),
      .results = {value_as("|$ω_{3}$| = $v_{BA}$ / $AB$,  $ω_{3}$", "omega_3"), told_in_the_table({"v_A", "v_B"}),
                  told_in_the_table({"v_C", "v_M"})},
      .seen = {"The polygon of the velocities of the slider-crank, with the images of C and M",
               "Il poligono delle velocità del manovellismo, con le immagini di C e M"},
      .told = {"v_A", "v_BA", "v_B", "v_C", "v_M"}};
}

Description description() {
  return {.id = "slider-crank-velocity",
          .title = {"Slider-crank: velocities", "Manovellismo: velocità"},
          .document = "sapienza",
          .item = "N.1",
          .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.1",
                     "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.1"},
          .question = {"At the given instant find the velocities by the method of poles and by the polar diagram; "
                       "draw the fixed and the moving polode of the coupler and the path of its point C.",
                       "All'istante dato trovare le velocità con il metodo dei poli e con il diagramma polare; "
                       "tracciare la polare fissa e la polare mobile della biella e la traiettoria del suo punto C."},
          .givens = slider_crank_givens(false),
          .printed = printed_by_the_source};
}

}  // namespace
}  // namespace slider_crank_velocity

std::unique_ptr<Exercise> make_slider_crank_velocity() {
  using namespace slider_crank_velocity;
  const auto solve = [](const Givens& givens, Rung rung) {
    return settle(VelocityRoutes{slider_crank_instant(givens)}, rung);
  };
  return exercise_of_panels(
      description(), solve,
      {{{"poles",
         {"Method of poles", "Metodo dei poli"},
         {"At the given instant find the velocities by the method of poles.",
          "All'istante dato trovare le velocità con il metodo dei poli."}},
        poles_sheet},
       {{"polar-diagram",
         {"Polar diagram of velocity", "Diagramma polare delle velocità"},
         {"At the given instant find the velocities by the polar diagram.",
          "All'istante dato trovare le velocità con il diagramma polare."}},
        polar_diagram_sheet},
       {{"polodes",
         {"Fixed and moving polode", "Polare fissa e polare mobile"},
         {"Draw the fixed and the moving polode of the coupler.",
          "Tracciare la polare fissa e la polare mobile della biella."}},
        polodes_sheet},
       {{"coupler-curve",
         {"Path of the coupler point C", "Traiettoria del punto di biella C"},
         {"Draw the path of the coupler point C.", "Tracciare la traiettoria del punto di biella C."}},
        coupler_curve_sheet}});
}

}  // namespace epure
