// What is reported, by name; the name of an instant stands behind "_at_": "0p5" for 0.5 s.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/statement/quantity.h"
#include "geometry/numbers/number.h"

namespace epure::oscillator_pendulum {

using geometry::Rational;

// "0p5", "12"
Rational instant(const std::string& name);

Quantity oscillator_quantity(const std::string& name);
Quantity pendulum_quantity(const std::string& name);
// Of "x", "x_euler", "theta", "R_12_x_numeric" ... at an instant.
Quantity at_instant(const std::string& of, const std::string& name_of_instant);

// Which instants are reported of it.
const std::vector<std::string>& instants(const std::string& of);

}  // namespace epure::oscillator_pendulum
