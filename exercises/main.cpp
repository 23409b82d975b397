#include <malloc.h>

#include <cstdlib>
#include <iostream>

#include "exercises/cli/run.h"

int main(int count, char** words) {
  // A drawing is a few megabytes, taken and given back in pieces: kept, they need not be fetched from the system
  // again.
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  mallopt(M_TOP_PAD, 1 << 20);
  const char* const language = std::getenv("EPURE_LANG");
  return epure::run_cli(epure::catalogue(), {words + 1, words + count}, std::cout, std::cerr,
                        {.language = language ? language : ""});
}
