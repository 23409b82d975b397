#include "bench/families/four_bar_family.h"
#include "tests/bench/family_against_corpus.h"

namespace epure::tests {

TEST_CASE("a four-bar's position at and beside its special positions, with every number") {
  hold_against_corpus<bench::FourBarPosition>();
}

TEST_CASE("a four-bar's velocities, accelerations and curvature at and beside its special positions") {
  hold_against_corpus<bench::FourBarSecondOrder>();
}

}  // namespace epure::tests
