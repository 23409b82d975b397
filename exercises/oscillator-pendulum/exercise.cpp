// Exercise N.14 of Sapienza: a damped oscillator and a compound pendulum, their motion in closed form and by tables.
#include "exercises/oscillator-pendulum/printed.h"
#include "exercises/oscillator-pendulum/routes.h"
#include "exercises/oscillator-pendulum/sheets.h"
#include "exercises/oscillator-pendulum/tables.h"

namespace epure {
std::unique_ptr<Exercise> make_oscillator_pendulum() {
  using namespace oscillator_pendulum;
  Description about{
      .id = "oscillator-pendulum",
      .title = {"Oscillator and pendulum", "Oscillatore e pendolo"},
      .document = "sapienza",
      .item = "N.14",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.14",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.14"},
      .question =
          {"Find the motion of the damped oscillator and of the compound pendulum: exactly and by the printed "
           "recursions. Draw the phase planes, the hodograph of the pendulum's reaction, and compare the periods.",
           "Trovare il moto dell'oscillatore smorzato e del pendolo composto: in modo esatto e con gli schemi "
           "numerici. Disegnare i piani delle fasi, l'odografo della reazione del pendolo, e confrontare i periodi."},
      .givens = given_specs(),
      .printed = printed_by_the_source,
      .audit = audited_tables};
  const std::vector<PartOfExercise> parts{
      {"oscillator",
       [](const Givens& givens, Rung rung) { return settle(OscillatorRoutes{Problem(givens).oscillator}, rung); }},
      {"pendulum",
       [](const Givens& givens, Rung rung) { return settle(PendulumRoutes{Problem(givens).pendulum}, rung); }}};
  return exercise_of_panels(
      std::move(about), parts,
      {{{"motion",
         {"Motion of the oscillator", "Moto dell'oscillatore"},
         {"Find the motion of the damped oscillator, exactly and by the printed recursion.",
          "Trovare il moto dell'oscillatore smorzato, in modo esatto e con lo schema numerico."}},
        motion_sheet},
       {{"phase-plane",
         {"Phase plane of the oscillator", "Piano delle fasi dell'oscillatore"},
         {"Draw the phase plane of the damped oscillator.",
          "Disegnare il piano delle fasi dell'oscillatore smorzato."}},
        phase_plane_sheet},
       {{"pendulum-plane",
         {"Phase plane of the pendulum", "Piano delle fasi del pendolo"},
         {"Draw the phase plane of the compound pendulum.", "Disegnare il piano delle fasi del pendolo composto."}},
        pendulum_plane_sheet},
       {{"positions",
         {"Positions and forces of the pendulum", "Posizioni e forze del pendolo"},
         {"Find the forces on the compound pendulum in its positions.",
          "Trovare le forze sul pendolo composto nelle sue posizioni."}},
        positions_sheet},
       {{"hodograph",
         {"Hodograph of the reaction", "Odografa della reazione"},
         {"Draw the hodograph of the reaction of the compound pendulum.",
          "Disegnare l'odografa della reazione del pendolo composto."}},
        hodograph_sheet},
       {{"angle",
         {"Angle and periods of the pendulum", "Angolo e periodi del pendolo"},
         {"Find the angle of the compound pendulum over time, exactly and by the printed recursion, and compare its "
          "periods.",
          "Trovare l'angolo del pendolo composto nel tempo, in modo esatto e con lo schema numerico, e confrontarne "
          "i periodi."}},
        angle_sheet},
       {{"oscillator-table",
         {"Table of the oscillator", "Tabella dell'oscillatore"},
         {"Find the motion of the damped oscillator row by row, by the printed recursion.",
          "Trovare il moto dell'oscillatore smorzato riga per riga, con lo schema numerico."}},
        oscillator_table_sheet,
        oscillator_table},
       {{"pendulum-table",
         {"Table of the pendulum", "Tabella del pendolo"},
         {"Find the motion of the compound pendulum row by row, by the printed recursion.",
          "Trovare il moto del pendolo composto riga per riga, con lo schema numerico."}},
        pendulum_table_sheet,
        pendulum_table}});
}

}  // namespace epure
