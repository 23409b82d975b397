// The exercise as its tests try it.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& both() {
  static const Tried tried("cycloid-involute");
  return tried;
}

}  // namespace epure::tests
