#include <iostream>

#include "exercises/cli/run.h"

int main(int count, char** words) {
  return epure::run_cli(epure::catalogue(), {words + 1, words + count}, std::cout, std::cerr);
}
