// What `epure bench` does.
#pragma once

#include <iosfwd>
#include <string>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"

namespace epure::bench {

// Measures, writes its sheets and returns the table or the JSON. What is measured goes to `err` meanwhile. The
// options must have been found sensible.
std::string benchmark(const Catalogue& exercises, const Options& options, std::ostream& err);

}  // namespace epure::bench
