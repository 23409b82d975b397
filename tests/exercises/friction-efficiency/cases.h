// The exercise as its tests try it.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& friction() {
  static const Tried tried("friction-efficiency");
  return tried;
}

}  // namespace epure::tests
