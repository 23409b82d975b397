// Decisions, apart from computing. An undecided sign is never taken for an answer: it throws Undecided, and whoever
// climbs through the numbers asks the next one.
#pragma once

#include "geometry/numbers/numbers.h"

namespace epure::geometry::analytic {

// negative, zero or positive; throws Undecided with `question` as its sentence otherwise.
template <class T>
Sign decided_sign(const T& x, const Phrase& question) {
  const Sign s = sign(x);
  if (s == Sign::undecided) throw Undecided(question);
  return s;
}

template <class T>
bool is_zero(const T& x, const Phrase& question) {
  return decided_sign(x, question) == Sign::zero;
}

}  // namespace epure::geometry::analytic
