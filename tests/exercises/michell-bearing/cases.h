// The exercise as its tests try it.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& bearing() {
  static const Tried tried("michell-bearing");
  return tried;
}

}  // namespace epure::tests
