// Funicular polygons, Mohr's circle and Thales' rays with every number, against equilibrium solved and closed forms.
#include "geometry/analytic/beam_formulas.h"
#include "geometry/analytic/stress_formulas.h"
#include "geometry/constructions/proportion.h"
#include "geometry/statics/funicular.h"
#include "geometry/statics/mohr_circle.h"
#include "geometry/statics/soderberg.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

using namespace epure::tests;

TEMPLATE_TEST_CASE("Thales' fourth and the semicircle's mean proportional", "[funicular]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  CHECK(is(fourth_proportional<T>(number<T>(3), number<T>(7, 2), number<T>(-5)), number<T>(-35, 6)));
  CHECK(is(mean_proportional<T>(number<T>(9, 4), number<T>(4)), number<T>(3)));
  CHECK(is(square(mean_proportional<T>(number<T>(2), number<T>(3))), number<T>(6)));
}

// Two loads between the supports and one beyond; the reactions by moments about the supports:
// 4·x_B = 8·1 + 3·2 + 2·6 over a span of 4 gives 26/4; the rest is 13 − 26/4.
TEMPLATE_TEST_CASE("reactions are those of moments, whatever the pole", "[funicular]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const std::vector<VerticalForce<T>> loads{
      {number<T>(1), number<T>(-8)}, {number<T>(2), number<T>(-3)}, {number<T>(6), number<T>(-2)}};
  for (const auto& [distance, height] : {std::pair{1, 0}, {7, -20}, {100, 13}}) {
    const auto polygon =
        funicular<T>(loads, {number<T>(distance), number<T>(height)}, Point<T>{number<T>(-1), number<T>(3)});
    const TwoSupports<T> found = on_two_supports(polygon, number<T>(0), number<T>(4));
    CHECK(is(found.last, number<T>(26, 4), 1e3));
    CHECK(is(found.first, number<T>(26, 4), 1e3));
    // The moment under the first load: pole distance times the ordinate between string and closing line.
    const T ordinate_there = ordinate(polygon.strings[0], number<T>(1)) - ordinate(found.closing, number<T>(1));
    CHECK(is(polygon.pole.distance * ordinate_there, number<T>(26, 4), 1e3));
  }
}

TEMPLATE_TEST_CASE("the overhanging beam by its closing line and by its equations", "[funicular]", Fast, Bounded,
                   Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const analytic::OverhangingBeam<T> beam{number<T>(3), number<T>(7, 2), number<T>(11), number<T>(13)};
  const T D = beam.L + beam.a;
  const auto polygon = funicular<T>({{D, -beam.P}}, {number<T>(5), T(0)}, Point<T>{D, T(0)});
  const TwoSupports<T> found = on_two_supports(polygon, T(0), beam.L);
  CHECK(is(found.first, beam.Y_B(), 1e3));
  CHECK(is(found.last, beam.Y_C(), 1e3));
  CHECK(is(-(polygon.pole.distance * ordinate(found.closing, beam.L)), beam.moment_between(beam.L), 1e3));
  CHECK(is(beam.moment_between(beam.L), beam.moment_beyond(beam.L), 1e3));
  CHECK(is(beam.v_between(beam.L), T(0), 1e3));
  // Betti and Clapeyron: the work of P is twice the energy.
  CHECK(is(-(beam.P * beam.v_D()), T(2) * beam.energy(), 1e5));
  CHECK(is(beam.theta_between(beam.xi_of_greatest_v()), T(0), 1e3));
}

// σ = 6, τ = −4: centre 3, radius 5; σ_eq² = 36 + 3·16.
TEMPLATE_TEST_CASE("Mohr's circle has the eigenvalues", "[funicular]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const MohrCircle<T> circle = mohr_circle(number<T>(6), number<T>(-4));
  CHECK(is(circle.sigma_I(), number<T>(8)));
  CHECK(is(circle.sigma_II(), number<T>(-2)));
  CHECK(is(square(circle.equivalent()), number<T>(84), 100));
  const auto by_values = analytic::principal_stresses(number<T>(6), number<T>(-4));
  CHECK(is(by_values.greater, circle.sigma_I()));
  CHECK(is(by_values.lesser, circle.sigma_II()));
  CHECK(is(analytic::equivalent_stress(number<T>(6), number<T>(-4)), circle.equivalent()));
  // The pole lies on the circle, and from it the face across is upright.
  CHECK(is(distance(circle.pole(), circle.centre()), circle.radius()));
  CHECK(is(circle.pole().x, circle.across.x));
}

TEMPLATE_TEST_CASE("Soderberg's line ends at the yield stress", "[funicular]", Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  CHECK(is(range_without_mean<T>(number<T>(50), number<T>(100), number<T>(300)), number<T>(120), 1e3));
  CHECK(is(range_without_mean<T>(number<T>(-50), number<T>(-100), number<T>(300)), number<T>(-600, 7), 1e3));
  CHECK_THROWS_AS(range_without_mean<T>(number<T>(300), number<T>(1), number<T>(300)), Impossible);
  CHECK_THROWS_AS(range_without_mean<T>(number<T>(301), number<T>(1), number<T>(300)), Impossible);
}
