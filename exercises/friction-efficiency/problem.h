// The mechanisms with friction: the givens beside those of the mechanisms, and what is decided on them.
#pragma once

#include "exercises/kit/linkages/loaded_mechanisms.h"

namespace epure::friction_efficiency {

struct Problem {
  LoadedMechanisms of;
  Angle phi;        // of friction, at every contact
  Rational radius;  // of the pins

  // Whether P holds nothing back in the retrograde motion; at the limit it is zero exactly.
  struct Locking {
    bool locks = false, is_limit = false;
  };
  Locking wedge, double_slider;

  // Throws BadGivens also where the direct motion jams.
  explicit Problem(const Givens& givens);
};
std::vector<GivenSpec> stated_givens();

}  // namespace epure::friction_efficiency
