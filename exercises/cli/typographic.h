// Numbers of a terminal as documents set them.
#pragma once

#include <string>

namespace epure {

// "−12.3" for "-12.3"; "–" for a hyphen alone.
std::string with_true_minus(std::string text);

// As sheets write numbers: "−12.3", "1.2·10⁻⁷". Rich text.
std::string typographic(std::string number);

}  // namespace epure
