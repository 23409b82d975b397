// The command line, for any catalogue of exercises.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"

namespace epure {

// Exit codes. Anything but success, and a check that fails or is undecided, comes with one sentence on `err`, which
// begins with "epure: ". Nothing worse than undecided: what could not be decided is named, and the rest was done.
// cannot_write stands for all that the machine denies: room to write, memory, fonts.
enum class Exit {
  success = 0,
  failed_check = 1,
  wrong_usage = 2,
  cannot_write = 3,
  undecided = 4,
  internal_error = 70
};

// What `bench` does: not the command line's own affair, as measuring is a program of its own. Gets options that were
// found sensible; returns the text for standard output.
using Bench = std::function<std::string(const Catalogue& exercises, const Options& options, std::ostream& err)>;

// What a run takes from around it besides its arguments.
struct Surroundings {
  std::string language = {};  // EPURE_LANG: what --lang says otherwise; empty: English
  bool colours = false;       // `out` is a terminal, and shows them
  bool out_is_terminal = false, err_is_terminal = false;
  Bench bench = {};
};

// `arguments` without the program's name. What is asked for goes to `out`, and to files.
int run_cli(const Catalogue& exercises, const std::vector<std::string>& arguments, std::ostream& out,
            std::ostream& err, const Surroundings& surroundings = {});

}  // namespace epure
