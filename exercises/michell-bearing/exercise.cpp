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
      .printed = printed_by_the_source,
      .audit = audits};
  const auto solve = [](const Givens& givens, Rung rung) { return solved(Problem(givens), rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"pressures",
         {"Gradients and pressures", "Gradienti e pressioni"},
         {"Of the flat slider find gradients and pressures of the film.",
          "Della slitta piana trovare gradienti e pressioni del meato."}},
        pressures_sheet},
       {{"integration",
         {"Graphical integration", "Integrazione grafica"},
         {"Of the flat slider find the pressures of the film by graphical integration.",
          "Della slitta piana trovare le pressioni del meato per integrazione grafica."}},
        integration_sheet},
       {{"load",
         {"Load and its place", "Portanza e punto di applicazione"},
         {"Of the flat slider find the load and its place, and the friction.",
          "Della slitta piana trovare la portanza e il suo punto di applicazione, e l'attrito."}},
        load_sheet},
       {{"velocities",
         {"Velocities across the film", "Velocità nel meato"},
         {"Of the flat slider find the velocities across the film at the three sections.",
          "Della slitta piana trovare le velocità nel meato nelle tre sezioni."}},
        velocities_sheet},
       {{"direct",
         {"The pad under its load", "Il pattino sotto carico"},
         {"Of the pad under its load find the inclination of the film and its coefficients from the place of the "
          "pivot.",
          "Del pattino sotto carico trovare l'inclinazione del meato e i suoi coefficienti dal posto del perno."}},
        direct_sheet},
       {{"bearing",
         {"The bearing", "Il cuscinetto"},
         {"Of the bearing of tilting pads find films, mean pressure and coefficient of friction under the given "
          "thrust, and whether lubrication is hydrodynamic.",
          "Del cuscinetto a pattini oscillanti trovare spessori, pressione media e coefficiente d'attrito sotto la "
          "spinta data, e se la lubrificazione è idrodinamica."}},
        bearing_sheet}});
}

}  // namespace epure
