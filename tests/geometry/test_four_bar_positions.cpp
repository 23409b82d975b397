// Special positions of the four-bar: all of the corpus to 40 digits, linkages whose special positions are Pythagorean
// worked out by hand, and the questions put to positions that hit, or miss by 1e-9, 1e-15 and 1e-30.
#include "geometry/mechanisms/four_bar_questions.h"
#include "tests/geometry/four_bar_cases.h"
#include "tests/support/catch.h"

#include <cstdio>

namespace epure::tests {
namespace {

// What the corpus calls a position: dead_centre_extended_left, crank_limit_folded_right, parallel_same_sense_left ...
template <class T>
FourBarPosition<T> named_position(const FourBarLengths& of, const std::string& name) {
  const auto says = [&](const char* word) { return name.find(word) != std::string::npos; };
  const Side side = says("left") ? Side::left : Side::right;
  const Reach reach = says("extended") ? Reach::extended : Reach::folded;
  if (says("dead_centre")) return dead_centre<T>(of, reach, side);
  if (says("crank_limit")) return crank_limit<T>(of, reach, side);
  return parallel_position<T>(of, says("same") ? Sense::same : Sense::opposite, side);
}

// The angle of v in (-pi, pi], beside the reference: no cut is near.
Deep angle_beside(const Rational& reference, const Vector<Deep>& v) {
  if (sign(v.x) != Sign::negative) return arc_tangent(v.y, v.x);
  return (reference < 0 ? -pi<Deep>() : pi<Deep>()) + arc_tangent(-v.y, -v.x);
}

bool is_position(const std::string& name) {
  return name.find("crank_angle") != std::string::npos || name.find("rocker_angle") != std::string::npos;
}

// A linkage that stands in a special position when its crank points along `crank`.
struct Hit {
  std::string what;
  FourBarLengths of;
  Heading crank;
  Side branch;
};

// Pythagorean, so that hinges, lengths and directions are integers.
const std::array hits{
    // B (15, 20): 25 from A0 = 5 + 20, 29 from B0 (20-21-29).
    Hit{"dead centre extended", {5, 20, 29, 36, 0}, {3, 4}, Side::left},
    // B the same, 25 = 30 - 5: the crank points away from it.
    Hit{"dead centre folded", {5, 30, 29, 36, 0}, {-3, -4}, Side::left},
    // B the same, 25 = 30 - 5 with the longer bar as crank: B on the way to A, and A on the other side of B0.
    Hit{"dead centre folded", {30, 5, 29, 36, 0}, {3, 4}, Side::right},
    // A (6, 8), B0B = (18, 24), B0 (18, 0): AB = (30, 16) = 34.
    Hit{"parallel same sense", {10, 34, 30, 18, 0}, {3, 4}, Side::left},
    // A (6, 8), B0B = -(18, 24), B0 (48, 0): AB = (24, -32) = 40.
    Hit{"parallel opposite sense", {10, 40, 30, 48, 0}, {3, 4}, Side::right},
    // A (15, 20), B0 (36, 0): AB0 = 29 = 14 + 15 = 40 - 11.
    Hit{"limit extended", {25, 14, 15, 36, 0}, {3, 4}, Side::left},
    Hit{"limit folded", {25, 40, 11, 36, 0}, {3, 4}, Side::left},
    // A (-2, 0), B (3, 0), B0 (7, 0).
    Hit{"change point", {2, 5, 4, 7, 0}, {-1, 0}, Side::left},
};

// All that can be asked, and what is answered with yes.
std::vector<std::string> answered_yes(const FourBarLengths& of, const CrankDirection& crank, Side branch) {
  const std::vector<std::pair<std::string, Answer>> answers{
      {"dead centre extended", is_dead_centre(of, crank, branch, Reach::extended)},
      {"dead centre folded", is_dead_centre(of, crank, branch, Reach::folded)},
      {"parallel same sense", is_parallel(of, crank, branch, Sense::same)},
      {"parallel opposite sense", is_parallel(of, crank, branch, Sense::opposite)},
      {"limit extended", is_crank_limit(of, crank, Reach::extended)},
      {"limit folded", is_crank_limit(of, crank, Reach::folded)},
      {"change point", is_change_point(of, crank)}};
  std::vector<std::string> yes;
  for (const auto& [question, answer] : answers) {
    CAPTURE(question, answer.reason.english);
    REQUIRE(answer.truth != Truth::undecided);
    if (answer.truth == Truth::yes) yes.push_back(question);
  }
  return yes;
}

const std::vector<std::string> nothing;

}  // namespace

TEST_CASE("positions: the corpus, to all 40 digits", "[four-bar-positions]") {
  const Arithmetic<Deep> scope(256);
  int held = 0, absent = 0;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/four_bar_special.txt")) {
    const FourBarLengths of = four_bar_lengths_of(c);
    for (const Reference& r : c.references) {
      if (!is_position(r.name)) continue;
      CAPTURE(c.name, r.name, r.value);
      if (r.value == "absent") {
        CHECK_THROWS_AS(named_position<Deep>(of, r.name), Impossible);
        ++absent;
        continue;
      }
      const FourBarPosition<Deep> found = named_position<Deep>(of, r.name);
      const bool is_crank = r.name.find("crank_angle") != std::string::npos;
      const Rational reference = exact_decimal(r.value);
      const Deep angle = angle_beside(reference, is_crank ? found.crank : found.at.B - found.at.B0);
      CHECK(overlaps(angle, reference));
      if (r.value != "0") CHECK(narrow(angle));
      ++held;
    }
  }
  std::printf("four-bar positions: %d angles contained, %d absent\n", held, absent);
  CHECK(held + absent == 18 * 20);  // linkages, angles
  CHECK(held > 200);
}

TEMPLATE_TEST_CASE("positions: found on every number, closed, and on the branch that was named",
                   "[four-bar-positions]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  // How many of the six kinds exist, by the six triangles written down: A0A + AB, |A0A - AB| with B0B and A0B0; A0A
  // with AB + B0B, |AB - B0B| and A0B0; |A0A - B0B|, A0A + B0B with AB and A0B0.
  const std::vector<std::pair<FourBarLengths, int>> linkages{{on_x(2, 6, 5, 7), 4},
                                                             {on_x(5, 3, 6, 7), 4},
                                                             {on_x(5, 7, 2, 6), 4},
                                                             {on_x(4, 6, 5, 3), 3},
                                                             {on_x(3, 5, 3, 6), 3},
                                                             {on_x(6, 5, 4, 7), 5},
                                                             {FourBarLengths{2, 6, 5, 6, -3}, 4}};
  for (const auto& [of, expected] : linkages) {
    int found = 0;
    for (const char* kind : {"dead_centre_extended", "dead_centre_folded", "crank_limit_extended",
                             "crank_limit_folded", "parallel_same_sense", "parallel_opposite_sense"})
      for (const char* side : {"_left", "_right"}) {
        const Scope<T> scope;
        const std::string name = std::string(kind) + side;
        CAPTURE(name, CGAL::to_double(of.A0A), CGAL::to_double(of.AB), CGAL::to_double(of.B0B));
        try {
          const FourBarPosition<T> position = named_position<T>(of, name);
          const FourBar<T>& at = position.at;
          CHECK(is(length_squared(position.crank), T(1)));
          CHECK(is(at.A, at.A0 + from_rational<T>(of.A0A) * position.crank));
          CHECK(is_closed(of, at));
          CHECK(is_on_branch(at, position.branch));
          const Vector<T> AB = at.B - at.A, B0B = at.B - at.B0;
          const bool is_extended = name.find("extended") != std::string::npos;
          if (name.find("dead") == 0) CHECK(runs_along(position.crank, is_extended ? AB : -AB));
          if (name.find("crank") == 0) CHECK(runs_along(AB, is_extended ? -B0B : B0B));
          if (name.find("parallel") == 0)
            CHECK(runs_along(position.crank, name.find("same") != std::string::npos ? B0B : -B0B));
          ++found;
        } catch (const Impossible&) {
        }
      }
    CHECK(found == 2 * expected);
  }
}

TEST_CASE("positions: Pythagorean linkages, worked out by hand", "[four-bar-positions]") {
  const Arithmetic<Bounded> bounded;
  const Arithmetic<Exact> tower;
  const Vector<Exact> u{number<Exact>(3, 5), number<Exact>(4, 5)};
  const auto& [extended, folded, long_crank, same, against, limit_extended, limit_folded, change] = hits;
  const auto dead = dead_centre<Exact>(extended.of, Reach::extended, Side::left);
  CHECK(is(dead.crank, u));
  CHECK(is(dead.at.B, {15, 20}));
  CHECK(dead.branch == Side::left);
  CHECK(is(dead_centre<Exact>(extended.of, Reach::extended, Side::right).at.B, {15, -20}));
  CHECK(is(dead_centre<Exact>(folded.of, Reach::folded, Side::left).crank, -u));
  CHECK(is(dead_centre<Exact>(folded.of, Reach::folded, Side::left).at.B, {15, 20}));
  CHECK(is(dead_centre<Exact>(long_crank.of, Reach::folded, Side::right).at.A, {18, 24}));
  CHECK(is(parallel_position<Exact>(same.of, Sense::same, Side::left).at.B, {36, 24}));
  CHECK(is(parallel_position<Exact>(against.of, Sense::opposite, Side::right).at.B, {30, -24}));
  // B divides AB0 as 14 : 15, from (15, 20) towards (36, 0); folded, 40 beyond B0.
  CHECK(is(crank_limit<Exact>(limit_extended.of, Reach::extended, Side::left).at.B,
           {number<Exact>(15 * 29 + 14 * 21, 29), number<Exact>(20 * 15, 29)}));
  CHECK(is(crank_limit<Exact>(limit_folded.of, Reach::folded, Side::left).at.B,
           {number<Exact>(15 * 29 + 40 * 21, 29), number<Exact>(20 * 29 - 20 * 40, 29)}));
  // Not one root: the tower is still the rationals.
  CHECK(Arithmetic<Exact>::storeys() == 0);
}

// Where the triangle is flat, even intervals have the position, and both branches have the same.
TEMPLATE_TEST_CASE("positions: a flat triangle is one position for both branches", "[four-bar-positions]", Fast,
                   Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // Scaled by 1/10, so that no length is a binary number.
  const FourBarLengths of{{1, 5}, {1, 2}, {2, 5}, {7, 10}, 0};
  for (const Side branch : {Side::left, Side::right}) {
    const auto dead = dead_centre<T>(of, Reach::folded, branch);
    CHECK_FALSE(dead.branch);
    CHECK(is(dead.crank, {-1, 0}));
    CHECK(is(dead.at.B, {number<T>(3, 10), 0}));
    CHECK(is(crank_limit<T>(of, Reach::extended, branch).crank, {-1, 0}));
    const auto parallel = parallel_position<T>(of, Sense::same, branch);
    CHECK_FALSE(parallel.branch);
    CHECK(is(parallel.crank, {-1, 0}));
  }
}

TEST_CASE("positions: what equal bars leave open is said", "[four-bar-positions]") {
  const Arithmetic<Exact> tower;
  // Parallelogram, equal cranks; crank and coupler equal with and without the rocker reaching A0; the same at B0.
  CHECK_THROWS_WITH(parallel_position<Exact>(on_x(3, 5, 3, 5), Sense::same, Side::left), Contains("every position"));
  CHECK_THROWS_WITH(parallel_position<Exact>(on_x(3, 5, 3, 4), Sense::same, Side::left), Contains("equally long"));
  CHECK_THROWS_WITH(dead_centre<Exact>(on_x(5, 5, 3, 3), Reach::folded, Side::left), Contains("rests on A0"));
  CHECK_THROWS_WITH(dead_centre<Exact>(on_x(5, 5, 3, 4), Reach::folded, Side::left), Contains("cannot fold"));
  CHECK_THROWS_WITH(crank_limit<Exact>(on_x(3, 5, 5, 3), Reach::folded, Side::left), Contains("A folds onto B0"));
  CHECK_THROWS_WITH(crank_limit<Exact>(on_x(3, 5, 5, 4), Reach::folded, Side::left), Contains("cannot fold"));
  CHECK_THROWS_AS(dead_centre<Exact>(on_x(3, 5, 5, 0), Reach::extended, Side::left), Impossible);
}

TEST_CASE("positions: the questions know each special position", "[four-bar-questions]") {
  for (const Hit& hit : hits) {
    CAPTURE(hit.what);
    const auto yes = answered_yes(hit.of, hit.crank, hit.branch);
    if (hit.what == "change point") {
      // Crank and coupler folded, coupler and rocker extended, all parallel: everything at once, on both branches.
      const std::vector<std::string> all{"dead centre folded", "parallel same sense", "limit extended",
                                         "change point"};
      CHECK(yes == all);
      CHECK(answered_yes(hit.of, hit.crank, opposite(hit.branch)) == all);
      continue;
    }
    CHECK(yes == std::vector{hit.what});
    const bool is_of_crank = hit.what.find("limit") == 0;
    CHECK(answered_yes(hit.of, hit.crank, opposite(hit.branch)) == (is_of_crank ? yes : nothing));
    CHECK(answered_yes(hit.of, Heading{hit.crank.x, -hit.crank.y}, opposite(hit.branch)) == yes);
    CHECK(answered_yes(hit.of, Heading{hit.crank.x * 7, hit.crank.y * 7}, hit.branch) == yes);
  }
}

// A proved no, however near: in every length, in the frame's other coordinate, and in the crank's direction.
TEST_CASE("positions: the questions refuse what misses by 1e-9, 1e-15, 1e-30", "[four-bar-questions]") {
  int refused = 0;
  for (const Hit& hit : hits)
    for (const int exponent : {9, 15, 30})
      for (const Rational& e : {part(exponent), Rational(-part(exponent))}) {
        CAPTURE(hit.what, exponent);
        std::vector<std::pair<FourBarLengths, Heading>> missed(7, {hit.of, hit.crank});
        missed[0].first.A0A += e;
        missed[1].first.AB += e;
        missed[2].first.B0B += e;
        missed[3].first.x_B0 += e;
        missed[4].first.y_B0 += e;
        missed[5].second.x += e;
        missed[6].second.y += e;
        for (std::size_t i = 0; i < missed.size(); ++i) {
          CAPTURE(i);
          const auto& [of, crank] = missed[i];
          // At a change point the crank's other coordinate only makes it longer.
          if (hit.what == "change point" && i == 5) continue;
          // The longest link may now be too long by e to close at all; that is no special position either.
          CHECK(answered_yes(of, crank, hit.branch) == nothing);
          ++refused;
        }
      }
  CHECK(refused == 8 * 6 * 7 - 6);
}

// Stretched to the full: every pair of bars is in line, but no motion leaves.
TEST_CASE("positions: an immovable linkage has no change point", "[four-bar-questions]") {
  CHECK(answered_yes(on_x(1, 2, 3, 6), Heading{1, 0}, Side::left) ==
        std::vector<std::string>{"dead centre extended", "parallel opposite sense", "limit extended"});
}

TEST_CASE("positions: cranks at turns that no field holds", "[four-bar-questions]") {
  // Isosceles: A0A = A0B0, so AB0 = 2 A0A sin(10°) for a crank at 20°; irrational, so never a limit of rational bars,
  // and an equilateral at 60°: AB0 = 5 = 2 + 3.
  CHECK(answered_yes(on_x(5, 2, 3, 5), Turn{{1, 18}}, Side::left) == nothing);
  CHECK(answered_yes(on_x(5, 2, 3, 5), Turn{{1, 6}}, Side::left) == std::vector<std::string>{"limit extended"});
  for (const int exponent : {9, 15, 30})
    CHECK(answered_yes(on_x(5, 2, 3, 5), Turn{Rational(1, 6) + part(exponent)}, Side::left) == nothing);
  // A parallelogram is parallel at any turn, on one branch; here the proof is the climb's last rung.
  const CrankDirection seventh = Turn{{1, 7}};
  CHECK(answered_yes(on_x(3, 5, 3, 5), seventh, Side::left) == std::vector<std::string>{"parallel same sense"});
  CHECK(answered_yes(on_x(3, 5, 3, 5), seventh, Side::right) == nothing);
}

// The positions that the construction finds with roots, asked again: the same answers on the exact numbers.
TEST_CASE("positions: what was constructed is recognised", "[four-bar-questions]") {
  const FourBarLengths of = on_x(2, 6, 5, 7);
  for (const Side branch : {Side::left, Side::right}) {
    const Arithmetic<Exact> tower;
    for (const Reach reach : {Reach::extended, Reach::folded}) {
      const Vector<Exact> u = dead_centre<Exact>(of, reach, branch).crank;
      CHECK(is_dead_centre(of, u, branch, reach) == Truth::yes);
      CHECK(is_dead_centre(of, u, opposite(branch), reach) == Truth::no);
      CHECK(is_dead_centre(of, u, branch, reach == Reach::folded ? Reach::extended : Reach::folded) == Truth::no);
    }
    for (const Sense sense : {Sense::same, Sense::opposite}) {
      const Vector<Exact> u = parallel_position<Exact>(of, sense, branch).crank;
      CHECK(is_parallel(of, u, branch, sense) == Truth::yes);
      CHECK(is_parallel(of, u, opposite(branch), sense) == Truth::no);
    }
  }
}

TEST_CASE("positions: the range of the crank", "[four-bar-positions]") {
  const Arithmetic<Exact> tower;
  const auto limits = [](const CrankArc<Exact>& arc) {
    return std::array{std::pair(arc.from.reach, arc.from.crank_side), std::pair(arc.to.reach, arc.to.crank_side)};
  };
  using Ends = std::array<std::pair<Reach, Side>, 2>;
  CHECK(crank_range<Exact>(on_x(2, 6, 5, 7)).is_full_turn);
  CHECK(crank_range<Exact>(on_x(2, 5, 4, 7)).is_full_turn);  // through a change point
  CHECK(crank_range<Exact>(on_x(2, 5, 4, 7)).arcs.empty());
  // Too far only: AB0 <= 29; the arc round the frame.
  const auto far = crank_range<Exact>(on_x(25, 14, 15, 36));
  CHECK_FALSE(far.is_full_turn);
  REQUIRE(far.arcs.size() == 1);
  CHECK(limits(far.arcs[0]) == Ends{{{Reach::extended, Side::right}, {Reach::extended, Side::left}}});
  CHECK(is(far.arcs[0].to.position.at.A, {15, 20}));
  CHECK(is(far.arcs[0].from.position.at.A, {15, -20}));
  // Too near only: AB0 >= 29, and A0A + A0B0 = 61 > 51 would be too far: both.
  const auto both = crank_range<Exact>(on_x(25, 40, 11, 36));
  REQUIRE(both.arcs.size() == 2);
  CHECK(limits(both.arcs[0]) == Ends{{{Reach::folded, Side::left}, {Reach::extended, Side::left}}});
  CHECK(limits(both.arcs[1]) == Ends{{{Reach::extended, Side::right}, {Reach::folded, Side::right}}});
  CHECK(is(both.arcs[0].from.position.at.A, {15, 20}));
  const auto near = crank_range<Exact>(on_x(25, 60, 31, 36));
  REQUIRE(near.arcs.size() == 1);
  CHECK(limits(near.arcs[0]) == Ends{{{Reach::folded, Side::left}, {Reach::folded, Side::right}}});
  CHECK(is(near.arcs[0].from.position.at.A, {15, 20}));
  // Stretched to the full: one position, where both limits are.
  const auto stretched = crank_range<Exact>(on_x(1, 2, 3, 6));
  REQUIRE(stretched.arcs.size() == 1);
  CHECK(is(stretched.arcs[0].from.position.crank, {1, 0}));
  CHECK(is(stretched.arcs[0].to.position.crank, {1, 0}));
  CHECK_THROWS_AS(crank_range<Exact>(on_x(1, 2, 3, 7)), Impossible);
  CHECK_THROWS_AS(crank_range<Exact>(on_x(1, 9, 2, 3)), Impossible);
}

// Between its limits the linkage closes, beyond them it does not: 1e-30 decides.
TEST_CASE("positions: the crank reaches its limits and not beyond", "[four-bar-positions]") {
  const FourBarLengths of = on_x(25, 14, 15, 36);
  const auto closes = [&](const Heading& crank) {
    const Arithmetic<Deep> scope(512);
    try {
      four_bar(of, unit_vector<Deep>(crank), Side::left);
      return true;
    } catch (const Impossible&) {
      return false;
    }
  };
  for (const int exponent : {9, 15, 30}) {
    CHECK(closes({3, 4 - part(exponent)}));
    CHECK_FALSE(closes({3, 4 + part(exponent)}));
  }
}

}  // namespace epure::tests
