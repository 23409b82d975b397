// What a command reads, it does not write over.
#pragma once

#include <filesystem>

#include "exercises/cli/options.h"

namespace epure {

// Throws WrongUsage when a file that is to be written is one that the command reads: a table of answers, a key, a
// roster, givens, a mechanism; also under another name or through a link.
void demand_not_read(const std::filesystem::path& written, const Options& options);

}  // namespace epure
