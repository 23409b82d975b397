// How charts and pages tell the values that a sweep goes through.
#pragma once

#include <string>

#include "exercises/cli/sweep_study.h"

namespace epure {

// "$φ_{2}$", or the symbol of a given without letters.
std::string letters_of_given(const GivenSpec& given);

// "0.25 m", "30°", or a word.
std::string value_with_unit(const Variation& of, std::uint64_t place, Language language);

// "φ = 30°, r = 0.2 m": rich text.
std::string position_in_words(const SweepStudy& study, const std::vector<std::uint64_t>& places, Language language);

}  // namespace epure
