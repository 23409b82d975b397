// What PostScript needs done to a page.
#pragma once

#include <string>

#include "drawings/page.h"

namespace epure::drawings {

// The page without transparency: what is translucent is mixed with white, and painted first, as it would otherwise
// cover what shows through it.
Page flattened(Page page);

// A PostScript file that does not tell when it was made, so that the same drawing is the same file.
std::string without_date(std::string postscript);

}  // namespace epure::drawings
