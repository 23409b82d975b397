// An angle that moves though nobody asked for it.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/statement/givens.h"

namespace epure {

// Where an instant is stated, what turns has turned through another angle at every other speed. A sentence for each
// such angle whose speed varies and which does not vary itself, with what would keep it.
std::vector<Words> moved_by_speed(const Givens& givens, const std::vector<std::string>& varied);

}  // namespace epure
