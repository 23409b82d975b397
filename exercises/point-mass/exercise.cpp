// Exercise N.5 of Sapienza: a body on a straight line under a force that depends on time.
#include "exercises/point-mass/exercise.h"

#include "exercises/point-mass/routes.h"

namespace epure {

std::unique_ptr<Exercise> make_point_mass() {
  using namespace point_mass;
  Description about{
      .id = "point-mass",
      .title = {"Motion of a body under a given force", "Moto di un corpo soggetto a una forza assegnata"},
      .document = "sapienza",
      .item = "N.5",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.5",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.5"},
      .question = {"A body at rest is moved by a force that depends on time. Draw force, acceleration, velocity, "
                   "momentum, kinetic energy and space over time, by graphical integration and by Bezout's and "
                   "Cavalieri-Simpson's formulas; values and relative errors at the three instants.",
                   "Un corpo in quiete è mosso da una forza che dipende dal tempo. Disegnare forza, accelerazione, "
                   "velocità, quantità di moto, energia cinetica e spazio nel tempo, per integrazione grafica e con "
                   "le formule di Bezout e di Cavalieri-Simpson; valori ed errori relativi ai tre istanti."},
      .givens = given_specs(),
      .printed = printed_by_the_source,
      .audit = audit_of_the_table};
  const auto solve = [](const Givens& givens, Rung rung) { return solved(Routes(Problem(givens)), rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"integration",
         {"From acceleration to velocity to space", "Dall'accelerazione alla velocità allo spazio"},
         {"A body at rest is moved by a force that depends on time. Find velocity and space from the acceleration by "
          "graphical integration.",
          "Un corpo in quiete è mosso da una forza che dipende dal tempo. Trovare la velocità e lo spazio "
          "dall'accelerazione per integrazione grafica."}},
        integration_sheet},
       {{"tangents",
         {"Tangents through the centroids", "Tangenti per i baricentri"},
         {"A body at rest is moved by a force that depends on time. Find velocity and space by tangents through the "
          "centroids of the areas.",
          "Un corpo in quiete è mosso da una forza che dipende dal tempo. Trovare la velocità e lo spazio con le "
          "tangenti per i baricentri delle aree."}},
        tangents_sheet},
       {{"curves",
         {"The six diagrams", "I sei diagrammi"},
         {"A body at rest is moved by a force that depends on time. Draw force, acceleration, velocity, momentum, "
          "kinetic energy and space over time.",
          "Un corpo in quiete è mosso da una forza che dipende dal tempo. Disegnare forza, accelerazione, velocità, "
          "quantità di moto, energia cinetica e spazio nel tempo."}},
        curves_sheet},
       {{"errors",
         {"Errors of the two formulas", "Errori delle due formule"},
         {"A body at rest is moved by a force that depends on time. Find the relative errors of Bezout's and "
          "Cavalieri-Simpson's formulas at the three instants.",
          "Un corpo in quiete è mosso da una forza che dipende dal tempo. Trovare gli errori relativi delle formule "
          "di Bezout e di Cavalieri-Simpson ai tre istanti."}},
        errors_sheet},
       {{"table",
         {"Numerical table", "Tabella numerica"},
         {"A body at rest is moved by a force that depends on time. Find velocity and space row by row, by Bezout's "
          "and Cavalieri-Simpson's formulas.",
          "Un corpo in quiete è mosso da una forza che dipende dal tempo. Trovare velocità e spazio riga per riga, "
          "con le formule di Bezout e di Cavalieri-Simpson."}},
        table_sheet,
        long_table}});
}

}  // namespace epure
