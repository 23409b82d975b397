// Where the shipped fonts are at run time.
#pragma once

#include <filesystem>

namespace epure::drawings {

// For an installed program the folder installed with it, wherever that was moved to; for one that is run where it was
// built, the folder of the sources.
std::filesystem::path font_folder();

}  // namespace epure::drawings
