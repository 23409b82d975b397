// The piston pump of `macchine`: its motor's stiffness and its flywheel.
#include "exercises/pump-flywheel/printed.h"
#include "exercises/pump-flywheel/routes.h"
#include "exercises/pump-flywheel/sheets.h"

namespace epure {

std::unique_ptr<Exercise> make_pump_flywheel() {
  using namespace pump_flywheel;
  Description about{.id = "pump-flywheel",
                    .title = {"The flywheel of a piston pump", "Il volano di una pompa a stantuffo"},
                    .document = "macchine",
                    .item = "Irregolarità periodica",
                    .source = {"Exercises on machines, \"Irregolarità periodica\"",
                               "Esercizi di macchine, \"Irregolarità periodica\""},
                    .givens = given_specs(),
                    .printed = printed_by_the_source()};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{Pump(givens)}, rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"torque", {"Resisting torque", "Momento resistente"}}, torque_sheet},
       {{"energy", {"Energy of the flywheel", "Energia del volano"}}, energy_sheet},
       {{"energy-with-mass", {"With the reciprocating mass", "Con le masse alterne"}}, energy_with_mass_sheet},
       {{"wittenbauer", {"Wittenbauer's diagram", "Diagramma di Wittenbauer"}}, wittenbauer_sheet},
       {{"harmonics", {"Harmonics and cut-off", "Armoniche e frequenza di taglio"}}, harmonics_sheet}});
}

}  // namespace epure
