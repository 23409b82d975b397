// A given in JSON, under the same names wherever it stands.
#pragma once

#include "exercises/cli/json_number.h"
#include "exercises/kit/statement/givens.h"

namespace epure {

// {"symbol": "r", "value": "1/5", "unit": "m", "number": 0.2}: exactly, and the nearest double. A word has no number;
// an instant that no fraction says has the symbol alone. The names it had are beside it, for who looks for them.
Json json_given(const Givens& givens, const GivenSpec& spec);

}  // namespace epure
