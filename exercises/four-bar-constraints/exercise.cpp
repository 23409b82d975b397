#include "exercises/four-bar-constraints/exercise.h"

#include <fmt/format.h>

#include "exercises/four-bar-constraints/routes.h"
#include "exercises/kit/linkages/four_bar_mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/panels/table_panel.h"
#include "exercises/kit/panels/vectors_panel.h"

namespace epure {
namespace four_bar_constraints {

std::shared_ptr<const Mechanism> linkage(const Solution& s) {
  Mechanism mechanism = four_bar_mechanism(s, 0);  // where it is, not how it moves
  mechanism.angle_from_x("A0", "A", "$θ_{2}$").angle_from_x("A", "B", "$θ_{3}$").angle_from_x("B", "B0", "$θ_{4}$");
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

namespace {

constexpr const char *by_constraint_equations = "constraint equations", *analytic = "analytic",
                     *polar_diagram = "polar diagram";

std::vector<RouteValue> solve(const Givens& givens, Rung rung) {
  return settle(Routes(problem(givens)), rung, Drawn::by_every_route);  // the last sheet compares them
}

// Of the source's own givens.
double as_stated(const std::string& quantity) {
  static const Solution stated(Givens(givens()), solve(Givens(givens()), Rung::drawing));
  return stated[quantity];
}

// The source's numbers with six figures, of which some are cut off where they should be rounded.
std::vector<Printed> printed_by_the_source() {
  const auto number = [](const std::string& quantity, const std::string& text) {
    return Printed{quantity, text, by_constraint_equations};
  };
  const auto cut = [](const std::string& quantity, const std::string& text, int decimals) {
    return Printed{quantity, text, by_constraint_equations, 0,
                   cut_off([quantity] { return as_stated(quantity); }, decimals)};
  };
  return {number("theta_3", "1.23"),   number("theta_4", "-0.88"),   cut("omega_3", "-18.42", 2),
          number("omega_4", "-10.78"), cut("alpha_3", "-259.65", 2), number("alpha_4", "584.71"),
          number("v_G2", "4.18879"),   number("v_G3", "6.50865"),    cut("v_G4", "3.77417", 5),
          cut("a_G2", "175.459", 3),   cut("a_G3", "370.445", 3),    number("a_G4", "208.656")};
}

// Without the sense of the crank where an acceleration crosses its arrow, and does not depend on it.
Mechanism linkage_with_midpoints(const Solution& s, bool with_sense) {
  Mechanism mechanism = four_bar_mechanism(s, with_sense ? sign_of(s.givens().angle("n")) : 0);
  for (const char* G : {"G2", "G3", "G4"})
    mechanism.point(G, s.place(G), Mechanism::Joint::none, "$" + point_letters(G) + "$");
  return mechanism;
}

Result midpoints_table(const std::string& letter, const std::string& unit) {
  std::vector<Row> rows;
  for (const std::string G : {"G2", "G3", "G4"}) {
    const std::string name = letter + "_" + G;
    rows.push_back({"$" + point_letters(G) + "$", {name + "_x", name + "_y", name}});
  }
  const auto head = [&](const std::string& index) {
    return "$" + letter + (index.empty() ? "" : "_{\\it{" + index + "}}") + "$ (" + unit + ")";
  };
  return table({"$X$", head("x"), head("y"), head("")}, rows, 4);
}

const char* const unit_vectors =
    "$\\vec{u}_{\\it{i}}$ = (cos $θ_{\\it{i}}$, {0} $θ_{\\it{i}}$),  $\\vec{n}_{\\it{i}}$ = (−{0} $θ_{\\it{i}}$, cos "
    "$θ_{\\it{i}}$)";
std::string with_sine(std::string text, Language language) {
  const std::string sin = Words{"sin", "sen"}.in(language);
  for (auto at = text.find("{0}"); at != std::string::npos; at = text.find("{0}")) text.replace(at, 3, sin);
  return text;
}

PanelSheet velocities_sheet(const Solution& s, Language language) {
  Mechanism linkage = linkage_with_midpoints(s, true);
  linkage.turning_found("A", "B", s.value("omega_3").value_or(0), "$ω_{3}$")
      .turning_found("B0", "B", s.value("omega_4").value_or(0), "$ω_{4}$");
  VectorsPanel vectors(s, std::make_shared<const Mechanism>(std::move(linkage)), velocity, {"G2", "G3", "G4"});
  vectors.square_to("G2", "A").square_to("G4", "B0");
  return {
      .panels = panels(vectors),
      .theory =
          {{{"Differentiated constraints", "Vincoli derivati"},
            {remark("($ω_{3}$, $ω_{4}$) = −$ψ^{−1}_{\\it{y}}$ $ψ_{\\it{x}}$ $ω_{2}$,  $ψ_{\\it{x}}$ = ∂$ψ$/∂$θ_{2}$"),
             remark("$ω_{2}$ = 2π·$n_{2}$/60"), values({"omega_3"}), values({"omega_4"})}},
           {{"Midpoints", "Punti medi"},
            {remark(with_sine(unit_vectors, language)), remark("$\\vec{v}_{G2}$ = ½$r_{2}$$ω_{2}$$\\vec{n}_{2}$"),
             remark("$\\vec{v}_{G3}$ = $r_{2}$$ω_{2}$$\\vec{n}_{2}$ + ½$r_{3}$$ω_{3}$$\\vec{n}_{3}$"),
             remark("$\\vec{v}_{G4}$ = −½$r_{4}$$ω_{4}$$\\vec{n}_{4}$")}}},
      .results = {midpoints_table("v", "m/s")},
      .seen = {"Velocities of the midpoints of the links", "Velocità dei punti medi delle aste"},
      .told = {"v_G2", "v_G3", "v_G4"}};
}

PanelSheet accelerations_sheet(const Solution& s, Language language) {
  Mechanism linkage = linkage_with_midpoints(s, false);
  linkage.turning_found("B", "A", s.value("alpha_3").value_or(0), "$α_{3}$")
      .turning_found("B0", "B", s.value("alpha_4").value_or(0), "$α_{4}$");
  return {
      .panels = panels(
          VectorsPanel(s, std::make_shared<const Mechanism>(std::move(linkage)), acceleration, {"G2", "G3", "G4"})
              .no_longer_than(45)),
      .theory =
          {{{"Differentiated constraints", "Vincoli derivati"},
            {remark("($α_{3}$, $α_{4}$) = −$ψ^{−1}_{\\it{y}}$ ($ψ_{\\it{x}}$$α_{2}$ + "
                    "$(ψ_{\\it{y}}\\vec{ω})_{\\it{y}}\\vec{ω}$ + "
                    "$(ψ_{\\it{x}}ω_{2})_{\\it{x}}$$ω_{2}$)"),
             remark("$\\vec{ω}$ = ($ω_{3}$, $ω_{4}$)"), values({"alpha_3"}), values({"alpha_4"})}},
           {{"Midpoints", "Punti medi"},
            {remark(with_sine(unit_vectors, language)),
             remark("$\\vec{a}_{A}$ = $r_{2}$($α_{2}$$\\vec{n}_{2}$ − $ω^{2}_{2}$$\\vec{u}_{2}$),  $\\vec{a}_{G2}$ = "
                    "½$\\vec{a}_{A}$"),
             remark("$\\vec{a}_{G3}$ = $\\vec{a}_{A}$ + ½$r_{3}$($α_{3}$$\\vec{n}_{3}$ − $ω^{2}_{3}$$\\vec{u}_{3}$)"),
             remark("$\\vec{a}_{G4}$ = −½$r_{4}$($α_{4}$$\\vec{n}_{4}$ − $ω^{2}_{4}$$\\vec{u}_{4}$)")}}},
      .results = {midpoints_table("a", "m/s²")},
      .seen = {"Accelerations of the midpoints of the links", "Accelerazioni dei punti medi delle aste"},
      .told = {"a_G2", "a_G3", "a_G4"}};
}

// The exercise's last question: the same quantities by its three methods.
TablePanel three_methods(const Solution& s, Language language) {
  constexpr int computed = 6, drawn = 3;  // figures: more no drawing gives
  std::vector<std::vector<std::string>> rows;
  for (const char* name : {"theta_3", "theta_4", "omega_3", "omega_4", "alpha_3", "alpha_4", "v_G2", "v_G3", "v_G4",
                           "a_G2", "a_G3", "a_G4"}) {
    const Quantity& quantity = s.described(name);
    rows.push_back({quantity.symbol + " (" + written_unit(quantity.unit, language) + ")"});
    for (const auto& [route, told] :
         {std::pair{by_constraint_equations, computed}, {analytic, computed}, {polar_diagram, drawn}}) {
      const auto value = s.value(name, route);
      rows.back().push_back(value ? figures(*value, told, language) : "–");
    }
  }
  return TablePanel(
      {"", Words{"constraint equations", "equazioni di vincolo"}.in(language),
       Words{"closure, solved", "chiusura risolta"}.in(language), Words{"construction", "costruzione"}.in(language)},
      rows);
}

PanelSheet comparison_sheet(const Solution& s, Language language) {
  return {
      .panels = panels(VectorsPanel(s, std::make_shared<const Mechanism>(linkage_with_midpoints(s, false)), velocity,
                                    {"G2", "G3", "G4"}),
                       three_methods(s, language)),
      .theory =
          {{{"Three methods", "Tre metodi"},
            {remark(Words{"Constraint equations: Newton-Raphson for the angles, then two linear systems with the "
                          "same matrix $ψ_{\\it{y}}$. Nothing is solved in closed form: a method for computers.",
                          "Equazioni di vincolo: Newton-Raphson per le anomalie, poi due sistemi lineari con la "
                          "stessa matrice $ψ_{\\it{y}}$. Nulla è risolto in forma chiusa: un metodo da calcolatore."}
                        .in(language)),
             remark(Words{"Closure solved (N.10): one quadratic equation in tan($θ_{4}$/2) for both "
                          "configurations, then its derivatives.",
                          "Chiusura risolta (N.10): un'equazione di secondo grado in tg($θ_{4}$/2) per le due "
                          "configurazioni, poi le derivate."}
                        .in(language)),
             remark(Words{"Construction (N.10, sheets 2 and 3): $B$ by two arcs, then two polygons of vectors, of "
                          "which the midpoints halve the sides; rounded to three figures, as many as a "
                          "drawing gives.",
                          "Costruzione (N.10, tavole 2 e 3): $B$ con due archi, poi due poligoni di vettori, dei "
                          "quali i punti medi dimezzano i lati; arrotondata a tre cifre, quante ne dà un "
                          "disegno."}
                        .in(language))}}},
      .seen = {"The four-bar linkage, and its angles, rates and midpoints by three methods side by side",
               "Il quadrilatero, con le sue anomalie, velocità e punti medi per tre vie a confronto"},
      .told = {"theta_3", "theta_4", "omega_3", "omega_4", "alpha_3", "alpha_4"}};
}

Description description() {
  return {
      .id = "four-bar-constraints",
      .title = {"Four-bar linkage: constraint equations", "Quadrilatero articolato: equazioni di vincolo"},
      .document = "sapienza",
      .item = "N.11",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.11",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.11"},
      .question =
          {"Write the constraint equations of the four-bar linkage and solve them by Newton-Raphson from the given "
           "start. Find velocities and accelerations of the midpoints, and compare with the closure equations.",
           "Scrivere le equazioni di vincolo del quadrilatero articolato e risolverle con Newton-Raphson dai valori "
           "iniziali dati. Trovare velocità e accelerazioni dei punti medi, e confrontare con le equazioni di "
           "chiusura."},
      .givens = givens(),
      .printed = printed_by_the_source};
}

}  // namespace
}  // namespace four_bar_constraints

std::unique_ptr<Exercise> make_four_bar_constraints() {
  using namespace four_bar_constraints;
  return exercise_of_panels(
      description(), solve,
      {{{"iterations",
         {"Newton-Raphson: the iterates", "Newton-Raphson: le iterate"},
         {"Write the constraint equations of the four-bar linkage and solve them by Newton-Raphson from the given "
          "start.",
          "Scrivere le equazioni di vincolo del quadrilatero articolato e risolverle con Newton-Raphson dai valori "
          "iniziali dati."}},
        iterations_sheet},
       {{"convergence",
         {"Convergence of the iteration", "Convergenza dell'iterazione"},
         {"Solve the constraint equations of the four-bar linkage by Newton-Raphson from the given start, and draw "
          "how the residuals become smaller.",
          "Risolvere le equazioni di vincolo del quadrilatero articolato con Newton-Raphson dai valori iniziali "
          "dati, e disegnare come diminuiscono i residui."}},
        convergence_sheet},
       {{"velocities",
         {"Velocities of the midpoints", "Velocità dei punti medi"},
         {"Find the velocities of the midpoints of the four-bar linkage from the constraint equations.",
          "Trovare le velocità dei punti medi del quadrilatero articolato dalle equazioni di vincolo."}},
        velocities_sheet},
       {{"accelerations",
         {"Accelerations of the midpoints", "Accelerazioni dei punti medi"},
         {"Find the accelerations of the midpoints of the four-bar linkage from the constraint equations.",
          "Trovare le accelerazioni dei punti medi del quadrilatero articolato dalle equazioni di vincolo."}},
        accelerations_sheet},
       {{"comparison",
         {"Three methods compared", "Confronto dei tre metodi"},
         {"Find velocities and accelerations of the midpoints of the four-bar linkage by constraint equations, "
          "closure equations and polar diagrams, and compare.",
          "Trovare velocità e accelerazioni dei punti medi del quadrilatero articolato con le equazioni di vincolo, "
          "le equazioni di chiusura e i diagrammi polari, e confrontare."}},
        comparison_sheet}});
}

}  // namespace epure
