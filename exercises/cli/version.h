// Which epure this is, and of which libraries: the same sources with others may draw other bytes.
#pragma once

#include "exercises/cli/json_number.h"

namespace epure {

// "epure 1.0.0", and below it the libraries.
std::string version_for_people();

// {"version": "1.0.0", "libraries": {"FLINT": "2.9.0", ...}}
Json version_for_programs();

}  // namespace epure
