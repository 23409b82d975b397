// The exercise checked as the command line checks it, and givens to try it with.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/catalogue.h"
#include "exercises/kit/proof/checked.h"
#include "geometry/numbers/given.h"
#include "tests/support/corpus.h"

namespace epure::tests {

inline const Exercise& pin_in_slot() { return find_exercise(catalogue(), "pin-in-slot"); }

inline Givens givens_of(const std::vector<std::string>& assignments) {
  Givens givens(pin_in_slot().about().givens);
  for (const std::string& assignment : assignments) givens.set(assignment);
  return givens;
}

inline CheckedExercise checked(const std::vector<std::string>& assignments) {
  return check(pin_in_slot(), givens_of(assignments), Rung::climb);
}

inline const CheckedQuantity& find(const CheckedExercise& checked, const std::string& name) {
  for (const CheckedQuantity& quantity : checked.quantities)
    if (quantity.spec.name == name) return quantity;
  throw std::logic_error("no quantity " + name);
}
inline double value(const CheckedExercise& checked, const std::string& name) {
  return find(checked, name).settled.enclosure.value;
}

inline const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/slotted_lever.txt");
  return cases;
}
inline std::vector<std::string> assignments_of(const CorpusCase& c) {
  std::vector<std::string> all;
  for (const auto& [symbol, value] : c.givens) all.push_back(symbol + "=" + geometry::to_text(value));
  return all;
}

}  // namespace epure::tests
