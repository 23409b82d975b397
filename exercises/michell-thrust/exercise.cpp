// The Michell bearing of a turbine's shaft.
#include "exercises/michell-thrust/exercise.h"

#include "exercises/michell-thrust/routes.h"

namespace epure {

std::unique_ptr<Exercise> make_michell_thrust() {
  using namespace michell_thrust;
  Description about{
      .id = "michell-thrust",
      .title = {"Michell thrust bearing", "Cuscinetto reggispinta Michell"},
      .document = "macchine",
      .item = "Cuscinetto Michell",
      .source = {"Notes on machines, Michell bearing", "Appunti di macchine, Cuscinetto Michell"},
      .question = {"Of the thrust bearing of a turbine find the least and greatest film, the tilt of the pads, the "
                   "coefficient of friction, the tangential force, the resisting torque and the power lost, by the "
                   "table of coefficients and by theory.",
                   "Del cuscinetto reggispinta di una turbina trovare gli spessori minimo e massimo del meato, "
                   "l'inclinazione dei pattini, il coefficiente d'attrito, la forza tangenziale, la coppia "
                   "resistente e la potenza persa, con la tabella dei coefficienti e con la teoria."},
      .givens = given_specs(),
      .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) {
    const Problem problem(givens);
    return settle(Routes{problem}, rung);
  };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"coefficients",
         {"Coefficients of the film", "Coefficienti del meato"},
         {"Of the thrust bearing of a turbine find the coefficients of the film, by the table and by theory.",
          "Del cuscinetto reggispinta di una turbina trovare i coefficienti del meato, con la tabella e con la "
          "teoria."}},
        coefficients_sheet},
       {{"pad",
         {"Film and pressure", "Meato e pressioni"},
         {"Of the thrust bearing of a turbine find the least and greatest film, the tilt of the pads and the "
          "pressures.",
          "Del cuscinetto reggispinta di una turbina trovare gli spessori minimo e massimo del meato, l'inclinazione "
          "dei pattini e le pressioni."}},
        pad_sheet},
       {{"forces",
         {"Forces on the pads", "Forze sui pattini"},
         {"Of the thrust bearing of a turbine find the coefficient of friction, the tangential force, the resisting "
          "torque and the power lost.",
          "Del cuscinetto reggispinta di una turbina trovare il coefficiente d'attrito, la forza tangenziale, la "
          "coppia resistente e la potenza persa."}},
        forces_sheet}});
}

}  // namespace epure
