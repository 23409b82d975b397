// Who sets the letters and writes the pages.
#pragma once

#include "words/library.h"

namespace epure::drawings {

Libraries libraries();

}  // namespace epure::drawings
