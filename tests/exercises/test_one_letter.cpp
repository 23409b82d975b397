// One letter, one value: among the quantities of an exercise, as list and check tell them.
#include <map>

#include "tests/exercises/tried_givens.h"

using namespace epure;
using namespace epure::tests;

namespace {

// What a case of an exercise has for itself: "wedge_collar." of "wedge_collar.P_i". The four-bar has positions and
// sides of its own, as its names tell.
std::string case_of(const std::string& quantity) {
  const auto point = quantity.rfind('.');
  const std::string of = point == std::string::npos ? "" : quantity.substr(0, point + 1);
  for (const std::string position : {"mirror_side_", "same_sense_main_branch_", "same_sense_other_branch_",
                                     "opposite_sense_main_branch_", "opposite_sense_other_branch_"})
    if (quantity.compare(of.size(), position.size(), position) == 0) return of + position;
  return of;
}

}  // namespace

TEST_CASE("no two quantities of a case have one symbol") {
  int seen = 0;
  for (const auto& [id, sets] : tried_givens()) {
    const CheckedExercise checked = Tried(id).checked({});
    std::map<std::string, std::string> name_of;
    for (const CheckedQuantity& each : checked.quantities) {
      const Quantity& quantity = each.spec;
      const std::string key = case_of(quantity.name) + " " + quantity.symbol + " " + quantity.unit;
      CAPTURE(id, key);
      CHECK(name_of.try_emplace(key, quantity.name).first->second == quantity.name);
      ++seen;
    }
  }
  CHECK(seen > 2000);
}
