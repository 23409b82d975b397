#include "exercises/program.h"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
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

// Letters are not to be others for what somebody set for other programs.
void forget_settings_of_letters() {
  for (const char* variable : {"HB_SHAPER_LIST", "HB_OPTIONS", "FREETYPE_PROPERTIES"}) ::unsetenv(variable);
}

// A drawing is a few megabytes, taken and given back in pieces: kept, they need not be fetched from the system again.
void keep_memory() {
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  mallopt(M_TOP_PAD, 1 << 20);
}

// What a sheet takes of it, fetched at once and in huge pages: page by page, as each is touched first, costs ten
// times as much. Where such a page begins nothing may stand yet, so what malloc takes is to begin a little before. A
// system that has none gives small pages; one that cannot (Linux before 5.14) or will not gives them as they are
// touched.
void fetch_memory() {
#ifdef MADV_POPULATE_WRITE
  constexpr std::size_t huge = 2 << 20, of_a_sheet = 2 * huge, before = 64 << 10;
  const auto end = reinterpret_cast<std::uintptr_t>(::sbrk(0)) + before;
  ::sbrk(static_cast<std::intptr_t>(huge - end % huge));
  void* const taken = std::malloc(before + of_a_sheet);
  const auto from = reinterpret_cast<std::uintptr_t>(taken), first = (from / huge + 1) * huge;
  if (taken && first - from <= before) {  // else it is not where it was made to begin
    ::madvise(reinterpret_cast<void*>(first), of_a_sheet, MADV_HUGEPAGE);
    ::madvise(reinterpret_cast<void*>(first), of_a_sheet, MADV_POPULATE_WRITE);
  }
  std::free(taken);
#endif
}

// Before the constants of all files are made, which takes memory. (Up to 100 is the compiler's.)
[[gnu::constructor(101)]] void before_main() { end_as_told_for_want_of_room(); }

}  // namespace

int run_program(int count, char** words, const Bench& bench) {
  forget_settings_of_letters();
  keep_memory();
  fetch_memory();
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
