// The involute function and its inverse, by both routes, held against 40 digits from outside.
#include "geometry/analytic/involute_formulas.h"
#include "geometry/gears/involute.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

using namespace epure::geometry;
using namespace epure::tests;

namespace {

const std::vector<CorpusCase>& involutes() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/involutes.txt");
  return cases;
}

// Relative width, in units of 2^-53.
double width(const Bounded& x) { return (x.sup() - x.inf()) / x.sup() / 0x1p-53; }

}  // namespace

TEST_CASE("involute function: encloses it at a given tangent", "[gears]") {
  CHECK(involutes().size() == 9);
  for (const CorpusCase& c : involutes()) {
    CAPTURE(c.name, c.why);
    const Rational tangent = c.givens.at("involute"), expected = exact_decimal(c.reference("involute_of_it"));
    {
      const Arithmetic<Fast> scope;
      const double y = involute(from_rational<Fast>(tangent)), near = CGAL::to_double(expected);
      CHECK(std::abs(y - near) <= 64 * 0x1p-53 * near);  // t - arctan t loses 6 bits at the end of the series
    }
    {
      const Arithmetic<Bounded> scope;
      const Bounded y = involute(from_rational<Bounded>(tangent));
      CHECK(overlaps(enclosure(y), expected));
      CHECK(width(y) <= 80);
    }
    for (const long bits : {160L, 2048L}) {
      const Arithmetic<Deep> scope(bits);
      const Deep y = involute(from_rational<Deep>(tangent));
      CHECK(overlaps(y, expected));
      CHECK(narrow(y));
    }
  }
}

TEST_CASE("involute function inverted: tangent and angle, certified", "[gears]") {
  for (const CorpusCase& c : involutes()) {
    CAPTURE(c.name, c.why);
    const Rational y = c.givens.at("involute");
    const Rational tangent = exact_decimal(c.reference("tangent")), angle = exact_decimal(c.reference("angle"));
    {
      const Arithmetic<Fast> scope;
      const double near = CGAL::to_double(tangent);
      CHECK(std::abs(tangent_of_involute(from_rational<Fast>(y)) - near) <= 64 * 0x1p-53 * near);
      CHECK(std::abs(analytic::angle_of_involute(from_rational<Fast>(y)) - CGAL::to_double(angle)) <= 1e-15);
    }
    {
      const Arithmetic<Bounded> scope;
      const Bounded given = from_rational<Bounded>(y);
      CHECK(overlaps(enclosure(tangent_of_involute(given)), tangent));
      CHECK(width(tangent_of_involute(given)) <= 80);
      CHECK(overlaps(enclosure(analytic::angle_of_involute(given)), angle));
    }
    for (const long bits : {160L, 2048L}) {
      const Arithmetic<Deep> scope(bits);
      const Deep given = from_rational<Deep>(y);
      CHECK(overlaps(tangent_of_involute(given), tangent));
      CHECK(narrow(tangent_of_involute(given)));
      CHECK(overlaps(analytic::angle_of_involute(given), angle));
      CHECK(narrow(analytic::angle_of_involute(given)));
    }
  }
}

TEST_CASE("involute function: every number of a wide enclosure is inside the answer", "[gears]") {
  const Arithmetic<Bounded> scope;
  for (const double low : {1e-20, 1e-3, 0.2, 3.0})
    for (const double factor : {1.0, 1 + 1e-9, 1.01, 1.5}) {
      CAPTURE(low, factor);
      const Bounded y(low, low * factor);
      const Bounded t = involute(y);  // taken as a tangent
      CHECK(t.inf() <= involute(Bounded(y.inf())).sup());
      CHECK(t.sup() >= involute(Bounded(y.sup())).inf());
      try {
        const Bounded back = tangent_of_involute(y);
        CHECK(involute(Bounded(back.inf())).inf() <= y.inf());
        CHECK(involute(Bounded(back.sup())).sup() >= y.sup());
      } catch (const Undecided&) {
        CHECK(factor == 1.5);  // too wide to be proved by one step, and said so
      }
    }
}

TEST_CASE("involute function: zero is exactly zero, and what may be zero or is transcendental is not answered",
          "[gears]") {
  {
    const Arithmetic<Exact> scope;
    CHECK(involute(Exact(0)).is_zero());
    CHECK(tangent_of_involute(Exact(0)).is_zero());
    CHECK_THROWS_AS(involute(Exact(1)), LeavesTheTower);
  }
  {
    const Arithmetic<Calcium> scope;
    CHECK(sign(involute(Calcium(0))) == Sign::zero);
    CHECK_THROWS_AS(tangent_of_involute(Calcium(1)), Undecided);
  }
  const Arithmetic<Bounded> scope;
  CHECK(tangent_of_involute(Bounded(0)).sup() == 0);
  CHECK_THROWS_AS(tangent_of_involute(Bounded(0, 1e-9)), Undecided);
  CHECK_THROWS_AS(analytic::angle_of_involute(Bounded(0, 1e-9)), Undecided);
}
