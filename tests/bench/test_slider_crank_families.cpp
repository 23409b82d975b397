#include "bench/families/slider_crank_family.h"
#include "tests/bench/family_against_corpus.h"

namespace epure::tests {

TEST_CASE("a slider-crank at and beside its special positions, with every number") {
  hold_against_corpus<bench::SliderCrankSecondOrder>();
}

TEST_CASE("both polodes where they pass infinity and beside it, with every number") {
  hold_against_corpus<bench::PolodePoint>();
}

}  // namespace epure::tests
