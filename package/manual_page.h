// Help as pages of the manual (man 7 groff_man).
#pragma once

#include <string>

#include "exercises/cli/help_page.h"

namespace epure {

// "epure", "epure-draw": the name of the page, and of its file before ".1".
std::string name_of_manual_page(const std::string& verb);

// `version`: "1.0.0".
std::string manual_page(const HelpPage& page, Language language, const std::string& version);

}  // namespace epure
