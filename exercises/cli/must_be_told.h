// Which givens make these givens again.
#pragma once

#include "exercises/kit/statement/givens.h"

namespace epure {

// Whether the given must be told: it has not its stated value; or it was set, be it to the angle that it is stated to
// have, where an instant is stated, which at another speed says another angle.
inline bool must_be_told(const Givens& givens, const GivenSpec& spec) {
  if (givens.is_changed(spec.symbol)) return true;
  return spec.turned && givens.follows(spec.turned->instant) && !Givens(givens.specs()).follows(spec.turned->instant);
}

}  // namespace epure
