// The corpus of gear pairs, as givens of the exercise.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& gear_pair() {
  static const Tried tried("gear-pair");
  return tried;
}

inline const std::vector<CorpusCase>& gear_cases() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/gears.txt");
  return cases;
}

// All but what may be wrong with the gears themselves.
inline bool numbers_pass(const CheckedExercise& result) {
  const auto of_gears = [](const Complaint& each) { return each.about == Complaint::About::mechanism; };
  return std::all_of(result.failures.begin(), result.failures.end(), of_gears) &&
         std::all_of(result.undecided.begin(), result.undecided.end(), of_gears);
}

}  // namespace epure::tests
