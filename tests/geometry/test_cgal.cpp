// Points of CGAL's kernels come in exactly, and ours go out.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "geometry/constructions/cgal.h"
#include "geometry/numbers/climb.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

using Doubles = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exactly = CGAL::Exact_predicates_exact_constructions_kernel;

TEST_CASE("a point of doubles comes in as the rational it is", "[cgal]") {
  const Doubles::Point_2 P(0.1, -3);
  CHECK(rational_of(P.x()) == Rational("3602879701896397/36028797018963968"));  // the double nearest to 0.1
  CHECK(from_cgal<Fast>(P).x == 0.1);
  CHECK(from_cgal<Fast>(P).y == -3);
}

TEST_CASE("what CGAL constructs lazily comes in exactly", "[cgal]") {
  const Exactly::Point_2 A(0, 0), B(3, 1), C(1, 0), D(1, 5);
  // An optional variant, of Boost's up to CGAL 5 and of the standard library's from CGAL 6 on: an Object takes
  // either.
  const CGAL::Object meeting = CGAL::intersection(Exactly::Line_2(A, B), Exactly::Line_2(C, D));
  const auto* met = CGAL::object_cast<Exactly::Point_2>(&meeting);
  REQUIRE(met);
  CHECK(rational_of(met->x()) == 1);
  CHECK(rational_of(met->y()) == Rational(1, 3));
  const Arithmetic<Exact> scope;
  CHECK(sign(from_cgal<Exact>(*met).y * Exact(3) - Exact(1)) == Sign::zero);
}

TEST_CASE("a line keeps its left side", "[cgal]") {
  const Doubles::Line_2 l(Doubles::Point_2(0, 1), Doubles::Point_2(2, 1));
  const Line<Fast> ours = from_cgal<Fast>(l);
  CHECK(side(Point<Fast>{0, 2}, ours) == Sign::positive);
  CHECK(l.has_on_positive_side(Doubles::Point_2(0, 2)));
  CHECK(side(Point<Fast>{0, 0}, ours) == Sign::negative);
}

TEST_CASE("ours go out over the same number", "[cgal]") {
  const Arithmetic<Bounded> scope;
  const Line<Bounded> l = line(Point<Bounded>{Bounded(0), Bounded(0)}, Point<Bounded>{Bounded(3), Bounded(1)});
  const auto P = to_cgal(foot(Point<Bounded>{Bounded(1), Bounded(2)}, l));
  CHECK((P.x().inf() <= 1.5 && 1.5 <= P.x().sup()));
  CHECK((P.y().inf() <= 0.5 && 0.5 <= P.y().sup()));
  const auto v = to_cgal(Vector<Fast>{3, 4});
  CHECK(v.squared_length() == 25);
  const auto there_and_back = from_cgal<Fast>(to_cgal(Line<Fast>{1, 2, 3}));
  CHECK(there_and_back.c == 3);
}
