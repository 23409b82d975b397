// The exercise as its tests try it.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& statics() {
  static const Tried tried("ideal-statics");
  return tried;
}

}  // namespace epure::tests
