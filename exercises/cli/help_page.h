// All that --help says of a verb, before it is set for a terminal or as a page of the manual.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/help.h"

namespace epure {

struct HelpEntry {
  std::string name;       // "NAME"; of an option all its names: "-h,--help"
  std::string type = {};  // of an option's value, "FILE"; empty: it takes none
  std::string meaning;
};

struct HelpPage {
  std::string verb;        // empty: of the program
  std::string usage = {};  // "epure draw [OPTIONS] [NAME...]"
  std::vector<HelpEntry> names = {}, options = {};
  Help help = {};
};

// For a terminal.
std::string help_text(const HelpPage& page, Language language);

}  // namespace epure
