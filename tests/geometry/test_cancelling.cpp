// Functions whose terms cancel keep their relative accuracy. (Their values: the hard corpus, tests/bench.)
#include "geometry/analytic/cancelling_functions.h"
#include "geometry/numbers/enclosure.h"
#include "tests/support/catch.h"

namespace epure::tests {

using namespace geometry;

namespace {

// 2^-k, a double and a ball without any width.
Rational halved(int k) {
  Rational power(1);
  for (int i = 0; i < k; ++i) power *= Rational(1, 2);
  return power;
}

bool has_bits(const Deep& x, long bits) { return arb_rel_accuracy_bits(x.ball()) >= bits; }

bool is_within_ulps(const Bounded& x) { return x.inf() > 0 && x.sup() - x.inf() <= 4e-16 * x.inf(); }

}  // namespace

TEST_CASE("what is left after cancelling has all the bits that were asked for") {
  for (const int k : {1, 5, 20, 50, 100, 300}) {
    CAPTURE(k);
    const Arithmetic<Deep> scope(128);
    const Deep x = from_rational<Deep>(halved(k)),
               beyond_one = Deep(1) + (k < 128 ? x : from_rational<Deep>(halved(100)));
    CHECK(has_bits(analytic::tangent_less_angle(x), 124));
    CHECK(has_bits(analytic::logarithms_near_one(beyond_one), 124));
    CHECK(has_bits(analytic::exponentials_over_twice(x, Deep(3)), 124));
  }
  for (const int k : {1, 5, 20, 50}) {
    CAPTURE(k);
    const Arithmetic<Bounded> scope;
    const Bounded x = from_rational<Bounded>(halved(k));
    CHECK(is_within_ulps(analytic::tangent_less_angle(x)));
    CHECK(is_within_ulps(analytic::logarithms_near_one(Bounded(1) + x)));
    CHECK(is_within_ulps(analytic::exponentials_over_twice(x, Bounded(3))));
  }
}

TEST_CASE("where nothing cancels, doubles tell what enclosures do") {
  const Arithmetic<Bounded> scope;
  for (const double x : {0.3, 0.9, 1.4}) {
    CAPTURE(x);
    CHECK(analytic::tangent_less_angle(x) == Approx(analytic::tangent_less_angle(Bounded(x)).inf()).epsilon(1e-12));
    CHECK(analytic::logarithms_near_one(4 * x) ==
          Approx(analytic::logarithms_near_one(Bounded(4) * Bounded(x)).inf()).epsilon(1e-12));
    CHECK(analytic::exponentials_over_twice(x, 3.0) ==
          Approx(analytic::exponentials_over_twice(Bounded(x), Bounded(3)).inf()).epsilon(1e-12));
  }
}

TEST_CASE("an enclosure of the argument gives one of every value in it") {
  const Arithmetic<Bounded> scope;
  const Bounded across_zero(-0.25, 0.5), across_one(0.5, 2);
  CHECK(CGAL::subset(Bounded(0), analytic::tangent_less_angle(across_zero)));
  CHECK(CGAL::subset(analytic::tangent_less_angle(Bounded(0.5)), analytic::tangent_less_angle(across_zero)));
  CHECK(CGAL::subset(analytic::tangent_less_angle(Bounded(-0.25)), analytic::tangent_less_angle(across_zero)));
  CHECK(CGAL::subset(analytic::logarithms_near_one(Bounded(2)), analytic::logarithms_near_one(across_one)));
  CHECK(CGAL::subset(analytic::logarithms_near_one(Bounded(0.5)), analytic::logarithms_near_one(across_one)));
  // Least where β is zero, though neither end of the enclosure is.
  const Bounded at_three = analytic::exponentials_over_twice(across_zero, Bounded(3));
  CHECK(CGAL::subset(Bounded(3), at_three));
  CHECK(CGAL::subset(analytic::exponentials_over_twice(Bounded(0.5), Bounded(3)), at_three));
  CHECK_THROWS_AS(analytic::tangent_less_angle(Bounded(0, 2)), Undecided);
  CHECK_THROWS_AS(analytic::logarithms_near_one(Bounded(0, 2)), Undecided);
  CHECK_THROWS_AS(analytic::exponentials_over_twice(0.0, 3.0), Undecided);
}

}  // namespace epure::tests
