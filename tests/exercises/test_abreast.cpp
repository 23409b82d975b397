// Independent jobs on all processors: all run, in any order; the first failure comes through; nothing is left behind.
#include "exercises/cli/abreast.h"
#include "geometry/numbers/numbers.h"
#include "tests/support/catch.h"

#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace epure;
using namespace epure::geometry;

TEST_CASE("Every job runs once") {
  for (const std::size_t count : {0U, 1U, 3U, 50U}) {
    std::vector<int> runs(count, 0);
    abreast(count, [&](std::size_t i) { ++runs[i]; });
    CHECK(runs == std::vector<int>(count, 1));
  }
}

TEST_CASE("Of several failures the first in order comes through") {
  const auto failing = [](std::size_t i) {
    if (i == 7 || i == 31) throw std::runtime_error(std::to_string(i));
  };
  CHECK_THROWS_WITH(abreast(50, failing), "7");
}

// That the sanitised program ends without a report is the check: what FLINT holds for a thread would be lost with it.
TEST_CASE("Jobs compute with every number in a second thread too") {
  if (std::thread::hardware_concurrency() < 2) return;
  std::latch both(2);  // nobody takes two of the first two jobs
  std::vector<Sign> found(50, Sign::positive);
  abreast(found.size(), [&](std::size_t i) {
    if (i < 2) both.arrive_and_wait();
    const Arithmetic<Deep> deep(4096);
    const Arithmetic<Exact> exact;
    const Arithmetic<Calcium> calcium;
    const Calcium c = cosine<Calcium>(Turn{Rational(1, 5)});
    const bool nests = (root(Exact(3 + 2 * root(Exact(2)))) - 1 - root(Exact(2))).is_zero();
    if (nests) found[i] = sign(4 * c * c + 2 * c - 1);
  });
  CHECK(found == std::vector<Sign>(50, Sign::zero));
}
