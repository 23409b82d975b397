// What epure does. Each verb returns the text for standard output; exceptions say why it cannot.
#pragma once

#include <iosfwd>
#include <string>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"

namespace epure {

std::string list(const Catalogue& exercises, const Options& options);

// Writes its files before it returns, or none when one cannot be rendered. With --times a line on `err` says where
// the time went.
std::string draw(const Catalogue& exercises, const Options& options, std::ostream& err);

// Measures, writes its sheets and returns the table or the JSON. What is measured goes to `err` meanwhile.
std::string benchmark(const Catalogue& exercises, const Options& options, std::ostream& err);

struct CheckOutcome {
  std::string report;
  bool passed = true;
};
CheckOutcome check(const Catalogue& exercises, const Options& options);

// "en" or "it". Throws WrongUsage.
Language language(const Options& options);

}  // namespace epure
