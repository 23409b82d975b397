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
      {{{"integration", {"From acceleration to velocity to space", "Dall'accelerazione alla velocità allo spazio"}},
        integration_sheet},
       {{"tangents", {"Tangents through the centroids", "Tangenti per i baricentri"}}, tangents_sheet},
       {{"curves", {"The six diagrams", "I sei diagrammi"}}, curves_sheet},
       {{"errors", {"Errors of the two formulas", "Errori delle due formule"}}, errors_sheet},
       {{"table", {"Numerical table", "Tabella numerica"}}, table_sheet, long_table}});
}

}  // namespace epure
