// Colours of a terminal, by what they mean.
#pragma once

#include <string>

namespace epure {

enum class Ink { good, doubtful, bad };

// The text as it is, or between the codes of its colour.
std::string coloured(const std::string& text, Ink ink, bool colours);

}  // namespace epure
