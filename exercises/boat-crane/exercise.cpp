// Exercise 2 of Pisa's machine design: a crane that lifts boats, against yield, fatigue and buckling.
#include "exercises/boat-crane/printed.h"
#include "exercises/boat-crane/routes.h"
#include "exercises/boat-crane/sheets.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure {

std::unique_ptr<Exercise> make_boat_crane() {
  using namespace boat_crane;
  Description about{
      .id = "boat-crane",
      .title = {"A crane that lifts boats", "Gru per rimessaggio barche"},
      .document = "pisa",
      .item = "Esercizio 2",
      .source = {"Pisa, mid-term test of 14 June 2006, exercise 2",
                 "Pisa, verifica intermedia del 14/6/2006, esercizio 2"},
      .question = {"A crane lifts the boat an unlimited number of times. Find reactions, bending moments and shear "
                   "of its beam and the force in its column, the elastic line and the sinking of the boat, and check "
                   "beam and column against yield, fatigue and buckling.",
                   "Una gru solleva la barca un numero illimitato di volte. Trovare le reazioni, i momenti flettenti "
                   "e il taglio della trave e la forza nella colonna, la linea elastica e l'abbassamento della "
                   "barca, e verificare trave e colonna a snervamento, a fatica e a carico di punta."},
      .givens = Crane::givens(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) {
    return settle(Routes(Crane(givens), Strength(givens)), rung);
  };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"reactions",
         {"Reactions, moments, shear", "Reazioni, momenti, taglio"},
         {"A crane lifts a boat, which hangs from the end $D$ of its beam; the beam is hinged in $B$ and rests on "
          "the column $AC$, $BC$ = $\\it{L}$, $BD$ = 3$\\it{L}$. Find reactions, bending moments and shear of its "
          "beam and the force in its column.",
          "Una gru solleva una barca, appesa all'estremo $D$ della trave; la trave è incernierata in $B$ e poggia "
          "sulla colonna $AC$, $BC$ = $\\it{L}$, $BD$ = 3$\\it{L}$. Trovare le reazioni, i momenti flettenti e il "
          "taglio della trave e la forza nella colonna."}},
        reactions_sheet},
       {{"elastic-line",
         {"Elastic line and sinking of the boat", "Linea elastica e abbassamento della barca"},
         {"A crane lifts a boat, which hangs from the end $D$ of its beam; the beam is hinged in $B$ and rests on "
          "the column $AC$, $BC$ = $\\it{L}$, $BD$ = 3$\\it{L}$, $AC$ = $\\it{H}_{0}$. Find the elastic line of its "
          "beam and how far the boat sinks.",
          "Una gru solleva una barca, appesa all'estremo $D$ della trave; la trave è incernierata in $B$ e poggia "
          "sulla colonna $AC$, $BC$ = $\\it{L}$, $BD$ = 3$\\it{L}$, $AC$ = $\\it{H}_{0}$. Trovare la linea elastica "
          "della trave e di quanto si abbassa la barca."}},
        elastic_sheet},
       {{"section",
         {"Stresses of section C", "Tensioni nella sezione C"},
         {"A crane lifts a boat. Find the stresses of its beam in section C and check it against yield.",
          "Una gru solleva una barca. Trovare le tensioni della trave nella sezione C e verificarla a snervamento."}},
        section_sheet},
       {{"fatigue",
         {"Fatigue: Soderberg's diagram", "Fatica: diagramma di Soderberg"},
         {"A crane lifts a boat an unlimited number of times. Check its beam against fatigue by Soderberg's diagram.",
          "Una gru solleva una barca un numero illimitato di volte. Verificare la trave a fatica con il diagramma di "
          "Soderberg."}},
        fatigue_sheet},
       {{"buckling",
         {"Buckling: Euler's hyperbola", "Instabilità: iperbole di Eulero"},
         {"A crane lifts a boat. Check its column against buckling by Euler's hyperbola.",
          "Una gru solleva una barca. Verificare la colonna a carico di punta con l'iperbole di Eulero."}},
        buckling_sheet},
       {{"checks",
         {"All checks, both masses", "Tutte le verifiche, le due masse"},
         {"A crane lifts a boat an unlimited number of times. Check beam and column against yield, fatigue and "
          "buckling, for the mass that is given and for 600 kg.",
          "Una gru solleva una barca un numero illimitato di volte. Verificare trave e colonna a snervamento, a "
          "fatica e a carico di punta, per la massa data e per 600 kg."}},
        checks_sheet}});
}

}  // namespace epure
