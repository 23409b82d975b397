// The exercise as its tests try it.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& thrust() {
  static const Tried tried("michell-thrust");
  return tried;
}

}  // namespace epure::tests
