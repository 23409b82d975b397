#include "bench/families/cancelling_family.h"
#include "bench/families/meeting_family.h"
#include "tests/bench/family_against_corpus.h"

namespace epure::tests {

TEST_CASE("circles that touch, nearly touch, nest and coincide, with every number") {
  hold_against_corpus<bench::Circles>();
}

TEST_CASE("nearly parallel sides and lines of action, with every number") {
  hold_against_corpus<bench::VectorPolygon>();
}

TEST_CASE("functions whose terms cancel, with every number") { hold_against_corpus<bench::Cancelling>(); }

}  // namespace epure::tests
