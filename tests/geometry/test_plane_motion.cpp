// The state of a moving plane: by motions whose circles are in every textbook, by identities proved exactly on random
// states, and against the complex numbers of geometry/analytic.
#include "geometry/analytic/plane_motion_formulas.h"
#include "geometry/mechanisms/slider_crank.h"
#include "geometry/motion/plane_motion.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

#include <cstdio>

namespace epure::tests {
namespace {

template <class T>
bool is_at_infinity(const ProjectivePoint<T>& P) {
  return sign(P.w) == Sign::zero && (sign(P.x) != Sign::zero || sign(P.y) != Sign::zero);
}
template <class T>
bool is_undefined(const ProjectivePoint<T>& P) {
  return sign(P.w) == Sign::zero && sign(P.x) == Sign::zero && sign(P.y) == Sign::zero;
}
// k (x² + y²) + l x w + m y w + n w²: zero when P lies on the cycle, also at infinity.
template <class T>
T power(const Cycle<T>& cycle, const ProjectivePoint<T>& P) {
  return cycle.k * (square(P.x) + square(P.y)) + P.w * (cycle.l * P.x + cycle.m * P.y + cycle.n * P.w);
}
template <class T>
bool passes(const Cycle<T>& cycle, const Point<T>& P) {
  return is(cycle.power(P), T(0), 1e4);
}

// The ladder: A slides on the x axis, B on the y axis, AB = 5, at A = (3, 0), B = (0, 4), turning with ω = 1 and any
// α. The pole is (3, 4); v_A = ω k x P₀A = (4, 0). That a_B stays on the y axis, 0 = a_A + α (-4) + 3, gives a_A.
template <class T>
PlaneMotion<T> ladder(int alpha) {
  return {{3, 0}, {4, 0}, {T(4 * alpha - 3), 0}, T(1), T(alpha)};
}

Exact random_exact(Random& random) { return from_rational<Exact>(random.fraction() * 10); }
PlaneMotion<Exact> random_motion(Random& random, bool turns, bool speeds_up) {
  const auto next = [&] { return random_exact(random); };
  const Exact x = next(), y = next(), v_x = next(), v_y = next(), a_x = next(), a_y = next();
  return {{x, y}, {v_x, v_y}, {a_x, a_y}, turns ? next() : Exact(0), speeds_up ? next() : Exact(0)};
}

analytic::PlaneMotion<Exact> second_route(const PlaneMotion<Exact>& m) {
  return {{m.A.x, m.A.y}, {m.v_A.x, m.v_A.y}, {m.a_A.x, m.a_A.y}, m.omega, m.alpha};
}
bool same(const Point<Exact>& P, const analytic::Complex<Exact>& z) { return is(P.x, z.re) && is(P.y, z.im); }
bool same(const ProjectivePoint<Exact>& P, const std::optional<analytic::Complex<Exact>>& z) {
  return z && same(finite(P), *z);
}
// Both lines have the same points: their coefficients are proportional.
bool is_same_line(const Line<Exact>& l, const analytic::Line<Exact>& m) {
  return is(l.a * m.normal.im, l.b * m.normal.re) && is(l.a * m.offset, l.c * m.normal.re) &&
         is(l.b * m.offset, l.c * m.normal.im);
}

}  // namespace

TEMPLATE_TEST_CASE("a wheel rolls on a straight rail", "[plane motion]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // Radius 1 about (0, 1), to the right at unit speed. The contact is the pole, the hub runs straight and is both K
  // and the inflection pole. The top of a cycloid has radius of curvature 4.
  const PlaneMotion<T> wheel{{0, 1}, {1, 0}, {0, 0}, T(-1), T(0)};
  CHECK(is(finite(wheel.pole()), {0, 0}));
  CHECK(is(finite(wheel.acceleration_pole()), {0, 1}));
  CHECK(is(finite(wheel.inflection_pole()), {0, 1}));
  CHECK(is(finite(wheel.inflection_circle().centre()), {0, number<T>(1, 2)}));
  CHECK(is(wheel.inflection_circle().radius(), number<T>(1, 2)));
  CHECK(is(finite(wheel.centre_of_curvature({0, 2})), {0, -2}));
  CHECK(is(finite(wheel.on_inflection_circle({0, 2})), {0, 1}));
  CHECK(is_at_infinity(wheel.centre_of_curvature({0, 1})));
  CHECK(is_undefined(wheel.centre_of_curvature({0, 0})));
  CHECK(is_undefined(wheel.on_inflection_circle({0, 0})));
  // Steady turning: the stationarity circle is the vertical through contact and hub.
  CHECK(sign(wheel.stationarity_circle().k) == Sign::zero);
  CHECK(is_on(Point<T>{0, 7}, wheel.stationarity_circle().straight()));
  CHECK(sign(wheel.stationarity_circle().power({1, 1})) != Sign::zero);
  CHECK(is(wheel.velocity({0, 2}), {2, 0}));
  CHECK(is(wheel.acceleration({0, 2}), {0, -1}));
}

TEMPLATE_TEST_CASE("a ladder slides down a wall, however fast", "[plane motion]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  for (const int alpha : {-2, 0, 3}) {
    CAPTURE(alpha);
    const PlaneMotion<T> m = ladder<T>(alpha);
    CHECK(is(m.acceleration({0, 4}).x, T(0)));
    CHECK(is(finite(m.pole()), {3, 4}));
    // Cardan's circle, through the feet A and B, the pole and the corner opposite it; the same for every α.
    const Cycle<T> inflections = m.inflection_circle();
    CHECK(is(finite(inflections.centre()), {number<T>(3, 2), 2}));
    CHECK(is(inflections.radius(), number<T>(5, 2)));
    CHECK(is(finite(m.inflection_pole()), {0, 0}));
    for (const Point<T>& X : {Point<T>{3, 0}, Point<T>{0, 4}, Point<T>{3, 4}}) CHECK(passes(inflections, X));
    // The middle of the ladder runs on a circle of radius 5/2 about the corner.
    CHECK(is(finite(m.centre_of_curvature({number<T>(3, 2), 2})), {0, 0}));
    CHECK(is_at_infinity(m.centre_of_curvature({3, 0})));
    CHECK(is(finite(m.on_inflection_circle({number<T>(3, 2), 2})), {0, 0}));
    CHECK(is(m.acceleration(finite(m.acceleration_pole())), {0, 0}));
    CHECK(passes(m.stationarity_circle(), finite(m.pole())));
    CHECK(passes(m.stationarity_circle(), finite(m.acceleration_pole())));
  }
}

TEMPLATE_TEST_CASE("a link turns about a fixed pin", "[plane motion]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // About (1, 1), A = (4, 5), ω = 2, α = 3: v = 2 k x (3, 4), a = 3 k x (3, 4) - 4 (3, 4).
  const PlaneMotion<T> link{{4, 5}, {-8, 6}, {-24, -7}, T(2), T(3)};
  const Point<T> pin{1, 1}, X{-2, 7};
  CHECK(is(finite(link.pole()), pin));
  CHECK(is(finite(link.acceleration_pole()), pin));
  CHECK(is(finite(link.centre_of_curvature(X)), pin));
  // Both circles shrink to the pin: where else could a be along v?
  CHECK(is(finite(link.inflection_circle().centre()), pin));
  CHECK(is(finite(link.inflection_pole()), pin));
  CHECK(is(finite(link.on_inflection_circle(X)), pin));
  CHECK(is(euler_savary_point(pin, X, pin), pin));
}

TEMPLATE_TEST_CASE("a plane that does not turn just now", "[plane motion]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  // v = (2, 0) everywhere, α = 3: a(x, y) = (1, 2) + 3 (-y, x) is zero in K = (-2/3, 1/3). a is along v where a_y =
  // 0, square to it where a_x = 0.
  const PlaneMotion<T> m{{0, 0}, {2, 0}, {1, 2}, T(0), T(3)};
  CHECK(is_at_infinity(m.pole()));
  CHECK(is(m.pole().x, T(0)));
  CHECK(is(finite(m.acceleration_pole()), {number<T>(-2, 3), number<T>(1, 3)}));
  CHECK(sign(m.inflection_circle().k) == Sign::zero);
  CHECK(sign(m.stationarity_circle().k) == Sign::zero);
  CHECK(is_on(Point<T>{number<T>(-2, 3), 9}, m.inflection_circle().straight(), 100));
  CHECK(is_on(Point<T>{9, number<T>(1, 3)}, m.stationarity_circle().straight(), 100));
  CHECK(is(finite(meet(m.inflection_circle().straight(), m.stationarity_circle().straight())),
           finite(m.acceleration_pole())));
  CHECK(is_at_infinity(m.inflection_pole()));
  CHECK(is_at_infinity(m.on_inflection_circle({1, 1})));
  // At (1, 1) a = (-2, 5): curvature v x a/|v|³ = 10/8, centre 4/5 to the left.
  CHECK(is(finite(m.centre_of_curvature({1, 1})), {1, number<T>(9, 5)}));

  // Nor change its turning: every path has the same shape, nothing is at rest.
  const PlaneMotion<T> slide{{0, 0}, {2, 0}, {1, 2}, T(0), T(0)};
  CHECK(is_at_infinity(slide.pole()));
  CHECK(is_undefined(slide.acceleration_pole()));
  for (const Cycle<T>& c : {slide.inflection_circle(), slide.stationarity_circle()}) {
    for (const T& coefficient : {c.k, c.l, c.m}) CHECK(sign(coefficient) == Sign::zero);
    CHECK(sign(c.n) == Sign::positive);
  }
  CHECK(is(finite(slide.centre_of_curvature({5, 5})), {5, 7}));  // |v|²/a_n = 4/2
}

TEST_CASE("random planes: what the circles promise is proved", "[plane motion]") {
  const std::uint64_t start = seed();
  Random random(start);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(start, i);
    const Arithmetic<Exact> tower;
    const bool turns = i % 4 != 3, speeds_up = i % 3 != 2;
    const PlaneMotion<Exact> m = random_motion(random, turns, speeds_up);
    const Cycle<Exact> inflections = m.inflection_circle(), stationarity = m.stationarity_circle();
    const ProjectivePoint<Exact> P0 = m.pole(), K = m.acceleration_pole();
    CHECK((sign(P0.w) == Sign::zero) == !turns);
    CHECK((sign(K.w) == Sign::zero) == !(turns || speeds_up));
    CHECK((sign(inflections.k) == Sign::zero) == !turns);
    CHECK((sign(stationarity.k) == Sign::zero) == !(turns && speeds_up));
    for (const Cycle<Exact>& cycle : {inflections, stationarity}) {
      CHECK(is(power(cycle, P0), Exact(0)));
      if (turns || speeds_up) CHECK(is(power(cycle, K), Exact(0)));
    }
    if (turns) {
      CHECK(is(m.velocity(finite(P0)), {0, 0}));
      CHECK(is(power(inflections, m.inflection_pole()), Exact(0)));
      CHECK(is(midpoint(finite(P0), finite(m.inflection_pole())), finite(inflections.centre())));
      // The circles cross at right angles in P₀.
      const Vector<Exact> n{stationarity.l + 2 * stationarity.k * finite(P0).x,
                            stationarity.m + 2 * stationarity.k * finite(P0).y};
      CHECK(is(dot(n, finite(m.inflection_pole()) - finite(P0)), Exact(0)));
    }
    if (turns || speeds_up) CHECK(is(m.acceleration(finite(K)), {0, 0}));

    const Exact x = random_exact(random), y = random_exact(random);
    const Point<Exact> X{x, y};
    const Vector<Exact> v = m.velocity(X), a = m.acceleration(X);
    // The power is the very product of which the circle is the zero.
    CHECK(is(inflections.power(X), cross(v, a)));
    CHECK(is(stationarity.power(X), dot(v, a)));
    // The osculating circle: twice differentiated, |X - Ω|² = ρ² is v . (X - Ω) = 0 and a . (X - Ω) + |v|² = 0.
    const Point<Exact> centre = finite(m.centre_of_curvature(X));
    CHECK(is(dot(v, X - centre), Exact(0)));
    CHECK(is(dot(a, X - centre), -length_squared(v)));
    if (!turns) continue;
    // Euler-Savary with directed lengths, all on the ray.
    const Point<Exact> pole = finite(P0), X1 = finite(m.on_inflection_circle(X));
    CHECK(is(inflections.power(X1), Exact(0)));
    CHECK(is(cross(X1 - pole, X - pole), Exact(0)));
    CHECK(is(cross(centre - X, X - pole), Exact(0)));
    CHECK(is(dot(centre - X, X1 - X), length_squared(X - pole)));
    CHECK(is(euler_savary_point(pole, X, centre), X1));
    const Point<Exact> on_circle = X1;
    CHECK(is(cross(m.velocity(on_circle), m.acceleration(on_circle)), Exact(0)));
  }
}

TEST_CASE("random planes: the same by complex numbers", "[plane motion]") {
  const std::uint64_t start = seed();
  Random random(start);
  int circles = 0, lines = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(start, i);
    const Arithmetic<Exact> tower;
    const PlaneMotion<Exact> m = random_motion(random, i % 4 != 3, i % 3 != 2);
    const analytic::PlaneMotion<Exact> z = second_route(m);
    const Exact x = random_exact(random), y = random_exact(random);
    const Point<Exact> X{x, y};
    CHECK((sign(m.acceleration_pole().w) == Sign::zero) == !z.acceleration_pole());
    if (z.acceleration_pole()) CHECK(same(m.acceleration_pole(), z.acceleration_pole()));
    CHECK(same(m.centre_of_curvature(X), z.centre_of_curvature({x, y})));
    if (z.pole()) {
      CHECK(same(m.pole(), z.pole()));
      CHECK(same(m.inflection_pole(), z.inflection_pole()));
      CHECK(same(m.on_inflection_circle(X), z.on_inflection_circle({x, y})));
      CHECK(same(m.inflection_circle().centre(), z.inflection_circle()->centre));
      CHECK(is(2 * m.inflection_circle().radius(), z.inflection_circle()->diameter));
    }
    if (const auto circle = z.stationarity_circle()) {
      ++circles;
      CHECK(same(m.stationarity_circle().centre(), circle->centre));
      CHECK(is(2 * m.stationarity_circle().radius(), circle->diameter));
    }
    for (const auto& [cycle, line] : {std::pair{m.inflection_circle(), z.inflection_line()},
                                      std::pair{m.stationarity_circle(), z.stationarity_line()}}) {
      if (!line) continue;
      ++lines;
      CHECK(sign(cycle.k) == Sign::zero);
      CHECK(is_same_line(cycle.straight(), *line));
    }
  }
  std::printf("plane motions with seed %llu: %d stationarity circles, %d cycles that are lines\n",
              static_cast<unsigned long long>(start), circles, lines);
  CHECK(circles > 60);
  CHECK(lines > 60);
}

}  // namespace epure::tests
