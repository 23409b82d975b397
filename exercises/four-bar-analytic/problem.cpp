// The givens, and when they are impossible.
#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/linkages/four_bar_on_x.h"

namespace epure::four_bar_analytic {

std::vector<GivenSpec> givens() {
  std::vector<GivenSpec> all = four_bar_on_x_givens();
  all.push_back(side_given("branch", {"side of A → B₀ on which B lies", "lato di A → B₀ dal quale sta B"}, "left",
                           "$B$", "$AB_{0}$"));
  all.push_back({"AP_along",
                 {"coupler point P, along A → B", "punto di biella P, lungo A → B"},
                 "m",
                 "0.25",
                 Range::any,
                 "$P_{∥}$"});
  all.push_back({"AP_across",
                 {"coupler point P, to the left of A → B", "punto di biella P, a sinistra di A → B"},
                 "m",
                 "0",
                 Range::any,
                 "$P_{⊥}$"});
  return all;
}

Problem problem(const Givens& givens) {
  Problem of{.instant = four_bar_on_x(givens, side_chosen(givens, "branch")),
             .AP_along = givens["AP_along"],
             .AP_across = givens["AP_across"]};
  require_drivable(of.instant);
  return of;
}

}  // namespace epure::four_bar_analytic
