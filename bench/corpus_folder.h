// Where the corpora are at run time.
#pragma once

#include <filesystem>

namespace epure::bench {

// For an installed program the folder installed with it; for one that is run where it was built, that of the sources.
std::filesystem::path corpus_folder();

}  // namespace epure::bench
