#include "bench/families/gears_family.h"
#include "bench/families/roulette_family.h"
#include "tests/bench/family_against_corpus.h"

namespace epure::tests {

TEST_CASE("roulettes at and beside their cusps, with every number") { hold_against_corpus<bench::RoulettePoint>(); }

TEST_CASE("gear flanks at the undercut limit, at pointed teeth and with a million teeth, with every number") {
  hold_against_corpus<bench::GearFlankPoint>();
}

}  // namespace epure::tests
