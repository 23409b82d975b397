// What --help says around the options.
#pragma once

#include "words/words.h"

namespace epure {

// What it is for, in one sentence; what is to be known; commands to try.
struct Help {
  Words purpose, remarks = {};
  std::string examples;
};

Help help_of_program();
Help help_of_list();
Help help_of_draw();
Help help_of_check();
Help help_of_report();
Help help_of_booklet();
Help help_of_sweep();
Help help_of_class();
Help help_of_mark();
Help help_of_import();
Help help_of_bench();

// What each exit code means; the end of every help.
Words exit_codes();

}  // namespace epure
