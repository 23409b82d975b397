// How people write a unit.
#pragma once

#include <string>

namespace epure::geometry {

// As the list of known units spells it: "m/s²", "m/s2", "m·s⁻²" and "m/sec^2" as "m/s^2"; "/ min" as "1/min".
std::string spelled_unit(std::string symbol);

}  // namespace epure::geometry
