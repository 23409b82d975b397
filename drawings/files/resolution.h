// How fine a picture of a page is.
#pragma once

#include <string>

namespace epure::drawings {

inline constexpr double points_per_inch = 72;

// A PNG file that says so in its chunk pHYs (PNG specification, 11.3.5.3: whole pixels a metre). What Cairo writes
// says nothing of it.
std::string with_resolution(std::string png, double dots_per_inch);

}  // namespace epure::drawings
