// The tower of quadratic fields held against CGAL's own, Sqrt_extension over Gmpq nested twice: random sums, products
// and quotients in Q(√2)(√(5 + √2)) must have the same signs in both, and be zero in both or in neither.
#include <CGAL/Gmpq.h>
#include <CGAL/Sqrt_extension.h>

#include <random>
#include <vector>

#include "geometry/numbers/exact.h"
#include "tests/support/catch.h"

namespace epure::geometry {
namespace {

using Inner = CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq>;
using Outer = CGAL::Sqrt_extension<Inner, Inner>;

// One number in both worlds.
struct Twin {
  Exact ours;
  Outer theirs;
};

int sign_of(const Exact& x) { return static_cast<int>(sign(x)); }
int sign_of(const Outer& x) { return static_cast<int>(CGAL::sign(x)); }

std::vector<Twin> generators() {
  const Exact root_2 = root(Exact(2));
  const Inner inner_root(CGAL::Gmpq(0), CGAL::Gmpq(1), CGAL::Gmpq(2)),
      radicand(CGAL::Gmpq(5), CGAL::Gmpq(1), CGAL::Gmpq(2));
  return {{Exact(1), Outer(Inner(1))},
          {root_2, Outer(inner_root)},
          {root(Exact(5) + root_2), Outer(Inner(0), Inner(1), radicand)}};
}

Twin combined(const Twin& a, const Twin& b, int operation) {
  switch (operation) {
    case 0:
      return {a.ours + b.ours, a.theirs + b.theirs};
    case 1:
      return {a.ours - b.ours, a.theirs - b.theirs};
    case 2:
      return {a.ours * b.ours, a.theirs * b.theirs};
    default:
      return b.ours.is_zero() ? a : Twin{a.ours / b.ours, a.theirs / b.theirs};
  }
}

}  // namespace

TEST_CASE("the tower agrees with nested Sqrt_extension", "[numbers][exact]") {
  const Arithmetic<Exact> scope;
  const unsigned seed = 20261121;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int zeros = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Twin> pool = generators();
    for (int step = 0; step < 10; ++step) {
      const auto pick = [&] { return pool[random() % pool.size()]; };
      pool.push_back(combined(pick(), pick(), static_cast<int>(random() % 4)));
      REQUIRE(sign_of(pool.back().ours) == sign_of(pool.back().theirs));
      zeros += pool.back().ours.is_zero() ? 1 : 0;
    }
  }
  CHECK(zeros > 20);  // the interesting answers did occur
}

}  // namespace epure::geometry
