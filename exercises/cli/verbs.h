// What epure does. Each verb returns the text for standard output; exceptions say why it cannot.
#pragma once

#include <string>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"

namespace epure {

std::string list(const Catalogue& exercises, const Options& options);

// Writes its files before it returns, or none when one cannot be rendered.
std::string draw(const Catalogue& exercises, const Options& options);

struct CheckOutcome {
  std::string report;
  bool passed = true;
};
CheckOutcome check(const Catalogue& exercises, const Options& options);

// "en" or "it". Throws WrongUsage.
Language language(const Options& options);

}  // namespace epure
