// Letters as shapes.
#pragma once

#include <vector>

#include "drawings/text/fonts.h"

namespace epure::drawings {

// The closed contours of a glyph in font units, y upwards, to be filled by the nonzero rule; empty for a space. The
// shipped fonts draw in whole units, and so they come. Throws std::bad_alloc, or std::runtime_error saying what
// failed.
std::vector<Path> glyph_outline(Face face, unsigned glyph);

}  // namespace epure::drawings
