// Sections: put together of rectangles and cut out of one, with every number.
#include "geometry/analytic/section_formulas.h"
#include "geometry/statics/section.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

using namespace epure::tests;

namespace {

struct Shape {
  Rational H, b, s;
};
// The crane's beam and column (mm), a square pipe's worth of wall, a web as wide as its flanges: a rectangle.
const std::vector<Shape> shapes{
    {300, 200, 5}, {180, 100, 2}, {7, 3, 1}, {10, 4, 4}, {Rational(1, 3), 2, Rational(1, 7)}};

}  // namespace

TEMPLATE_TEST_CASE("a double T put together is the one cut out", "[section]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  constexpr double size = 1e9;
  const auto equal = [&](const T& x, const Rational& expected) { return is(x, from_rational<T>(expected), size); };
  for (const auto& [H, b, s] : shapes) {
    const DoubleT<T> section{from_rational<T>(H), from_rational<T>(b), from_rational<T>(s)};
    const analytic::DoubleT cut{H, b, s};
    const SectionProperties<T> all = properties(section.strips());
    CHECK(equal(all.area, cut.area()));
    CHECK(equal(all.J_x, cut.J_x()));
    CHECK(equal(all.J_y, cut.J_y()));
    CHECK(equal(static_moment(section.upper_half()), cut.S_half()));
    CHECK(equal(static_moment<T>({section.flange()}), cut.S_flange()));
    CHECK(equal(static_moment(section.strips()), 0));
    CHECK(is(rectangle(section.b, section.H).J_x, from_rational<T>(analytic::rectangle_J(b, H)), size));
  }
}

// What the source of the crane prints of its sections, and counted by hand: 2·200·5 + 5·290 mm².
TEST_CASE("sections of the crane, as printed", "[section]") {
  const analytic::DoubleT beam{300, 200, 5}, column{180, 100, 2};
  CHECK(beam.area() == 3450);
  CHECK(column.area() == 752);
  CHECK(CGAL::to_double(beam.J_x()) == Approx(5.368e7).epsilon(1e-4));
  CHECK(CGAL::to_double(beam.J_y()) == Approx(6.67e6).epsilon(1e-3));
  CHECK(CGAL::to_double(column.J_x()) == Approx(4.077e6).epsilon(2e-4));
  CHECK(CGAL::to_double(column.J_y()) == Approx(3.335e5).epsilon(2e-4));
  CHECK(beam.S_flange() == 147500);
}

TEMPLATE_TEST_CASE("a circle's moments of inertia", "[section]", Fast, Bounded, Deep, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const SectionProperties<T> round = circle(number<T>(50));
  CHECK(is(round.J_x, analytic::circle_J<T>(50), 1e6));
  CHECK(is(round.J_p(), T(2) * round.J_x, 1e6));
}

TEST_CASE("a circle's moment of inertia as printed", "[section]") {
  CHECK(circle(50.0).J_x == Approx(3.068e5).epsilon(1e-3));
}
