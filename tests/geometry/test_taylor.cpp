// Series: the rules against known series exactly, and enclosures over an interval against many points of it.
#include "geometry/curves/polodes.h"
#include "geometry/curves/taylor.h"
#include "geometry/curves/turn_arcs.h"
#include "geometry/numbers/enclosure.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

using ExactSeries = Taylor<Exact, 4>;

Exact exact(int numerator, int denominator = 1) { return from_rational<Exact>(Rational(numerator, denominator)); }

bool is_equal(const Exact& a, const Exact& b) { return sign(a - b) == Sign::zero; }

void check_coefficients(const ExactSeries& series, std::array<Exact, 5> expected) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    INFO("coefficient " << k);
    CHECK(is_equal(series.c[k], expected[k]));
  }
}

}  // namespace

TEST_CASE("series: quotient, root, square and product have the coefficients of the textbook", "[taylor]") {
  const Arithmetic<Exact> scope;
  const ExactSeries t = ExactSeries::parameter(exact(0)), one(1);
  check_coefficients(quotient(one, one - t), {exact(1), exact(1), exact(1), exact(1), exact(1)});
  check_coefficients(one / (one + t * t), {exact(1), exact(0), exact(-1), exact(0), exact(1)});
  check_coefficients(root(one + t), {exact(1), exact(1, 2), exact(-1, 8), exact(1, 16), exact(-5, 128)});
  check_coefficients(square(square(one + t)), {exact(1), exact(4), exact(6), exact(4), exact(1)});
  check_coefficients(-(t - one) * (t + one), {exact(1), exact(0), exact(-1), exact(0), exact(0)});
  // Away from zero: 1/t at 2 is Σ (-1)^k (t-2)^k / 2^(k+1), and the square of a root is what it was taken of.
  const ExactSeries at_two = ExactSeries::parameter(exact(2));
  check_coefficients(quotient(one, at_two), {exact(1, 2), exact(-1, 4), exact(1, 8), exact(-1, 16), exact(1, 32)});
  check_coefficients(square(root(at_two)), {exact(2), exact(1), exact(0), exact(0), exact(0)});
}

TEST_CASE("series: the sign is that of the value, and what has no derivative is undecided", "[taylor]") {
  const Arithmetic<Bounded> scope;
  const BoundedSeries across = BoundedSeries::parameter(Bounded(-1, 2)),
                      right = BoundedSeries::parameter(Bounded(1, 2));
  CHECK(sign(across) == Sign::undecided);
  CHECK(sign(right) == Sign::positive);
  CHECK(sign(-right) == Sign::negative);
  CHECK(sign(BoundedSeries(0)) == Sign::zero);
  CHECK_THROWS_AS(root(across), Undecided);
  CHECK_THROWS_AS(root(BoundedSeries(0)), Undecided);
  CHECK_THROWS_AS(quotient(right, across), Undecided);
  CHECK_THROWS_AS(right / across, Undecided);
}

TEST_CASE("series: a construction over an interval encloses its derivatives at every parameter", "[taylor]") {
  const Arithmetic<Bounded> bounded;
  const Arithmetic<Deep> deep(128);
  const auto moving_polode = []<class T>(const Vector<T>& reference) {
    const SliderCrankLoop<T> loop{from_rational<T>(Rational(1, 5)), from_rational<T>(Rational(1, 2))};
    return MovingPolode<T>{loop, coupler_position(loop, reference)};
  };
  const auto narrow = moving_polode(Vector<Deep>{Deep(3) / Deep(5), Deep(4) / Deep(5)});
  const auto wide = moving_polode(Vector<Bounded>{Bounded(3) / Bounded(5), Bounded(4) / Bounded(5)});
  const int arc = GENERATE(0, 1, 2, 3);
  const double from = GENERATE(-1.0, -0.5, 0.25, 0.875);
  const double to = from + 0.125;
  const auto over = wide(direction_on_turn(arc, BoundedSeries::parameter(Bounded(from, to))));
  for (int i = 0; i <= 8; ++i) {
    const Deep t = Deep::from_double(from + i * 0.015625);
    const auto at = narrow(direction_on_turn(arc, Taylor<Deep, 5>::parameter(t)));
    for (std::size_t k = 0; k <= 5; ++k) {
      CHECK(to_bounded(at.x.c[k]).do_overlap(over.x.c[k]));
      CHECK(to_bounded(at.y.c[k]).do_overlap(over.y.c[k]));
      CHECK(to_bounded(at.w.c[k]).do_overlap(over.w.c[k]));
    }
  }
}

TEST_CASE("turn: four arcs of exact unit vectors that meet exactly", "[turn]") {
  const Arithmetic<Exact> scope;
  const auto is_same_direction = [](const Vector<Exact>& u, const Vector<Exact>& v) {
    return is_equal(u.x, v.x) && is_equal(u.y, v.y);
  };
  for (int arc = 0; arc < turn_arcs; ++arc) {
    for (int i = -4; i <= 4; ++i) CHECK(is_equal(length_squared(direction_on_turn(arc, exact(i, 4))), exact(1)));
    CHECK(is_same_direction(direction_on_turn(arc, exact(1)), direction_on_turn((arc + 1) % turn_arcs, exact(-1))));
    CHECK(turned_between({arc, -1}, {arc, 1}) == Approx(arc % 2 == 0 ? 1.8545904360032244 : 1.2870022175865687));
  }
  CHECK(is_same_direction(direction_on_turn(0, exact(1)), {exact(3, 5), exact(4, 5)}));
  CHECK(is_same_direction(direction_on_turn(1, exact(0)), {exact(0), exact(1)}));
}
