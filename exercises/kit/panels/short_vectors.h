// Vectors that are too short on paper to be measured.
#pragma once

#include <string>

#include "exercises/kit/statement/format_words.h"

namespace epure {

// "$\\vec{v}_{BA}$" as the magnitude.
std::string without_arrow(std::string letters);

// A vector's letters; of one that is shorter than its head, and so a dot, its value with them: "v_B = 0.012 m/s".
std::string letters_or_value(const std::string& letters, double length, double mm_on_paper, const std::string& unit,
                             Language language);

}  // namespace epure
