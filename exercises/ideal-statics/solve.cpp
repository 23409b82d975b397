#include "exercises/ideal-statics/exercise.h"
#include "exercises/ideal-statics/routes.h"

namespace epure::ideal_statics {

std::vector<RouteValue> solve(const Givens& givens, Rung rung) {
  return settle(Routes{LoadedMechanisms(givens)}, rung);
}

}  // namespace epure::ideal_statics
