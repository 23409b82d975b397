// The exercise of the catalogue, its corpus, and what its choices are as assignments.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& four_bar() {
  static const Tried tried("four-bar");
  return tried;
}

inline const std::vector<CorpusCase>& four_bar_corpus() {
  static const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/four_bar_exercise.txt");
  return corpus;
}

}  // namespace epure::tests
