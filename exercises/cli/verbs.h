// What epure does. Each verb returns the text for standard output; exceptions say why it cannot.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"
#include "exercises/cli/run.h"

namespace epure {

std::string list(const Catalogue& exercises, const Options& options);

// The text for standard output, what else is to be said (a sentence each, for standard error), and the exit code.
struct Outcome {
  std::string text;
  Exit exit = Exit::success;
  std::vector<Words> remarks = {};
};

// Writes its files before it returns, or none when one cannot be rendered. A sheet on which something could not be
// decided is left out, with a remark: throws geometry::Undecided when no sheet is left. With --times a line on `err`
// says where the time went.
Outcome draw(const Catalogue& exercises, const Options& options, std::ostream& err);

Outcome check(const Catalogue& exercises, const Options& options);

// Writes the file of -o, if there is one. What could not be decided is named in remarks.
Outcome mark(const Catalogue& exercises, const Options& options);

// "en" or "it". Throws WrongUsage.
Language language(const Options& options);

}  // namespace epure
