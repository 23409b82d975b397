// The command line, for any catalogue of exercises.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "exercises/cli/catalogue.h"

namespace epure {

// Exit codes. Anything but success and failed_check comes with one sentence on `err`, which begins with "epure: ".
enum class Exit { success = 0, failed_check = 1, wrong_usage = 2, cannot_write = 3, internal_error = 70 };

// What a run takes from around it besides its arguments.
struct Surroundings {
  std::string language = {};  // EPURE_LANG: what --lang says otherwise; empty: English
};

// `arguments` without the program's name. What is asked for goes to `out`, and to files.
int run_cli(const Catalogue& exercises, const std::vector<std::string>& arguments, std::ostream& out,
            std::ostream& err, const Surroundings& surroundings = {});

}  // namespace epure
