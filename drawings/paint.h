// What Cairo draws, before it is finished.
#pragma once

#include <string>

#include "drawings/page.h"

namespace epure::drawings {

// Each primitive on a page of its own, in order, as SVG in points; two empty pages follow. So it is known which
// element is whose, and what Cairo leaves out (whatever cannot be seen) is missing where it belongs.
std::string paint_svg(const Page& page);

}  // namespace epure::drawings
