// Exercise N.6 of Sapienza: the lubricated slider and the bearing of tilting pads.
#include "exercises/michell-bearing/exercise.h"

#include "exercises/michell-bearing/routes.h"

namespace epure {

std::unique_ptr<Exercise> make_michell_bearing() {
  using namespace michell_bearing;
  Description about{
      .id = "michell-bearing",
      .title = {"Michell bearing", "Cuscinetto Michell"},
      .document = "sapienza",
      .item = "N.6",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.6",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.6"},
      .question =
          {"Of the flat slider find gradients and pressures of the film, the load and its place, the friction, and "
           "the velocities across the film at the three sections. Of the bearing of tilting pads find films, mean "
           "pressure and coefficient of friction under the given thrust, and whether lubrication is hydrodynamic.",
           "Della slitta piana trovare gradienti e pressioni del meato, la portanza e il suo punto di applicazione, "
           "l'attrito, e le velocità nel meato nelle tre sezioni. Del cuscinetto a pattini oscillanti trovare "
           "spessori, pressione media e coefficiente d'attrito sotto la spinta data, e se la lubrificazione è "
           "idrodinamica."},
      .givens = given_specs(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return solved(Problem(givens), rung); };
  return exercise_of_panels(std::move(about), solve,
                            {{{"pressures", {"Gradients and pressures", "Gradienti e pressioni"}}, pressures_sheet},
                             {{"integration", {"Graphical integration", "Integrazione grafica"}}, integration_sheet},
                             {{"load", {"Load and its place", "Portanza e suo posto"}}, load_sheet},
                             {{"velocities", {"Velocities across the film", "Velocità nel meato"}}, velocities_sheet},
                             {{"direct", {"The pad under its load", "Il pattino sotto carico"}}, direct_sheet},
                             {{"bearing", {"The bearing", "Il cuscinetto"}}, bearing_sheet}});
}

}  // namespace epure
