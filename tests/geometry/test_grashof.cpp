// Grashof's class and who turns fully: textbook linkages, integer ones on the borders, ones that miss a border by
// 1e-30, and the class against a search through all small linkages.
#include "tests/geometry/four_bar_cases.h"
#include "tests/support/catch.h"

#include <cstdio>
#include <set>

namespace epure::tests {
// R. L. Norton, Design of Machinery, chapter 2, problem "calculate the Grashof condition": 2, 4.5, 7, 9 fulfils it,
// 2, 3.5, 7, 9 does not, 2, 4, 6, 8 is the special case.
TEST_CASE("grashof: Norton's three linkages in all their inversions", "[grashof]") {
  const std::array<Rational, 3> middle{Rational(9, 2), Rational(7, 2), Rational(4)};
  const std::array<std::array<Rational, 2>, 3> longer{{{7, 9}, {7, 9}, {6, 8}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational s = 2, p = middle[k], q = longer[k][0], l = longer[k][1];
    CAPTURE(k);
    const std::array<FourBarLengths, 4> inversions{on_x(s, p, q, l), on_x(l, s, p, q), on_x(q, l, s, p),
                                                   on_x(p, q, l, s)};
    const std::array fulfils{LinkageClass::crank_rocker, LinkageClass::double_rocker, LinkageClass::rocker_crank,
                             LinkageClass::double_crank};
    const std::array shortest{FourBarLink::crank, FourBarLink::coupler, FourBarLink::rocker, FourBarLink::frame};
    for (std::size_t i = 0; i < 4; ++i) {
      const Grashof found = grashof(inversions[i]);
      CHECK(found.is == (k == 0 ? fulfils[i] : k == 1 ? LinkageClass::triple_rocker : LinkageClass::change_point));
      CHECK(found.shortest == std::vector{shortest[i]});
    }
  }
}

TEST_CASE("grashof: on the borders", "[grashof]") {
  CHECK(grashof(on_x(2, 5, 4, 7)).is == LinkageClass::change_point);
  const Grashof parallelogram = grashof(on_x(3, 5, 3, 5));
  CHECK(parallelogram.is == LinkageClass::change_point);
  CHECK(parallelogram.shortest == std::vector{FourBarLink::crank, FourBarLink::rocker});
  CHECK(grashof(on_x(1, 1, 1, 1)).shortest.size() == 4);
  CHECK(grashof(on_x(3, 5, 5, 3)).is == LinkageClass::change_point);  // kite
  // Stretched to the full, and torn.
  CHECK(grashof(on_x(1, 2, 3, 6)).is == LinkageClass::immovable);
  CHECK(grashof(on_x(9, 2, 3, 4)).is == LinkageClass::immovable);
  CHECK_THROWS_AS(grashof(on_x(1, 2, 3, 7)), Impossible);
  CHECK_THROWS_AS(grashof(on_x(0, 2, 3, 4)), Impossible);
  CHECK_THROWS_AS(grashof(on_x(1, 2, -3, 4)), Impossible);
  CHECK_THROWS_AS(grashof(on_x(1, 2, 3, 0)), Impossible);
  // Two equally short links keep nothing from being a triple rocker: 3 + 8 > 3 + 5.
  CHECK(grashof(on_x(3, 5, 3, 8)).is == LinkageClass::triple_rocker);
}

TEST_CASE("grashof: the border missed by 1e-9, 1e-15, 1e-30 in any link", "[grashof]") {
  for (const int exponent : {9, 15, 30}) {
    CAPTURE(exponent);
    const Rational e = part(exponent);
    CHECK(grashof(on_x(2 - e, 5, 4, 7)).is == LinkageClass::crank_rocker);
    CHECK(grashof(on_x(2 + e, 5, 4, 7)).is == LinkageClass::triple_rocker);
    CHECK(grashof(on_x(2, 5 + e, 4, 7)).is == LinkageClass::crank_rocker);
    CHECK(grashof(on_x(2, 5, 4 - e, 7)).is == LinkageClass::triple_rocker);
    CHECK(grashof(on_x(2, 5, 4, 7 - e)).is == LinkageClass::crank_rocker);
    // The frame's length is irrational now: √(49 + e²) > 7.
    CHECK(grashof({2, 5, 4, 7, e}).is == LinkageClass::triple_rocker);
    CHECK(grashof({3, 5, 3, 5, e}).is == LinkageClass::triple_rocker);
    CHECK(grashof({3, 5, 3 + e, 5, 0}).is == LinkageClass::crank_rocker);
    CHECK(grashof(on_x(1, 2, 3, 6 - e)).is == LinkageClass::triple_rocker);
    CHECK_THROWS_AS(grashof(on_x(1, 2, 3, 6 + e)), Impossible);
  }
  // The frame √2: 1 + 2 against √2 + 8/5, 3.0142..., and against √2 + 31/20, 2.9642...
  CHECK(grashof({1, 2, Rational(8, 5), 1, 1}).is == LinkageClass::crank_rocker);
  CHECK(grashof({1, 2, Rational(31, 20), 1, 1}).is == LinkageClass::triple_rocker);
}

// Crank and rocker turn fully exactly in the classes that are named so: the rule is Grashof's theorem, the two
// questions are asked of the triangles.
TEST_CASE("grashof: the theorem holds for all linkages with sides up to 9", "[grashof]") {
  int counted = 0;
  std::set<LinkageClass> seen;
  for (int a = 1; a <= 9; ++a)
    for (int b = 1; b <= 9; ++b)
      for (int c = 1; c <= 9; ++c)
        for (int d = 1; d <= 9; ++d) {
          if (2 * std::max({a, b, c, d}) > a + b + c + d) continue;
          const FourBarLengths of = on_x(a, b, c, d);
          const LinkageClass is = grashof(of).is;
          if (is == LinkageClass::change_point) continue;
          CAPTURE(a, b, c, d);
          CHECK(crank_turns_fully(of) == (is == LinkageClass::crank_rocker || is == LinkageClass::double_crank));
          CHECK(rocker_turns_fully(of) == (is == LinkageClass::rocker_crank || is == LinkageClass::double_crank));
          seen.insert(is);
          ++counted;
        }
  std::printf("grashof: %d linkages\n", counted);
  CHECK(counted > 3000);
  CHECK(seen.size() == 6);
}

// The class by turning the crank through all positions: tests/corpus/make_four_bar.py.
TEST_CASE("grashof: the corpus of special positions", "[grashof]") {
  const std::map<std::string, LinkageClass> names{
      {"crank_rocker", LinkageClass::crank_rocker},   {"rocker_crank", LinkageClass::rocker_crank},
      {"double_crank", LinkageClass::double_crank},   {"double_rocker", LinkageClass::double_rocker},
      {"triple_rocker", LinkageClass::triple_rocker}, {"change_point", LinkageClass::change_point}};
  int held = 0;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/four_bar_special.txt")) {
    CAPTURE(c.name);
    CHECK(grashof(four_bar_lengths_of(c)).is == names.at(c.choices.at("mobility")));
    ++held;
  }
  CHECK(held >= 18);
}

}  // namespace epure::tests
