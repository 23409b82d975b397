#include "exercises/program.h"

#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "exercises/want_of_room.h"

namespace epure {
namespace {

// Colours are for a terminal that knows them, and for those who want them (no-color.org).
bool shows_colours() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value ? value : "");
  };
  return ::isatty(STDOUT_FILENO) == 1 && variable("NO_COLOR").empty() && !variable("TERM").empty() &&
         variable("TERM") != "dumb";
}

}  // namespace

int run_program(int count, char** words, const Bench& bench) {
  // A drawing is a few megabytes, taken and given back in pieces: kept, they need not be fetched from the system
  // again.
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  mallopt(M_TOP_PAD, 1 << 20);
  end_as_told_for_want_of_room();
  std::ios::sync_with_stdio(false);  // else a signal would end a write, where now it is repeated
  const char* const language = std::getenv("EPURE_LANG");
  return run_cli(catalogue(), {words + 1, words + count}, std::cout, std::cerr,
                 {.language = language ? language : "",
                  .colours = shows_colours(),
                  .out_is_terminal = ::isatty(STDOUT_FILENO) == 1,
                  .err_is_terminal = ::isatty(STDERR_FILENO) == 1,
                  .bench = bench});
}

}  // namespace epure
