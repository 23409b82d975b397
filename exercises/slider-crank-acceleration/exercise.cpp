// N.2 of the Sapienza sheets: accelerations of the slider-crank by the polar diagram and by poles, the
// inflection and stationarity circles, and centres of curvature by Euler-Savary.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/linkages/coupler_steps.h"
#include "exercises/kit/linkages/slider_crank_loops.h"
#include "exercises/kit/linkages/slider_crank_mechanism.h"
#include "exercises/kit/panels/circles_panel.h"
#include "exercises/kit/panels/curvature_panel.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/slider-crank-acceleration/printed.h"
#include "exercises/slider-crank-acceleration/routes.h"

namespace epure {
namespace slider_crank_acceleration {
namespace {

std::shared_ptr<const Mechanism> with_angular_acceleration(const Solution& s, const SliderCrankInstant& instant,
                                                           bool marks_phi = true) {
  return slider_crank_mechanism(s, instant, {s["alpha_3"], "$α_{3}$", marks_phi});
}

VectorPolygon accelerations(const Solution& s, const SliderCrankInstant& instant, Language language) {
  const bool speeds_up = !is_zero(instant.alpha_2);
  PolygonSide a_A_n =
                  side(s, normal_acceleration("A"), "∥ $AA_{0}$", "$ω^{2}_{2}$·$A_{0}A$", speeds_up ? "" : "$a'$"),
              a_A_t = side(s, tangential_acceleration("A"), "–", "0", "$a'$"),
              a_BA_t = side(s, tangential_acceleration("BA"), "⊥ $BA$", "?", "$b'$");
  if (speeds_up) a_A_t.direction = "⊥ $A_{0}A$", a_A_t.magnitude = "|$α_{2}$|·$A_{0}A$";
  a_A_t.square = a_BA_t.square = true;
  VectorPolygon polygon =
      acceleration_polygon({side(s, acceleration("B"), parallel_to_guide(instant, language), "?")},
                           {a_A_n, a_A_t, side(s, normal_acceleration("BA"), "∥ $BA$", "$ω^{2}_{3}$·$BA$"), a_BA_t});
  polygon.images = {
      image(s, acceleration("C"), acceleration("CA"), "$c'$",
            {"$c'$: the triangle $a'b'c'$ is similar to $ABC$, in the same sense: $a_{CA}$ : $a_{BA}$ = $AC$ : $AB$, "
             "turned by the same $γ$.",
             "$c'$: il triangolo $a'b'c'$ è simile ad $ABC$, nello stesso verso: $a_{CA}$ : $a_{BA}$ = $AC$ : $AB$, "
             "ruotata dello stesso $γ$."}),
      image(s, acceleration("M"), acceleration("MA"), "$m'$",
            {"$m'$ halves $a'b'$, as $M$ halves $AB$.", "$m'$ è il punto medio di $a'b'$, come $M$ di $AB$."}),
      image(s, acceleration("B"), acceleration("BA"), "", {})};
  polygon.images[1].relative.label.clear();  // it lies on a_BA
  polygon.images[2].absolute.label.clear();  // a side
  if (speeds_up) polygon.images.push_back({.absolute = side(s, acceleration("A"), "", "")});
  polygon.images.push_back({.absolute = {.v = s.vector("a_C")},
                            .relative = {.v = s.vector("a_C") - s.vector("a_B")},
                            .closes_triangle = true});
  return polygon;
}

// With γ at a', from the line of the normal part of a_BA, along BA, to a_BA.
class DiagramWithInclination : public PolygonPanel {
 public:
  DiagramWithInclination(const Solution& s, VectorPolygon polygon)
      : PolygonPanel(s, std::move(polygon), Table::measured),
        a_(Place{0, 0} + s.vector("a_A")),
        normal_(s.vector("a_BA_n")),
        whole_(s.vector("a_BA")) {}

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    std::vector<drawings::Block> told = PolygonPanel::draw(plot, room, language);
    constexpr double radius = 13, least = 3;  // mm; radians times radius
    const double from = std::atan2(normal_.y, normal_.x), to = std::atan2(whole_.y, whole_.x);
    const double turn = std::remainder(to - from, 2 * std::numbers::pi), mm = plot.scale().mm_per_unit;
    const bool has_room = std::min(magnitude(normal_), magnitude(whole_)) * mm > radius;
    if (!has_room || std::abs(turn) * radius < least) return told;
    const drawings::Point centre = plot.at(a_);
    plot.mark(drawings::AngleMark{centre, radius, std::min(from, from + turn), std::max(from, from + turn),
                                  Meaning::dimension});
    const double middle = from + turn / 2;
    plot.label("$γ$", plot.from_paper({centre.x + radius * std::cos(middle), centre.y + radius * std::sin(middle)}),
               a_);
    return told;
  }

 private:
  Place a_;
  Arrow2 normal_, whole_;
};

PanelSheet polar_diagram_sheet(const Solution& s, Language language) {
  const SliderCrankInstant instant = slider_crank_instant(s.givens());
  DiagramWithInclination polygon(s, accelerations(s, instant, language));
  polygon.with_equations({{{{"$\\vec{a}_{C}$", "?", "?", ""},
                            {"$\\vec{a}_{A}$", is_zero(instant.alpha_2) ? "∥ $AA_{0}$" : "",
                             is_zero(instant.alpha_2) ? "$ω^{2}_{2}$·$A_{0}A$" : "", "="},
                            {"$\\vec{a}^{n}_{CA}$", "∥ $CA$", "$ω^{2}_{3}$·$CA$", "+"},
                            {"$\\vec{a}^{t}_{CA}$", "⊥ $CA$", "|$α_{3}$|·$CA$", "+"}}}});
  return {.panels = panels(MechanismPanel(with_angular_acceleration(s, instant)), polygon),
          .results = {values({"omega_3", "alpha_3", "gamma_deg"}),
                      remark(Words{"|$α_{3}$| = $a^{t}_{BA}$ / $AB$,  tan $γ$ = $α_{3}$ / $ω^{2}_{3}$",
                                   "|$α_{3}$| = $a^{t}_{BA}$ / $AB$,  tg $γ$ = $α_{3}$ / $ω^{2}_{3}$"}
                                 .in(language))},
          .seen = {"The polygon of the accelerations of the slider-crank, with the images of C and M",
                   "Il poligono delle accelerazioni del manovellismo, con le immagini di C e M"},
          .told = {"alpha_3", "a_A", "a_B", "a_C", "a_M"}};
}

PanelSheet circles_sheet(const Solution& s, Language) {
  const SliderCrankInstant instant = slider_crank_instant(s.givens());
  CirclesPanel circles(s, slider_crank_mechanism(s, instant),
                       {.pole = "P0",
                        .driven = {"A", "A0"},
                        .other = {.point = "B", .is_pole = instant.dead_centre},
                        .driven_speeds_up = !is_zero(instant.alpha_2)});
  CirclesPanel detail = circles;
  constexpr double too_large = 4;  // reaches: up to that the mechanism is not tiny in one picture of both circles
  return {
      .panels = circles.needs_detail(too_large) ? panels(circles.beside_detail(), detail.detail()) : panels(circles),
      .results = {coordinates(CirclesPanel::points("P0")), values({"inflection_diameter", "stationarity_diameter"})},
      .seen = {"Inflection and stationarity circle of the coupler, which meet in P₀ and K",
               "Circonferenze dei flessi e di stazionarietà della biella, che si incontrano in P₀ e K"},
      .told = {"P0_x", "P0_y", "inflection_pole_x", "inflection_pole_y", "K_x", "K_y"}};
}

PanelSheet poles_sheet(const Solution& s, Language) {
  const SliderCrankInstant instant = slider_crank_instant(s.givens());
  const std::vector<std::string> points{"A", "B", "C", "M"};
  const auto mechanism = with_angular_acceleration(s, instant, false);  // γ has the place of φ
  return {.panels = panels(PolesPanel(s, mechanism, PolesPanel::of_acceleration(), points,
                                      steps_to_coupler_accelerations(2, "M", "C"))),
          .results = {values({"omega_3", "alpha_3", "gamma_deg"}), coordinates("K"),
                      by_point(points, {{"$KX$ (m)", "K{}"}, {"$a_{X}$ (m/s²)", "a_{}"}})},
          .seen = {"Accelerations of A, B, C and M, proportional to their distances from the acceleration pole K",
                   "Accelerazioni di A, B, C e M, proporzionali alle distanze dal polo delle accelerazioni K"},
          .told = {"a_A", "a_B", "a_C", "a_M", "K_x", "K_y"}};
}

// The path of C, or of M: traced by the circuit of positions, of which the instant's is one.
void draw_path(const SliderCrankInstant& instant, Plot& plot, const std::string& point, const drawings::Box& around) {
  const geometry::Arithmetic<geometry::Bounded> scope;
  const Reference reference = reference_of(instant);
  const auto& [A, B, P0] = reference.coupler;
  const geometry::Point<geometry::Bounded> X = point == "C" ? reference.C : geometry::midpoint(A, B);
  draw_locus(
      plot,
      geometry::CouplerCurve<geometry::Bounded>{loops_of<geometry::Bounded>(instant).front(), reference.coupler, X},
      around, Meaning::locus, "path_of_" + point);
}

PanelSheet curvature_sheet(const Solution& s, Language) {
  const SliderCrankInstant instant = slider_crank_instant(s.givens());
  const auto mechanism = slider_crank_mechanism(s, instant);
  const Curved paths{.pole = "P0", .points = {"C", "M"}, .circles_sheet = 2};
  const auto draw = [instant](Plot& plot, const std::string& point, const drawings::Box& around) {
    draw_path(instant, plot, point, around);
  };
  return {.panels = curvature_panels(s, mechanism, paths, draw),
          .results = {by_point({"C", "M"},
                               {{"$P_{0}X$ (m)", "P0{}"}, {"$X'X$ (m)", "{0}prime_{0}"}, {"$ρ_{X}$ (m)", "rho_{}"}}),
                      coordinates({{"$J$", "inflection_pole"},
                                   {"$Ω_{C}$", "curvature_centre_C"},
                                   {"$Ω_{M}$", "curvature_centre_M"}})},
          .seen = {"Centres of curvature of the paths of C and M by Euler-Savary, with their osculating circles",
                   "Centri di curvatura delle traiettorie di C e M con Euler-Savary, con i cerchi osculatori"},
          .told = {"rho_C", "rho_M"}};
}

Description description() {
  return {.id = "slider-crank-acceleration",
          .title = {"Slider-crank: accelerations", "Manovellismo: accelerazioni"},
          .document = "sapienza",
          .item = "N.2",
          .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.2",
                     "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.2"},
          .question =
              {"At the given instant find the accelerations by the polar diagram, inflection and stationarity "
               "circles, the pole K and the accelerations by it, and the centres of curvature of the paths.",
               "All'istante dato trovare le accelerazioni con il diagramma polare, le circonferenze dei flessi e di "
               "stazionarietà, il polo K e con esso le accelerazioni, e i centri di curvatura delle traiettorie."},
          .givens = slider_crank_givens(true),
          .printed = printed_by_the_source};
}

}  // namespace
}  // namespace slider_crank_acceleration

std::unique_ptr<Exercise> make_slider_crank_acceleration() {
  using namespace slider_crank_acceleration;
  const auto solve = [](const Givens& givens, Rung rung) {
    return settle(AccelerationRoutes{slider_crank_instant(givens)}, rung);
  };
  return exercise_of_panels(
      description(), solve,
      {{{"polar-diagram",
         {"Polar diagram of acceleration", "Diagramma polare delle accelerazioni"},
         {"At the given instant find the accelerations by the polar diagram.",
          "All'istante dato trovare le accelerazioni con il diagramma polare."}},
        polar_diagram_sheet},
       {{"circles",
         {"Inflection and stationarity circles", "Circonferenze dei flessi e di stazionarietà"},
         {"At the given instant find the inflection and stationarity circles of the coupler and its acceleration "
          "pole K.",
          "All'istante dato trovare le circonferenze dei flessi e di stazionarietà della biella e il suo polo delle "
          "accelerazioni K."}},
        circles_sheet},
       {{"poles",
         {"Accelerations by the pole K", "Accelerazioni col metodo dei poli"},
         {"At the given instant find the accelerations by the acceleration pole K.",
          "All'istante dato trovare le accelerazioni con il polo delle accelerazioni K."}},
        poles_sheet},
       {{"curvature",
         {"Centres of curvature (Euler-Savary)", "Centri di curvatura (Euler-Savary)"},
         {"At the given instant find the centres of curvature of the paths by the formula of Euler-Savary.",
          "All'istante dato trovare i centri di curvatura delle traiettorie con la formula di Euler-Savary."}},
        curvature_sheet}});
}

}  // namespace epure
