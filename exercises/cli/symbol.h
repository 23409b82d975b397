// A quantity's symbol as plain text.
#pragma once

#include <string>

namespace epure {

// "$ω_{3}$" becomes "ω₃", "$P_{0}A$" "P₀A", "$\vec{v}_{BA}$" "v_BA", "$a_{BA}^{n}$" "a_BA^n", "$x_{G_{3'}}$" "x_G₃'".
std::string unicode_symbol(const std::string& rich_text);

}  // namespace epure
