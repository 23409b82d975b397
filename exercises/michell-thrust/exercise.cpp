// The Michell bearing of a turbine's shaft.
#include "exercises/michell-thrust/exercise.h"

#include "exercises/michell-thrust/routes.h"

namespace epure {

std::unique_ptr<Exercise> make_michell_thrust() {
  using namespace michell_thrust;
  Description about{.id = "michell-thrust",
                    .title = {"Michell thrust bearing", "Cuscinetto reggispinta Michell"},
                    .document = "macchine",
                    .item = "Cuscinetto Michell",
                    .source = {"Notes on machines, Michell bearing", "Appunti di macchine, Cuscinetto Michell"},
                    .givens = given_specs(),
                    .printed = printed_by_the_source()};
  const auto solve = [](const Givens& givens, Rung rung) {
    const Problem problem(givens);
    return settle(Routes{problem}, rung);
  };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"coefficients", {"Coefficients of the film", "Coefficienti del meato"}}, coefficients_sheet},
       {{"pad", {"Film and pressure", "Meato e pressioni"}}, pad_sheet},
       {{"forces", {"Forces on the pads", "Forze sui pattini"}}, forces_sheet}});
}

}  // namespace epure
