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
                    .question = {"A motor drives a single-acting piston pump. Find the speed of the crank, the mean "
                                 "resisting torque and the power; whether the motor limits the irregularity by "
                                 "itself; if not, the flywheel that keeps it to the given value.",
                                 "Un motore muove una pompa a stantuffo a semplice effetto. Trovare la velocità "
                                 "della manovella, la coppia resistente media e la potenza; se il motore limita da "
                                 "solo l'irregolarità; se no, il volano che la contiene entro il valore dato."},
                    .givens = given_specs(),
                    .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{Pump(givens)}, rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"torque",
         {"Resisting torque", "Momento resistente"},
         {"A motor drives a single-acting piston pump. Find the speed of the crank, the mean resisting torque and "
          "the power.",
          "Un motore muove una pompa a stantuffo a semplice effetto. Trovare la velocità della manovella, la coppia "
          "resistente media e la potenza."}},
        torque_sheet},
       {{"energy",
         {"Energy of the flywheel", "Energia del volano"},
         {"A motor drives a single-acting piston pump. Find the fluctuation of energy and the flywheel that keeps "
          "the irregularity to the given value.",
          "Un motore muove una pompa a stantuffo a semplice effetto. Trovare l'energia che fluttua e il volano che "
          "contiene l'irregolarità entro il valore dato."}},
        energy_sheet},
       {{"energy-with-mass",
         {"With the reciprocating mass", "Con le masse alterne"},
         {"A motor drives a single-acting piston pump. Find the fluctuation of energy and the flywheel, the "
          "reciprocating mass among it.",
          "Un motore muove una pompa a stantuffo a semplice effetto. Trovare l'energia che fluttua e il volano, con "
          "le masse alterne."}},
        energy_with_mass_sheet},
       {{"wittenbauer",
         {"Wittenbauer's diagram", "Diagramma di Wittenbauer"},
         {"A motor drives a single-acting piston pump. Find the flywheel that keeps the irregularity to the given "
          "value by Wittenbauer's diagram.",
          "Un motore muove una pompa a stantuffo a semplice effetto. Trovare il volano che contiene l'irregolarità "
          "entro il valore dato con il diagramma di Wittenbauer."}},
        wittenbauer_sheet},
       {{"harmonics",
         {"Harmonics and cut-off", "Armoniche e frequenza di taglio"},
         {"A motor drives a single-acting piston pump. By the harmonics of the torque and the motor's cut-off find "
          "whether the motor limits the irregularity by itself.",
          "Un motore muove una pompa a stantuffo a semplice effetto. Trovare, con le armoniche della coppia e la "
          "frequenza di taglio del motore, se esso limita da solo l'irregolarità."}},
        harmonics_sheet}});
}

}  // namespace epure
