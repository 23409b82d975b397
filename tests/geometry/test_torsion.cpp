// De Saint-Venant's torsion constant: two series along different sides, as accurate as asked, against an integral of
// heat (tests/corpus/make_frame.py) and known coefficients.
#include "geometry/analytic/torsion_series.h"
#include "geometry/statics/rectangle_torsion.h"
#include "tests/support/catch.h"

namespace epure::tests {

using namespace geometry;

namespace {

bool holds(const Deep& ball, const char* digits) {
  arb_t expected;
  arb_init(expected);
  arb_set_str(expected, digits, 400);
  const bool overlaps = arb_overlaps(ball.ball(), expected) != 0;
  arb_clear(expected);
  return overlaps;
}

}  // namespace

TEST_CASE("the two series of a rectangle's torsion enclose one number, however slender it is") {
  for (const auto& [a, b] : {std::pair{Rational(1), Rational(1)},
                             {Rational(5), Rational(1)},
                             {Rational(1), Rational(5)},
                             {Rational(7, 3), Rational(9, 4)},
                             {Rational(1000), Rational(1)},
                             {Rational(1), Rational(1000)}})
    for (const long bits : {64L, 256L}) {
      CAPTURE(CGAL::to_double(a), CGAL::to_double(b), bits);
      const Arithmetic<Deep> scope(bits);
      const Deep one = rectangle_torsion<Deep>(a, b), other = analytic::torsion_series<Deep>(a, b);
      CHECK(arb_overlaps(one.ball(), other.ball()) != 0);
      CHECK(arb_rel_accuracy_bits(one.ball()) >= bits);
      CHECK(arb_rel_accuracy_bits(other.ball()) >= bits);
      // A rectangle has no first side.
      CHECK(arb_overlaps(one.ball(), rectangle_torsion<Deep>(b, a).ball()) != 0);
      CHECK(arb_overlaps(other.ball(), analytic::torsion_series<Deep>(b, a).ball()) != 0);
    }
}

TEST_CASE("the torsion constant is that of a cooling plate") {
  const Arithmetic<Deep> scope(128);
  const char* stated = "1.456583770939944343187894134629047660175e-8 +/- 1e-47";
  CHECK(holds(rectangle_torsion<Deep>(Rational(1, 20), Rational(1, 100)), stated));
  CHECK(holds(analytic::torsion_series<Deep>(Rational(1, 20), Rational(1, 100)), stated));
  const Arithmetic<Bounded> doubles;
  const Bounded J = rectangle_torsion<Bounded>(Rational(1, 20), Rational(1, 100));
  CHECK(J.sup() - J.inf() <= 1e-23);
  CHECK(holds(rectangle_torsion<Deep>(Rational(1), Rational(1)),
              "0.1405770149551537155884687307377311152676 +/- 1e-39"));
  CHECK(rectangle_torsion<Fast>(Rational(1), Rational(1)) == Approx(0.1405770149551537).epsilon(1e-15));
}

}  // namespace epure::tests
