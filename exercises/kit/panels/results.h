// What the column tells as results: quantities of the solution, and nothing else.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "drawings/picture.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// A line or a table; none when the quantities do not exist.
using Result = std::function<std::optional<drawings::Block>(const Solution&, Language)>;

// "v_A = (12.7; 1.7) m/s,  v_A = 12.8 m/s", with an arrow over the first.
Result components(const VectorQuantity& quantity);
// "P0 = (0; 4) m"
Result coordinates(const std::string& point);

// As sheets write it: "m/s²".
std::string written_unit(const std::string& unit);

}  // namespace epure
