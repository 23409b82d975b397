// Closed formulas for lines and circles: by hand-made figures with rational answers, exactly.
#include "geometry/analytic/circles.h"
#include "geometry/analytic/plane_motion_formulas.h"
#include "tests/support/catch.h"

namespace epure::geometry::analytic {
namespace {

using Point = Complex<Exact>;

Exact ratio(int p, int q) { return from_rational<Exact>(Rational(p, q)); }
bool equal(const Exact& a, const Exact& b) { return sign(a - b) == Sign::zero; }
bool equal(const Point& a, const Point& b) { return equal(a.re, b.re) && equal(a.im, b.im); }

}  // namespace

TEST_CASE("analytic circles: foot of a perpendicular", "[analytic]") {
  const Arithmetic<Exact> tower;
  CHECK(equal(foot<Exact>({3, 1}, {0, 0}, {1, 1}), {2, 2}));
  CHECK(equal(foot<Exact>({3, 1}, {0, 0}, {-5, -5}), {2, 2}));
  CHECK_THROWS_AS(foot<Exact>({3, 1}, {0, 0}, {0, 0}), Undecided);
}

TEST_CASE("analytic circles: lines meet, or are parallel", "[analytic]") {
  const Arithmetic<Exact> tower;
  const auto meet = meet_of_lines<Exact>({0, 1}, {1, 2}, {4, 0}, {-1, 3});
  REQUIRE(meet);
  CHECK(equal(*meet, {ratio(11, 5), ratio(27, 5)}));
  CHECK_FALSE(meet_of_lines<Exact>({0, 1}, {1, 2}, {4, 0}, {-2, -4}));
}

TEST_CASE("analytic circles: a polygon with two unknown magnitudes closes", "[analytic]") {
  const Arithmetic<Exact> tower;
  const Point known{3, -2}, u{1, 4}, v{2, 1};
  const auto found = close_polygon(known, u, v);
  REQUIRE(found);
  CHECK(equal(known + found->first * u + found->second * v, {0, 0}));
  CHECK(equal(found->first, Exact(1)));
  CHECK(equal(found->second, Exact(-2)));
  CHECK_FALSE(close_polygon<Exact>(known, u, {-2, -8}));
  CHECK_FALSE(close_polygon<Exact>(known, {0, 0}, v));
}

TEST_CASE("analytic circles: a line crosses, touches or misses a circle", "[analytic]") {
  const Arithmetic<Exact> tower;
  const auto crossing = meet_of_line_and_circle<Exact>({10, 3}, {-2, 0}, {0, 0}, Exact(5));
  REQUIRE(crossing);
  CHECK(equal(crossing->entering, {4, 3}));
  CHECK(equal(crossing->leaving, {-4, 3}));
  const auto touching = meet_of_line_and_circle<Exact>({10, 5}, {-2, 0}, {0, 0}, Exact(5));
  REQUIRE(touching);
  CHECK(equal(touching->entering, {0, 5}));
  CHECK(equal(touching->leaving, {0, 5}));
  CHECK_FALSE(meet_of_line_and_circle<Exact>({10, 6}, {-2, 0}, {0, 0}, Exact(5)));
}

TEST_CASE("analytic circles: two circles meet left and right, touch, miss", "[analytic]") {
  const Arithmetic<Exact> tower;
  // 3-4-5 triangle on the imaginary axis: left of the way up is the negative real side.
  const auto meet = meet_of_circles<Exact>({0, 0}, Exact(4), {0, 5}, Exact(3));
  REQUIRE(meet);
  CHECK(equal(meet->left, {ratio(-12, 5), ratio(16, 5)}));
  CHECK(equal(meet->right, {ratio(12, 5), ratio(16, 5)}));
  const auto outside = meet_of_circles<Exact>({0, 0}, Exact(4), {0, 5}, Exact(1));
  REQUIRE(outside);
  CHECK(equal(outside->left, {0, 4}));
  CHECK(equal(outside->right, {0, 4}));
  const auto inside = meet_of_circles<Exact>({0, 0}, Exact(4), {0, 1}, Exact(3));
  REQUIRE(inside);
  CHECK(equal(inside->left, {0, 4}));
  CHECK_FALSE(meet_of_circles<Exact>({0, 0}, Exact(4), {0, 8}, Exact(3)));
  CHECK_FALSE(meet_of_circles<Exact>({0, 0}, Exact(4), {0, 1}, Exact(2)));
  CHECK_THROWS_AS(meet_of_circles<Exact>({1, 1}, Exact(4), {1, 1}, Exact(4)), Impossible);
  // Radii 0.1 and 0.2 at distance 0.3 touch; in binary they overlap. Intervals must not decide.
  const auto tangent = meet_of_circles<Exact>({0, 0}, ratio(1, 10), {ratio(3, 10), 0}, ratio(1, 5));
  REQUIRE(tangent);
  CHECK(equal(tangent->left, {ratio(1, 10), 0}));
  const Arithmetic<Bounded> rounding;
  const auto tenth = [](int n) { return from_rational<Bounded>(Rational(n, 10)); };
  CHECK_THROWS_AS(meet_of_circles<Bounded>({0, 0}, tenth(1), {tenth(3), 0}, tenth(2)), Undecided);
}

TEST_CASE("plane motion: a wheel rolling on the real axis", "[analytic]") {
  const Arithmetic<Exact> tower;
  // Radius 1 about i, rolling to the right with unit speed: a cycloid's top has curvature radius 4, the inflection
  // circle is the upper half's circle of diameter 1.
  const PlaneMotion<Exact> wheel{{0, 1}, {1, 0}, {0, 0}, Exact(-1), Exact(0)};
  CHECK(equal(*wheel.pole(), {0, 0}));
  CHECK(equal(*wheel.acceleration_pole(), {0, 1}));
  CHECK(equal(*wheel.inflection_pole(), {0, 1}));
  CHECK(equal(wheel.inflection_circle()->diameter, Exact(1)));
  CHECK(equal(wheel.inflection_circle()->centre, {0, ratio(1, 2)}));
  CHECK(equal(*wheel.radius_of_curvature({0, 2}), Exact(4)));
  CHECK(equal(*wheel.centre_of_curvature({0, 2}), {0, -2}));
  CHECK(equal(wheel.curvature({0, 2}), ratio(-1, 4)));
  CHECK(equal(*wheel.on_inflection_circle({0, 2}), {0, 1}));
  CHECK_FALSE(wheel.radius_of_curvature({0, 1}));  // the hub runs straight
  CHECK_FALSE(wheel.centre_of_curvature({0, 1}));
  CHECK(equal(wheel.curvature({0, 1}), Exact(0)));
  CHECK_THROWS_AS(wheel.curvature({0, 0}), Impossible);  // the contact point is at rest
  CHECK_THROWS_AS(wheel.on_inflection_circle({0, 0}), Impossible);
  CHECK_FALSE(wheel.stationarity_circle());
  CHECK(wheel.stationarity_line());  // the vertical through the contact
  CHECK_FALSE(wheel.inflection_line());
}

TEST_CASE("plane motion: translations have no pole", "[analytic]") {
  const Arithmetic<Exact> tower;
  const PlaneMotion<Exact> slide{{2, 3}, {1, 2}, {0, -1}, Exact(0), Exact(0)};
  CHECK_FALSE(slide.pole());
  CHECK_FALSE(slide.acceleration_pole());
  CHECK_FALSE(slide.acceleration_at_pole());
  CHECK_FALSE(slide.inflection_pole());
  CHECK_FALSE(slide.inflection_circle());
  CHECK_FALSE(slide.inflection_line());
  CHECK_FALSE(slide.stationarity_circle());
  CHECK_FALSE(slide.stationarity_line());
  CHECK_FALSE(slide.on_inflection_circle({0, 0}));
}

}  // namespace epure::geometry::analytic
