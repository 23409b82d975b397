// The quantities of an exercise as a list, found by name.
#pragma once

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "exercises/kit/statement/quantity.h"

namespace epure {

// That one of `quantities` which has this name; that there is none is a mistake in the code (assertion).
inline const Quantity& named(const std::vector<Quantity>& quantities, const std::string& name) {
  const auto found =
      std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& each) { return each.name == name; });
  assert(found != quantities.end());
  return *found;
}

}  // namespace epure
