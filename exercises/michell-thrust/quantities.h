// What is reported, by name.
#pragma once

#include <string>

#include "exercises/kit/statement/quantity.h"

namespace epure::michell_thrust {

Quantity quantity(const std::string& name);
// The same as the source's table gives it, between whose rows it interpolates on chords: other letters, as its
// numbers are others than those of the theory.
Quantity on_the_chord(const std::string& name);
// ... and of pads that lose nothing at their sides.
Quantity of_infinite_width(const std::string& name);

}  // namespace epure::michell_thrust
