// What `epure bench` holds against 40 digits: positions of mechanisms given as links and joints.
#include "bench/corpus_folder.h"
#include "bench/many_positions.h"
#include "tests/support/catch.h"

namespace epure::tests {

TEST_CASE("mechanisms as links and joints are as near to the corpus as the four-bar by hand") {
  constexpr double as_told = 1e-13, bound_as_told = 1e-10;  // README: 4e-14 and 9e-11
  const auto results = bench::measure_positions(bench::corpus_folder().string(), 0);
  CHECK(results.size() == 9);
  for (const bench::PositionResult& each : results) {
    CAPTURE(each.mechanism, each.number);
    CHECK(each.max_relative_error < as_told);
    CHECK(each.max_relative_bound.value_or(0) < bound_as_told);
    CHECK(each.max_relative_bound.has_value() == (each.number != "fast"));
  }
}

}  // namespace epure::tests
