// A crank swept through many directions: one stretch as long as B stays on its side, and a break at limit positions
// and change points, also where they lie between two directions, or are missed by 1e-30.
#include "geometry/mechanisms/four_bar_sweep.h"
#include "tests/geometry/four_bar_cases.h"
#include "tests/support/catch.h"

namespace epure::tests {
namespace {

std::vector<CrankDirection> turns(int from, int to, int parts) {
  std::vector<CrankDirection> cranks;
  for (int k = from; k <= to; ++k) cranks.emplace_back(Turn{Rational(k, parts)});
  return cranks;
}

void check_stretches(const FourBarLengths& of, const std::vector<CrankDirection>& cranks,
                     const std::vector<Stretch>& expected) {
  const std::vector<Stretch> found = stretches(of, cranks);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i].first == expected[i].first);
    CHECK(found[i].last == expected[i].last);
    CHECK(found[i].ended_by == expected[i].ended_by);
  }
}

}  // namespace

TEST_CASE("sweep: a crank that turns fully keeps B on its side all the way round, both ways", "[sweep]") {
  std::vector<CrankDirection> cranks = turns(0, 72, 72);
  check_stretches(on_x(2, 6, 5, 7), cranks, {{0, 72, Obstacle::none}});
  CHECK(side_throughout(on_x(2, 6, 5, 7), cranks, Side::right) == Side::right);
  std::reverse(cranks.begin(), cranks.end());
  check_stretches(on_x(2, 6, 5, 7), cranks, {{0, 72, Obstacle::none}});
  check_stretches(on_x(2, 6, 5, 7), {}, {});
}

// A (15, 20) is the limit: 53.13°, 10.6 steps of 5°; the same below. Between, the linkage does not close.
TEST_CASE("sweep: limit positions between two directions", "[sweep]") {
  const FourBarLengths of = on_x(25, 14, 15, 36);
  check_stretches(of, turns(0, 72, 72), {{0, 10, Obstacle::limit}, {62, 72, Obstacle::none}});
  check_stretches(of, turns(-10, 10, 72), {{0, 20, Obstacle::none}});
  CHECK_THROWS_WITH(side_throughout(of, turns(0, 20, 72), Side::left), Contains("limit"));
  CHECK_THROWS_AS(side_throughout(of, turns(12, 15, 72), Side::left), Impossible);
  // A coarse sweep steps over a gap: both directions close, what is between them does not.
  check_stretches(of, {Turn{{-5, 36}}, Turn{{5, 36}}}, {{0, 1, Obstacle::none}});  // through the frame
  const FourBarLengths gap = on_x(5, 4, 6, 5 + part(9));  // too far only within 1e-4 of the far side
  check_stretches(gap, turns(8, 11, 20), {{0, 1, Obstacle::limit}, {3, 3, Obstacle::none}});
  check_stretches(gap, {Turn{{9, 20}}, Turn{{11, 20}}}, {{0, 0, Obstacle::limit}, {1, 1, Obstacle::none}});
  const FourBarLengths near_gap = on_x(3, 9, 5 - part(9), 7);  // too near, by 1e-9 in 4, towards B0
  check_stretches(near_gap, {Turn{{-1, 20}}, Turn{{1, 20}}}, {{0, 0, Obstacle::limit}, {1, 1, Obstacle::none}});
}

TEST_CASE("sweep: a limit position hit ends a stretch, missed by 1e-30 it does not", "[sweep]") {
  const FourBarLengths of = on_x(25, 14, 15, 36);
  const Heading before{4, 3}, limit{3, 4};
  check_stretches(of, {before, limit}, {{0, 1, Obstacle::none}});
  // Turning back there, B may come back on either side.
  check_stretches(of, {before, limit, before}, {{0, 1, Obstacle::limit}, {1, 2, Obstacle::none}});
  for (const int exponent : {9, 15, 30}) {
    const Heading inside{3 + part(exponent), 4}, outside{3 - part(exponent), 4};
    check_stretches(of, {before, inside, before}, {{0, 2, Obstacle::none}});
    check_stretches(of, {before, outside, before}, {{0, 0, Obstacle::limit}, {2, 2, Obstacle::none}});
  }
}

TEST_CASE("sweep: change points, at a direction, between two, and missed", "[sweep]") {
  const FourBarLengths of = on_x(2, 5, 4, 7);  // in line at half a turn
  check_stretches(of, turns(0, 12, 12), {{0, 6, Obstacle::change_point}, {6, 12, Obstacle::none}});
  check_stretches(of, turns(0, 6, 12), {{0, 6, Obstacle::none}});
  check_stretches(of, turns(6, 12, 12), {{0, 6, Obstacle::none}});
  check_stretches(of, turns(0, 13, 13), {{0, 6, Obstacle::change_point}, {7, 13, Obstacle::none}});
  std::vector<CrankDirection> clockwise = turns(0, 13, 13);
  std::reverse(clockwise.begin(), clockwise.end());
  check_stretches(of, clockwise, {{0, 6, Obstacle::change_point}, {7, 13, Obstacle::none}});
  CHECK_THROWS_WITH(side_throughout(of, turns(0, 13, 13), Side::left), Contains("change point"));
  CHECK(side_throughout(of, turns(-6, 6, 13), Side::left) == Side::left);
  // Two of them in a parallelogram, and the nearer one at the start.
  check_stretches(on_x(3, 5, 3, 5), turns(-1, 12, 12),
                  {{0, 1, Obstacle::change_point}, {1, 7, Obstacle::change_point}, {7, 13, Obstacle::none}});
  check_stretches(on_x(3, 5, 3, 5), {Turn{{-1, 20}}, Turn{{1, 20}}},
                  {{0, 0, Obstacle::change_point}, {1, 1, Obstacle::none}});
  for (const int exponent : {9, 15, 30}) {
    check_stretches(on_x(2 - part(exponent), 5, 4, 7), turns(0, 12, 12), {{0, 12, Obstacle::none}});
    check_stretches(on_x(2 + part(exponent), 5, 4, 7), turns(0, 12, 12),
                    {{0, 5, Obstacle::limit}, {7, 12, Obstacle::none}});
  }
}

TEST_CASE("sweep: which way round must be known", "[sweep]") {
  CHECK_THROWS_AS(stretches(on_x(2, 5, 4, 7), {Heading{1, 2}, Heading{-2, -4}}), Impossible);
  check_stretches(on_x(2, 5, 4, 7), {Heading{1, 2}, Heading{2, 4}}, {{0, 1, Obstacle::none}});
}

// The side that a sweep promises is the one on which four_bar puts B, and B moves in small steps.
TEST_CASE("sweep: within a stretch B does not jump", "[sweep]") {
  const Arithmetic<Fast> scope;
  const std::vector<CrankDirection> cranks = turns(0, 720, 720);
  for (const FourBarLengths& of :
       {on_x(2, 6, 5, 7), on_x(25, 14, 15, 36), on_x(25, 40, 11, 36), on_x(2, 5, 4, 7), on_x(3, 5, 3, 5)})
    for (const Side branch : {Side::left, Side::right})
      for (const Stretch& stretch : stretches(of, cranks)) {
        // Its ends may be limits that doubles cannot reach.
        std::optional<Point<Fast>> before;
        for (std::size_t i = stretch.first + 1; i < stretch.last; ++i) {
          const Point<Fast> B = four_bar(of, unit_vector<Fast>(cranks[i]), branch).B;
          // Near a limit B moves as the root of the crank's step of 0.0087.
          if (before) CHECK(distance(B, *before) < 0.3 * CGAL::to_double(of.B0B));
          before = B;
        }
      }
}

}  // namespace epure::tests
