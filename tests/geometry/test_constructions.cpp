// Ruler, set square and compasses: one body for every number. Expected values are those of 3-4-5 triangles, or worked
// out by hand beside the test.
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

#include <array>

namespace epure::tests {

TEMPLATE_TEST_CASE("lines meet in a point, in their direction, or everywhere", "[constructions]", Fast, Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Line<T> l = line(Point<T>{0, 1}, Vector<T>{1, 2});
  // y = 1 + 2x and y = 12 - 3x: 5x = 11.
  CHECK(is(finite(meet(l, line(Point<T>{4, 0}, Vector<T>{-1, 3}))), {number<T>(11, 5), number<T>(27, 5)}));

  const ProjectivePoint<T> away = meet(l, line(Point<T>{4, 0}, Vector<T>{-2, -4}));
  CHECK(sign(away.w) == Sign::zero);
  CHECK(sign(away.x) != Sign::zero);
  CHECK(is(cross(Vector<T>{away.x, away.y}, l.direction()), T(0), 100));
  CHECK_THROWS_AS(finite(away), Undecided);

  // (0, 1) and (2, 5) lie on l.
  const ProjectivePoint<T> everywhere = meet(l, line(Point<T>{2, 5}, Point<T>{0, 1}));
  CHECK(sign(everywhere.x) == Sign::zero);
  CHECK(sign(everywhere.y) == Sign::zero);
  CHECK(sign(everywhere.w) == Sign::zero);
}

TEMPLATE_TEST_CASE("a line passes its points in the order in which they are named", "[constructions]", Fast, Bounded,
                   Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Point<T> P{1, 2}, Q{4, 6}, above{0, 5}, below{5, 0};
  const Line<T> l = line(P, Q);
  CHECK(is_on(P, l));
  CHECK(is_on(Q, l));
  CHECK(side(P, l) == Sign::zero);
  CHECK(runs_along(l.direction(), {3, 4}));
  CHECK(side(above, l) == Sign::positive);
  CHECK(side(below, l) == Sign::negative);
  CHECK(side(above, line(Q, P)) == Sign::negative);
}

TEMPLATE_TEST_CASE("parallel, perpendicular and foot", "[constructions]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Point<T> P{3, 1};
  const Line<T> l = line(Point<T>{0, 0}, Vector<T>{1, 1}), back = line(Point<T>{7, 7}, Vector<T>{-5, -5});
  CHECK(is_on(P, parallel(l, P)));
  CHECK(runs_along(parallel(l, P).direction(), {1, 1}));
  CHECK(is_on(P, perpendicular(l, P)));
  CHECK(runs_along(perpendicular(l, P).direction(), {-1, 1}));
  CHECK(runs_along(perpendicular(back, P).direction(), {1, -1}));
  CHECK(is(foot(P, l), {2, 2}));
  CHECK(is(foot(P, back), {2, 2}));
  CHECK(is(foot(Point<T>{2, 2}, l), {2, 2}));
  CHECK(is(midpoint(P, {0, 5}), {number<T>(3, 2), 3}));
  CHECK(is(distance(P, {-2, 13}), T(13)));  // 5-12-13
  CHECK(is(quarter_turn(Vector<T>{3, 1}), {-1, 3}));
}

TEMPLATE_TEST_CASE("a circle meets a directed line ahead of and behind the foot", "[constructions]", Fast, Bounded,
                   Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Circle<T> circle{{0, 0}, 5};
  const auto level = [](int height, int towards) { return line(Point<T>{10, T(height)}, Vector<T>{T(towards), 0}); };
  CHECK(is(meet(circle, level(3, -2), Along::ahead), {-4, 3}));
  CHECK(is(meet(circle, level(3, -2), Along::behind), {4, 3}));
  CHECK(is(meet(circle, level(3, 2), Along::ahead), {4, 3}));
  for (const Along which : {Along::ahead, Along::behind}) {
    CHECK(is(meet(circle, level(5, -2), which), {0, 5}));
    CHECK_THROWS_AS(meet(circle, level(6, -2), which), Impossible);
  }
  // (4, 6) and (-3, 5) are 3-4-5 away from (1, 2).
  const Circle<T> aside{{1, 2}, 5};
  CHECK(is(meet(aside, line(Point<T>{4, 6}, Point<T>{-3, 5}), Along::ahead), {-3, 5}));
  CHECK(is(meet(aside, line(Point<T>{4, 6}, Point<T>{-3, 5}), Along::behind), {4, 6}));
}

TEMPLATE_TEST_CASE("two circles meet left and right of the line of centres", "[constructions]", Fast, Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // 3-4-5 on the y axis: left of the way up is the negative x side. Height of the triangle 12/5, its foot at 16/5.
  const Circle<T> low{{0, 0}, 4}, high{{0, 5}, 3};
  const Point<T> west{number<T>(-12, 5), number<T>(16, 5)}, east{number<T>(12, 5), number<T>(16, 5)};
  CHECK(is(meet(low, high, Side::left), west));
  CHECK(is(meet(low, high, Side::right), east));
  CHECK(is(meet(high, low, Side::left), east));
  CHECK(is(meet(high, low, Side::right), west));
  for (const Side which : {Side::left, Side::right}) {
    CHECK(is(meet(low, {{0, 5}, 1}, which), {0, 4}));                     // outside
    CHECK(is(meet(low, {{0, 1}, 3}, which), {0, 4}));                     // the second inside
    CHECK(is(meet(Circle<T>{{0, 0}, 1}, {{0, 3}, 4}, which), {0, -1}));   // the first inside
    CHECK_THROWS_AS(meet(low, Circle<T>{{0, 8}, 3}, which), Impossible);  // apart
    CHECK_THROWS_AS(meet(low, Circle<T>{{0, 1}, 2}, which), Impossible);  // nested
    CHECK_THROWS_AS(meet(Circle<T>{{0, 1}, 2}, low, which), Impossible);
    CHECK_THROWS_AS(meet(low, Circle<T>{{0, 0}, 3}, which), Impossible);  // concentric
    CHECK_THROWS_AS(meet(low, low, which), Impossible);
  }
}

// Radii 0.1 and 0.2 at distance 0.3 touch; in binary they overlap by an ulp. An enclosure must not decide.
TEMPLATE_TEST_CASE("contact is left to the exact numbers", "[constructions]", Bounded, Deep) {
  using T = TestType;
  const Scope<T> scope;
  const Circle<T> first{{0, 0}, number<T>(1, 10)}, second{{number<T>(3, 10), 0}, number<T>(1, 5)};
  CHECK_THROWS_AS(meet(first, second, Side::left), Undecided);
  const Line<T> touching = line(Point<T>{0, number<T>(1, 10)}, Vector<T>{number<T>(1, 3), 0});
  CHECK_THROWS_AS(meet(Circle<T>{{0, number<T>(3, 10)}, number<T>(1, 5)}, touching, Along::ahead), Undecided);
  const Vector<T> u{number<T>(1, 10), number<T>(3, 10)}, w{number<T>(1, 5), number<T>(3, 5)};
  CHECK_THROWS_AS(close_polygon(Vector<T>{1, 0}, u, w), Undecided);
}
TEMPLATE_TEST_CASE("the exact numbers decide contact", "[constructions]", Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Circle<T> first{{0, 0}, number<T>(1, 10)}, second{{number<T>(3, 10), 0}, number<T>(1, 5)};
  CHECK(is(meet(first, second, Side::left), {number<T>(1, 10), 0}));
  const Line<T> touching = line(Point<T>{0, number<T>(1, 10)}, Vector<T>{number<T>(1, 3), 0});
  CHECK(is(meet(Circle<T>{{0, number<T>(3, 10)}, number<T>(1, 5)}, touching, Along::ahead), {0, number<T>(1, 10)}));
  const Vector<T> u{number<T>(1, 10), number<T>(3, 10)}, w{number<T>(1, 5), number<T>(3, 5)};
  CHECK_THROWS_AS(close_polygon(Vector<T>{1, 0}, u, w), Impossible);
}

TEMPLATE_TEST_CASE("a polygon of vectors closes with two unknown magnitudes", "[constructions]", Fast, Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // (3, -2) + 1 (1, 4) = 2 (2, 1).
  const Vector<T> known{3, -2}, u{1, 4}, w{2, 1};
  const TwoMagnitudes<T> found = close_polygon(known, u, w);
  CHECK(is(found.of_first, T(1)));
  CHECK(is(found.of_second, T(2)));
  const TwoMagnitudes<T> against = close_polygon(known, -u, -w);
  CHECK(is(against.of_first, T(-1)));
  CHECK(is(against.of_second, T(-2)));
  CHECK_THROWS_AS(close_polygon(known, u, Vector<T>{2, 8}), Impossible);
  CHECK_THROWS_AS(close_polygon(known, u, Vector<T>{-1, -4}), Impossible);
  CHECK_THROWS_AS(close_polygon(known, Vector<T>{0, 0}, w), Impossible);
  CHECK(is(known + closing_side(known, w), w));
}

TEMPLATE_TEST_CASE("a figure on tracing paper keeps its shape", "[constructions]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // AB = 5 along x is laid on a segment of slope 4/3: cosine 3/5, sine 4/5.
  const Point<T> A{0, 0}, B{5, 0}, C{2, 3}, A_new{1, 1}, B_new{4, 5};
  const Transport<T> paper(A, B, A_new, B_new);
  const Point<T> C_new = paper(C);
  CHECK(is(paper(A), A_new));
  CHECK(is(paper(B), B_new));
  CHECK(is(C_new, {number<T>(-1, 5), number<T>(22, 5)}));  // 1 + (6 - 12)/5, 1 + (8 + 9)/5
  CHECK(is(length_squared(C_new - A_new), length_squared(C - A), 100));
  CHECK(is(length_squared(C_new - B_new), length_squared(C - B), 100));
  CHECK(is(cross(B_new - A_new, C_new - A_new), cross(B - A, C - A), 100));  // not turned over
  CHECK(is(Transport<T>(A_new, B_new, A, B)(C_new), C));

  CHECK(is(paper(Vector<T>{5, 0}), {3, 4}));
  const ProjectivePoint<T> north = paper(ProjectivePoint<T>{0, 5, 0});
  CHECK(sign(north.w) == Sign::zero);
  CHECK(is(Vector<T>{north.x, north.y}, {-4, 3}));
  CHECK(is(finite(paper(ProjectivePoint<T>{-4, -6, -2})), C_new));
}

TEMPLATE_TEST_CASE("a circle is divided into twelve parts", "[constructions]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const T half = number<T>(1, 2), long_leg = half * root(T(3));  // of the half equilateral triangle
  const std::array<T, 12> cosines{T(1),  long_leg,  half,  T(0), -half, -long_leg,
                                  T(-1), -long_leg, -half, T(0), half,  long_leg};
  const Point<T> centre{2, -1}, start{4, -1};
  for (std::size_t k = 0; k < 12; ++k) {
    CAPTURE(k);
    const Point<T> P = turned(start, centre, Angle{Rational(static_cast<int>(k), 12)});
    CHECK(is(P, centre + T(2) * Vector<T>{cosines[k], cosines[(k + 9) % 12]}));
    // The points on the axes have no rounding at all.
    if (k % 3 == 0) CHECK(sign(T((P.x - centre.x) * (P.y - centre.y))) == Sign::zero);
    if (k % 3 == 0) CHECK(sign(T(length_squared(P - centre) - 4)) == Sign::zero);
  }
  CHECK(is(turned(Point<T>{3, 4}, {0, 0}, Angle{Rational(1, 4)}), {-4, 3}));
  CHECK(is(turned(Point<T>{3, 4}, {0, 0}, Angle{Rational(-1, 4)}), {4, -3}));
  Point<T> walking{3, 4};
  for (int i = 0; i < 12; ++i) walking = turned(walking, centre, Angle{Rational(1, 12)});
  CHECK(is(walking, {3, 4}));
}

TEMPLATE_TEST_CASE("a cycle through three points is a circle, a line, or nothing", "[constructions]", Fast, Bounded,
                   Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // All three 3-4-5 or 5 away from (1, 2), counter-clockwise.
  const Point<T> P{6, 2}, Q{4, 6}, R{-3, 5}, inside{2, 2};
  const Cycle<T> circle = cycle_through(P, Q, R);
  CHECK(is(finite(circle.centre()), {1, 2}));
  CHECK(is(circle.radius(), T(5)));
  CHECK(is(cycle_through(R, Q, P).radius(), T(5)));
  for (const Point<T>& X : {P, Q, R, Point<T>{1, -3}}) CHECK(is(circle.power(X), T(0), 1e4));
  CHECK(sign(circle.power(inside)) == Sign::negative);
  CHECK(sign(cycle_through(R, Q, P).power(inside)) == Sign::positive);

  const Cycle<T> straight = cycle_through(Point<T>{1, 1}, Point<T>{3, 5}, Point<T>{2, 3});  // y = 2x - 1
  CHECK(sign(straight.k) == Sign::zero);
  CHECK(sign(straight.centre().w) == Sign::zero);
  CHECK(is_on(Point<T>{0, -1}, straight.straight()));
  CHECK(sign(straight.power(Point<T>{0, 0})) != Sign::zero);
  CHECK(is(cross(straight.straight().direction(), Vector<T>{1, 2}), T(0), 1000));
  CHECK_THROWS_AS(straight.radius(), Undecided);

  const Cycle<T> nothing = cycle_through(P, P, P);
  for (const T& coefficient : {nothing.k, nothing.l, nothing.m, nothing.n}) CHECK(sign(coefficient) == Sign::zero);

  // 2 |X - (1, 2)|² - 50 = 0, written for the origin.
  const Cycle<T> about = cycle_about(Point<T>{1, 2}, T(2), Vector<T>{0, 0}, T(-50));
  CHECK(is(about.radius(), T(5)));
  CHECK(is(about.n, T(-40)));
  CHECK(is(absolute(T(-3)), T(3)));
}

// CGAL's own function called magnitude keeps the far end only.
TEST_CASE("the absolute value of an interval is an interval", "[constructions]") {
  const Arithmetic<Bounded> scope;
  const Bounded x = absolute(Bounded(-3, -2));
  CHECK(x.inf() == 2);
  CHECK(x.sup() == 3);
  CHECK_THROWS_AS(absolute(Bounded(-1, 1)), Undecided);
  const Cycle<Bounded> wide{Bounded(1, 2), Bounded(0), Bounded(0), Bounded(-4)};
  CHECK(wide.radius().inf() <= std::sqrt(2.0));
  CHECK(wide.radius().sup() >= 2);
}

}  // namespace epure::tests
