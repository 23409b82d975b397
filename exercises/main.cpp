#include "exercises/bench_beside.h"
#include "exercises/program.h"

int main(int count, char** words) { return epure::run_program(count, words, epure::bench_beside(words)); }
