#include "exercises/four-bar-analytic/exercise.h"

#include "exercises/four-bar-analytic/routes.h"
#include "exercises/kit/linkages/four_bar_mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/polygon_panel.h"

namespace epure {
namespace four_bar_analytic {

std::vector<RouteValue> solve(const Givens& givens, Rung rung) { return settle(Routes(problem(givens)), rung); }

Mechanism linkage(const Solution& s, const std::vector<std::string>& points, bool with_sense) {
  Mechanism mechanism = four_bar_mechanism(s, with_sense ? sign_of(s.givens().angle("n")) : 0);
  for (const std::string& X : points)
    mechanism.point(X, s.place(X), Mechanism::Joint::none, "$" + point_letters(X) + "$");
  return mechanism;
}

namespace {

// With the senses of these rates of coupler and rocker.
std::shared_ptr<const Mechanism> with_midpoints(const Solution& s, const std::string& rate,
                                                const std::string& letter) {
  Mechanism mechanism = linkage(s, {"G2", "G3", "G4"});
  mechanism.turning_found("B", "A", s.value(rate + "_3").value_or(0), "$" + letter + "_{3}$")
      .turning_found("B0", "B", s.value(rate + "_4").value_or(0), "$" + letter + "_{4}$");
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

// Of the midpoints of crank, coupler and rocker: they halve Oa', a'b' and Ob'.
std::vector<PolygonImage> images_of_midpoints(const Solution& s, VectorQuantity (*vector)(const std::string& of),
                                              const std::string& O) {
  const auto image_of = [&](const std::string& G, const std::string& tip, const Words& explained) {
    return PolygonImage{.absolute = side(s, vector(G), {}, {}, tip), .relative = {}, .explained = explained};
  };
  return {image_of("G3", "$g'_{3}$",
                   {"$g'_{3}$ halves $a'b'$, as $G_{3}$ halves $AB$.",
                    "$g'_{3}$ è il punto medio di $a'b'$, come $G_{3}$ di $AB$."}),
          image_of("G2", "$g'_{2}$",
                   {"$g'_{2}$ halves " + O + "$a'$: the crank's fixed point has its image at " + O + ".",
                    "$g'_{2}$ è il punto medio di " + O + "$a'$: il punto fisso ha l'immagine in " + O + "."}),
          image_of("G4", "$g'_{4}$",
                   {"$g'_{4}$ likewise halves " + O + "$b'$.",
                    "Analogamente $g'_{4}$ è il punto medio di " + O + "$b'$."})};
}

Arrow2 across(const Place& P, const Place& Q) { return {P.y - Q.y, Q.x - P.x}; }

VectorPolygon velocities(const Solution& s) {
  PolygonSide v_B = side(s, velocity("B"), "⊥ $B_{0}B$", "?"), v_BA = side(s, velocity("BA"), "⊥ $AB$", "?", "$b'$");
  v_B.along = across(s.place("B0"), s.place("B"));
  v_BA.along = across(s.place("A"), s.place("B"));
  VectorPolygon polygon =
      velocity_polygon({v_B}, {side(s, velocity("A"), "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "$a'$"), v_BA});
  polygon.images = images_of_midpoints(s, velocity, "$O_{v}$");
  return polygon;
}

// Of a_A, from where a_A starts, or to where it ends.
PolygonImage part_of_a_A(const Solution& s, const VectorQuantity& part) {
  const PolygonSide drawn{.label = part.arrow(), .v = s.vector(part.name)}, a_A{.v = s.vector("a_A")};
  if (part.name == normal_acceleration("A").name) return {.absolute = drawn, .relative = {}, .explained = {}};
  return {.absolute = a_A, .relative = drawn, .explained = {}};
}

VectorPolygon accelerations(const Solution& s) {
  const bool is_steady = is_zero(s.givens().angle("alpha_2"));
  PolygonSide a_A = side(s, acceleration("A"), is_steady ? "∥ $AA_{0}$" : "$\\vec{a}^{n}_{A}$ + $\\vec{a}^{t}_{A}$",
                         is_steady ? "$ω^{2}_{2}$·$A_{0}A$" : "$a_{A}$", "$a'$");
  PolygonSide a_BA_t = side(s, tangential_acceleration("BA"), "⊥ $AB$", "?", "$b'$"),
              a_B_t = side(s, tangential_acceleration("B"), "⊥ $B_{0}B$", "?");
  a_BA_t.along = across(s.place("A"), s.place("B"));
  a_B_t.along = across(s.place("B0"), s.place("B"));
  a_BA_t.square = a_B_t.square = true;
  VectorPolygon polygon =
      acceleration_polygon({side(s, normal_acceleration("B"), "∥ $BB_{0}$", "$ω^{2}_{4}$·$B_{0}B$"), a_B_t},
                           {a_A, side(s, normal_acceleration("BA"), "∥ $BA$", "$ω^{2}_{3}$·$AB$"), a_BA_t});
  PolygonImage a_B{.absolute = side(s, acceleration("B"), {}, {}),
                   .relative = {.label = "$\\vec{a}_{BA}$", .v = s.vector("a_BA")},
                   .explained = {"$\\vec{a}_{B}$ from $O_{a}$ to $b'$, $\\vec{a}_{BA}$ from $a'$ to $b'$.",
                                 "$\\vec{a}_{B}$ da $O_{a}$ a $b'$, $\\vec{a}_{BA}$ da $a'$ a $b'$."}};
  polygon.images = images_of_midpoints(s, acceleration, "$O_{a}$");
  polygon.images.insert(polygon.images.begin(), a_B);
  if (!is_steady)
    for (const VectorQuantity& part : {normal_acceleration("A"), tangential_acceleration("A")})
      polygon.images.push_back(part_of_a_A(s, part));
  return polygon;
}

Result vectors_by_point(const std::string& letter, const std::string& unit) {
  const auto head = [&](const std::string& index) {
    return "$" + letter + "_{X\\it{" + index + "}}$ (" + unit + ")";
  };
  return by_point({"B", "G2", "G3", "G4"},
                  {{head("x"), letter + "_{}_x"}, {head("y"), letter + "_{}_y"}, {head(""), letter + "_{}"}});
}

Result on_the_source(const Solution& s, const Words& words, Language language) {
  return remark(s.givens().as_stated() ? words.in(language) : "");
}

PanelSheet velocities_sheet(const Solution& s, Language language) {
  PolygonPanel polygon(s, velocities(s));
  polygon.with_equations({{{{"$\\vec{v}_{G3}$", "?", "?", ""},
                            {"$\\vec{v}_{A}$", "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "="},
                            {"$\\vec{v}_{G3A}$", "⊥ $AB$", "|$ω_{3}$|·$AG_{3}$", "+"}}}});
  return {.panels = panels(MechanismPanel(with_midpoints(s, "omega", "ω")), polygon),
          .results = {remark("|$ω_{3}$| = $v_{BA}$ / $AB$,  |$ω_{4}$| = $v_{B}$ / $B_{0}B$"),
                      values({"omega_2", "omega_3", "omega_4"}), values({"v_A"}), vectors_by_point("v", "m/s"),
                      on_the_source(
                          s,
                          {"The source's table writes $\\vec{v}_{B}$ ∥ $B_{0}B$: it is perpendicular to it.",
                           "La tabella della fonte scrive $\\vec{v}_{B}$ ∥ $B_{0}B$: invece le è perpendicolare."},
                          language)},
          .seen = {"The polygon of the velocities of the four-bar, with the images of the links' midpoints",
                   "Il poligono delle velocità del quadrilatero, con le immagini dei punti medi"},
          .told = {"omega_3", "omega_4", "v_B", "v_G3"},
          .without_part = {"AP_along", "AP_across"}};
}

PanelSheet accelerations_sheet(const Solution& s, Language language) {
  const bool is_steady = is_zero(s.givens().angle("alpha_2"));
  PolygonPanel polygon(s, accelerations(s));
  polygon.with_equations(
      {{{{"$\\vec{a}_{G3}$", "?", "?", ""},
         {"$\\vec{a}_{A}$", is_steady ? "∥ $AA_{0}$" : "", is_steady ? "$ω^{2}_{2}$·$A_{0}A$" : "", "="},
         {"$\\vec{a}^{n}_{G3A}$", "∥ $BA$", "$ω^{2}_{3}$·$AG_{3}$", "+"},
         {"$\\vec{a}^{t}_{G3A}$", "⊥ $AB$", "|$α_{3}$|·$AG_{3}$", "+"}}}});
  return {.panels = panels(MechanismPanel(with_midpoints(s, "alpha", "α")), polygon),
          .results = {remark("|$α_{3}$| = $a^{t}_{BA}$ / $AB$,  |$α_{4}$| = $a^{t}_{B}$ / $B_{0}B$"),
                      values({"alpha_3", "alpha_4"}), vectors_by_point("a", "m/s²"),
                      on_the_source(s,
                                    {"The source left $α_{4}$·$B_{0}G_{4}$ out of its $a_{G4}$ here, and calls "
                                     "normal and tangential what is along and perpendicular to $AB$.",
                                     "Qui la fonte dimentica $α_{4}$·$B_{0}G_{4}$ in $a_{G4}$, e chiama normale e "
                                     "tangenziale ciò che è lungo $AB$ e normale ad $AB$."},
                                    language)},
          .seen = {"The polygon of the accelerations of the four-bar, with the images of the links' midpoints",
                   "Il poligono delle accelerazioni del quadrilatero, con le immagini dei punti medi"},
          .told = {"alpha_3", "alpha_4", "a_B", "a_G3"},
          .without_part = {"AP_along", "AP_across"}};
}

Description description() {
  return {
      .id = "four-bar-analytic",
      .title = {"Four-bar linkage: analytic methods", "Quadrilatero articolato: metodi analitici"},
      .document = "sapienza",
      .item = "N.10",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.10",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.10"},
      .question =
          {"Solve the closure equations of the four-bar linkage in both configurations. Find angular velocities and "
           "accelerations, velocities and accelerations of the midpoints, the centre of curvature of the path of the "
           "coupler's midpoint, $ω_{4}$ over a turn of the crank, and the path of the coupler point P.",
           "Risolvere le equazioni di chiusura del quadrilatero articolato in entrambe le configurazioni. Trovare "
           "velocità e accelerazioni angolari, velocità e accelerazioni dei punti medi, il centro di curvatura della "
           "traiettoria del punto medio della biella, $ω_{4}$ in un giro della manovella e la traiettoria del punto "
           "di biella P."},
      .givens = givens(),
      .printed = printed_by_the_source};
}

}  // namespace
}  // namespace four_bar_analytic

std::unique_ptr<Exercise> make_four_bar_analytic() {
  using namespace four_bar_analytic;
  return exercise_of_panels(
      description(), solve,
      {{{"configurations",
         {"Both configurations", "Le due configurazioni"},
         {"Solve the closure equations of the four-bar linkage in both configurations.",
          "Risolvere le equazioni di chiusura del quadrilatero articolato in entrambe le configurazioni."}},
        configurations_sheet},
       {{"velocities",
         {"Polar diagram of velocity", "Diagramma polare delle velocità"},
         {"Find the angular velocities of the four-bar linkage and the velocities of the midpoints by the polar "
          "diagram.",
          "Trovare le velocità angolari del quadrilatero articolato e le velocità dei punti medi con il diagramma "
          "polare."}},
        velocities_sheet},
       {{"accelerations",
         {"Polar diagram of acceleration", "Diagramma polare delle accelerazioni"},
         {"Find the angular accelerations of the four-bar linkage and the accelerations of the midpoints by the "
          "polar diagram.",
          "Trovare le accelerazioni angolari del quadrilatero articolato e le accelerazioni dei punti medi con il "
          "diagramma polare."}},
        accelerations_sheet},
       {{"curvature",
         {"Curvature of the path of G₃", "Curvatura della traiettoria di G₃"},
         {"Find the centre of curvature of the path of the coupler's midpoint.",
          "Trovare il centro di curvatura della traiettoria del punto medio della biella."}},
        curvature_sheet},
       {{"omega-4",
         {"ω₄ over a turn of the crank", "ω₄ in un giro della manovella"},
         {"Find $ω_{4}$ of the four-bar linkage over a turn of the crank.",
          "Trovare $ω_{4}$ del quadrilatero articolato in un giro della manovella."}},
        omega_4_sheet},
       {{"coupler-curve",
         {"Path of the coupler point P", "Traiettoria del punto di biella P"},
         {"Draw the path of the coupler point P of the four-bar linkage.",
          "Tracciare la traiettoria del punto di biella P del quadrilatero articolato."}},
        coupler_curve_sheet}});
}

}  // namespace epure
