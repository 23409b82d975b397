// Exercise 2 of Pisa's machine design: a crane that lifts boats, against yield, fatigue and buckling.
#include "exercises/boat-crane/routes.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure {
namespace boat_crane {
namespace {

std::vector<GivenSpec> givens() {
  std::vector<GivenSpec> all = Crane::givens();
  const std::vector<GivenSpec> of_strength{
      {"sigma_S", {"yield stress", "tensione di snervamento"}, "MPa", "300", Range::positive, "$σ_{S}$"},
      {"Delta_sigma_L",
       {"fatigue limit (range)", "limite di fatica (ampiezza)"},
       "MPa",
       "200",
       Range::positive,
       "$Δσ_{L}$"},
      {"Psi",
       {"safety demanded of all checks", "sicurezza richiesta in tutte le verifiche"},
       "1",
       "1.5",
       Range::positive,
       "$Ψ$"}};
  all.insert(all.end(), of_strength.begin(), of_strength.end());
  return all;
}

}  // namespace
}  // namespace boat_crane

std::unique_ptr<Exercise> make_boat_crane() {
  using namespace boat_crane;
  Description about{.id = "boat-crane",
                    .title = {"A crane that lifts boats", "Gru per rimessaggio barche"},
                    .document = "pisa",
                    .item = "Esercizio 2",
                    .source = {"Pisa, mid-term test of 14 June 2006, exercise 2",
                               "Pisa, verifica intermedia del 14/6/2006, esercizio 2"},
                    .givens = givens()};
  const auto solve = [](const Givens& givens, Rung rung) {
    return settle(Routes(Crane(givens), Strength(givens)), rung);
  };
  return exercise_of_panels(std::move(about), solve, {});
}

}  // namespace epure
