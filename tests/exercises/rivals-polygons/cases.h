// The exercise as its tests try it.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const Tried& rivals() {
  static const Tried tried("rivals-polygons");
  return tried;
}

}  // namespace epure::tests
