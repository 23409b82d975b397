// Whose arithmetic the numbers are.
#pragma once

#include "words/library.h"

namespace epure::geometry {

Libraries libraries();

}  // namespace epure::geometry
