// The landing of `macchine`: how long the wheel slips until it rolls.
#include "exercises/aircraft-landing/printed.h"
#include "exercises/aircraft-landing/routes.h"
#include "exercises/aircraft-landing/sheets.h"

namespace epure {

std::unique_ptr<Exercise> make_aircraft_landing() {
  using namespace aircraft_landing;
  Description about{
      .id = "aircraft-landing",
      .title = {"Landing: the wheel set turning", "Atterraggio: la ruota messa in moto"},
      .document = "macchine",
      .item = "Transitorio",
      .source = {"Exercises on machines, \"Transitorio\"", "Esercizi di macchine, \"Transitorio\""},
      .question = {"An aircraft touches down with wheels at rest. Find the forces on wheel and aircraft at "
                   "touch-down and once the wheel rolls, and after how long it rolls without slipping, so that the "
                   "brakes may act: in closed form, by graphical integration and by Euler's scheme.",
                   "Un aereo tocca terra con le ruote ferme. Trovare le forze sulla ruota e sull'aereo al contatto e "
                   "quando la ruota rotola, e dopo quanto tempo essa rotola senza strisciare, così che il freno "
                   "possa agire: in forma chiusa, per integrazione grafica e con lo schema di Eulero."},
      .givens = given_specs(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{Landing(givens)}, rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"forces",
         {"Forces at touch-down and after", "Forze al contatto e dopo"},
         {"An aircraft touches down with wheels at rest. Find the forces on wheel and aircraft at touch-down and "
          "once the wheel rolls.",
          "Un aereo tocca terra con le ruote ferme. Trovare le forze sulla ruota e sull'aereo al contatto e quando "
          "la ruota rotola."}},
        forces_sheet},
       {{"slip",
         {"Speeds until slip ends", "Velocità fino alla fine dello strisciamento"},
         {"An aircraft touches down with wheels at rest. Draw the speeds of aircraft and rim over time, and find "
          "after how long the wheel rolls without slipping.",
          "Un aereo tocca terra con le ruote ferme. Disegnare nel tempo le velocità dell'aereo e della periferia "
          "della ruota, e trovare dopo quanto tempo essa rotola senza strisciare."}},
        slip_sheet},
       {{"integration",
         {"The time by graphical integration", "Il tempo per integrazione grafica"},
         {"An aircraft touches down with wheels at rest. By graphical integration find after how long the wheel "
          "rolls without slipping.",
          "Un aereo tocca terra con le ruote ferme. Trovare per integrazione grafica dopo quanto tempo la ruota "
          "rotola senza strisciare."}},
        integration_sheet},
       {{"euler",
         {"Euler's polygons", "Poligoni di Eulero"},
         {"An aircraft touches down with wheels at rest. By Euler's scheme find after how long the wheel rolls "
          "without slipping.",
          "Un aereo tocca terra con le ruote ferme. Trovare con lo schema di Eulero dopo quanto tempo la ruota "
          "rotola senza strisciare."}},
        euler_sheet}});
}

}  // namespace epure
