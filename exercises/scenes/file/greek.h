// Greek letters in the names of givens: written in a file as they are or by their names, typed and told in ASCII, and
// drawn as letters.
#pragma once

#include <string>

namespace epure::scenes {

// "φ2" is "phi2"; what is no Greek letter stays.
std::string spelled_out(const std::string& text);

// A given's letters on a sheet, rich text: "theta_2" is "$θ_{2}$", "O2A" "$O_{2}A$", "l" "$l$".
std::string given_letters(const std::string& symbol);
// The same of what is no length between points, but a force or a mass: "F_2" is "$\\it{F}_{2}$".
std::string italic_letters(const std::string& symbol);
// "-80.5 deg": "−80.5°".
std::string as_printed(std::string amount);

}  // namespace epure::scenes
