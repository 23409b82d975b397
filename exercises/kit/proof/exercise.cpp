#include "exercises/kit/proof/exercise.h"

#include "exercises/kit/proof/solution.h"

namespace epure {

Solution Exercise::solution(const Givens& givens) const { return {givens, std::vector<RouteValue>{}}; }

DrawnSheet Exercise::draw(const std::string& sheet, const Givens& givens, const SheetRequest& request) const {
  return draw(sheet, solution(givens), request);
}

}  // namespace epure
