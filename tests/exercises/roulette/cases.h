// The exercise as its tests try it.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& roulette() {
  static const Tried tried("roulette");
  return tried;
}

}  // namespace epure::tests
