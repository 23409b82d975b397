// The main function of every test program.
#define CATCH_CONFIG_MAIN
#define CATCH_CONFIG_ENABLE_BENCHMARKING  // must be set here too, or BENCHMARK in a test does not link
#include <catch2/catch.hpp>
