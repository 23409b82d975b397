// Instant centres by Aronhold and Kennedy: a four-bar with integer hinges worked out by hand, mechanisms with centres
// at infinity, degenerate positions, and a six-bar whose centres are held against its velocities.
#include "geometry/mechanisms/four_bar.h"
#include "geometry/motion/instant_centres.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

namespace epure::tests {
namespace {

// The same point of the projective plane.
template <class T>
bool is_same(const ProjectivePoint<T>& P, const ProjectivePoint<T>& Q) {
  const Line<T> none = line(P, Q);
  return is(none.a, T(0), 1e4) && is(none.b, T(0), 1e4) && is(none.c, T(0), 1e4);
}
template <class T>
bool is_at(const ProjectivePoint<T>& P, const Point<T>& Q) {
  return is(finite(P), Q);
}
template <class T>
bool is_towards(const ProjectivePoint<T>& P, const Vector<T>& d) {
  return sign(P.w) == Sign::zero && is(cross(Vector<T>{P.x, P.y}, d), T(0), 1e4);
}

template <class T>
std::vector<Joint<T>> joints_of(const FourBar<T>& at) {
  return {hinge(1, 2, at.A0), hinge(2, 3, at.A), hinge(3, 4, at.B), hinge(1, 4, at.B0)};
}

}  // namespace

TEMPLATE_TEST_CASE("a line passes two projective points", "[constructions]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Point<T> P{1, 2}, Q{4, 6};
  const Line<T> ordinary = line(P, Q), l = line(projective(P), projective(Q));
  for (const auto& [found, expected] : {std::pair(l.a, ordinary.a), {l.b, ordinary.b}, {l.c, ordinary.c}})
    CHECK(is(found, expected));
  // Towards a direction, and from it.
  const ProjectivePoint<T> east{5, 0, 0}, north{0, -2, 0};
  CHECK(is_on(P, line(projective(P), east)));
  CHECK(is_on(Point<T>{9, 2}, line(east, projective(P))));
  CHECK(runs_along(line(projective(P), east).direction(), {1, 0}));
  const Line<T> infinity = line(east, north);
  CHECK(sign(infinity.a) == Sign::zero);
  CHECK(sign(infinity.b) == Sign::zero);
  CHECK(sign(infinity.c) != Sign::zero);
  CHECK(is_towards(meet(infinity, ordinary), {3, 4}));
  const Line<T> none = line(east, ProjectivePoint<T>{-1, 0, 0});
  for (const T& coefficient : {none.a, none.b, none.c}) CHECK(sign(coefficient) == Sign::zero);
}

// A0 (0,0), A (1,2), B (5,4), B0 (6,0): crank on y = 2x, rocker on 4x + y = 24, so P_13 (4, 8); coupler on
// x - 2y + 3 = 0, so P_24 (-3, 0).
TEMPLATE_TEST_CASE("instant centres of a four-bar", "[instant-centres]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const FourBar<T> at{{0, 0}, {1, 2}, {5, 4}, {6, 0}};
  const InstantCentres<T> centres = instant_centres<T>(4, joints_of(at));
  CHECK(is_at(centres.at(1, 3), {4, 8}));
  CHECK(is_at(centres.at(4, 2), {-3, 0}));
  CHECK(is_at(centres.at(2, 1), {0, 0}));
  REQUIRE(centres.in_order().size() == 6);
  for (std::size_t i = 0; i < 4; ++i) CHECK_FALSE(centres.in_order()[i].lines);

  const InstantCentre<T>& pole = centres.of(3, 1);
  CHECK(pole.i == 1);
  CHECK(pole.j == 3);
  REQUIRE(pole.lines);
  CHECK(pole.lines->k == 2);
  CHECK(pole.lines->l == 4);
  CHECK(is_on(at.A, pole.lines->through_k));
  CHECK(is_on(at.A0, pole.lines->through_k));
  CHECK(is_on(at.B, pole.lines->through_l));
  CHECK(is_on(at.B0, pole.lines->through_l));
  CHECK_THROWS_AS(centres.of(1, 5), std::out_of_range);

  // v_A = ω_2 A0A = ω_3 P_13A in size, against each other: A0A = √5, P_13A = 3√5. And ω_4 : ω_2 = 3 : 9.
  const Ratio<T> coupler = angular_velocities(centres.at(1, 3), centres.at(1, 2), centres.at(2, 3));
  CHECK(is(quotient(coupler.first, coupler.second), number<T>(-1, 3)));
  const Ratio<T> rocker = angular_velocities(centres.at(1, 4), centres.at(1, 2), centres.at(2, 4));
  CHECK(is(quotient(rocker.first, rocker.second), number<T>(1, 3)));
  const FourBarMotion<T> motion = four_bar_motion(at, T(1), T(0));
  CHECK(is(motion.coupler.omega, number<T>(-1, 3)));
  CHECK(is(motion.rocker.omega, number<T>(1, 3)));
}

TEMPLATE_TEST_CASE("crank and rocker parallel: the coupler's centre is their direction", "[instant-centres]", Fast,
                   Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const FourBar<T> at{{0, 0}, {1, 2}, {6, 6}, {3, 0}};
  const InstantCentres<T> centres = instant_centres<T>(4, joints_of(at));
  CHECK(is_towards(centres.at(1, 3), {1, 2}));
  const Ratio<T> coupler = angular_velocities(centres.at(1, 3), centres.at(1, 2), centres.at(2, 3));
  CHECK(sign(coupler.first) == Sign::zero);
  CHECK(sign(coupler.second) != Sign::zero);
  const Ratio<T> rocker = angular_velocities(centres.at(1, 4), centres.at(1, 2), centres.at(2, 4));
  CHECK(is(T(3) * rocker.first, rocker.second, 1e3));  // v_A = v_B: ω_4 3√5 = ω_2 √5
}

// Dead centre of the rocker: P_24 falls on A0 and the rocker stands; P_13 falls on B.
TEMPLATE_TEST_CASE("in a dead centre two centres fall on hinges", "[instant-centres]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const FourBar<T> at{{0, 0}, {1, 2}, {3, 6}, {7, 0}};
  const InstantCentres<T> centres = instant_centres<T>(4, joints_of(at));
  CHECK(is_at(centres.at(1, 3), at.B));
  CHECK(is_at(centres.at(2, 4), at.A0));
  const Ratio<T> rocker = angular_velocities(centres.at(1, 4), centres.at(1, 2), centres.at(2, 4));
  CHECK(sign(rocker.first) == Sign::zero);
  CHECK(sign(rocker.second) != Sign::zero);
  const Ratio<T> reversed = angular_velocities(centres.at(1, 2), centres.at(1, 4), centres.at(2, 4));
  CHECK(sign(reversed.first) != Sign::zero);
  CHECK(sign(reversed.second) == Sign::zero);
}

TEMPLATE_TEST_CASE("what no two lines determine is said to be undetermined", "[instant-centres]", Fast, Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  SECTION("a change point: all hinges in line") {
    const FourBar<T> flat{{0, 0}, {-2, 0}, {3, 0}, {7, 0}};
    const InstantCentres<T> centres = instant_centres<T>(4, joints_of(flat));
    CHECK_FALSE(centres.of(1, 3).at);
    CHECK_FALSE(centres.of(2, 4).at);
    CHECK_FALSE(centres.of(2, 4).lines);
    CHECK_THROWS_AS(centres.at(1, 3), Impossible);
    CHECK(centres.in_order().size() == 6);
    CHECK_FALSE(centres.in_order().back().at);
  }
  SECTION("a five-bar wants one more driven link") {
    const InstantCentres<T> centres =
        instant_centres<T>(5, {hinge(1, 2, Point<T>{0, 0}), hinge(2, 3, Point<T>{1, 2}), hinge(3, 4, Point<T>{3, 5}),
                               hinge(4, 5, Point<T>{6, 3}), hinge(1, 5, Point<T>{7, 0})});
    CHECK(centres.in_order().size() == 10);
    CHECK_FALSE(centres.of(1, 3).at);
    CHECK_FALSE(centres.of(2, 5).at);
  }
  SECTION("three centres in one point say nothing of the speeds") {
    const ProjectivePoint<T> P{1, 1, 1}, twice{2, 2, 2};
    CHECK_THROWS_AS(angular_velocities(P, twice, P), Impossible);
  }
}

// Crank A0 (0,0), A (3,4), B (8, 0) on the x axis, the slider 4 on the frame: P_13 above B on the crank's line
// y = 4x/3: (8, 32/3); P_24 where AB (4x + 5y = 32) meets the upright through A0: (0, 32/5).
TEMPLATE_TEST_CASE("instant centres of a slider-crank", "[instant-centres]", Fast, Bounded, Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Point<T> A0{0, 0}, A{3, 4}, B{8, 0};
  const InstantCentres<T> centres =
      instant_centres<T>(4, {hinge(2, 1, A0), hinge(3, 2, A), hinge(4, 3, B), slider(4, 1, Vector<T>{-2, 0})});
  CHECK(is_towards(centres.at(1, 4), {0, 1}));
  CHECK(is_at(centres.at(1, 3), {8, number<T>(32, 3)}));
  CHECK(is_at(centres.at(2, 4), {0, number<T>(32, 5)}));
  // ω_3 : ω_2 = -A0A : P_13A = -5 : (5 · 5/3).
  const Ratio<T> coupler = angular_velocities(centres.at(1, 3), centres.at(1, 2), centres.at(2, 3));
  CHECK(is(quotient(coupler.first, coupler.second), number<T>(-3, 5)));
  const Ratio<T> slider_to_crank = angular_velocities(centres.at(1, 4), centres.at(1, 2), centres.at(2, 4));
  CHECK(sign(slider_to_crank.first) == Sign::zero);
  // Two that do not turn have no ratio.
  CHECK_THROWS_AS(angular_velocities(centres.at(1, 4), centres.at(1, 4), centres.at(1, 4)), Impossible);
}

// Scotch yoke: crank 2, block 3 on its pin, yoke 4 with an upright slot, guided along x. Both sliders' centres are at
// infinity, and their line too: the block only translates, along the crank's tangent.
TEMPLATE_TEST_CASE("instant centres with the line at infinity", "[instant-centres]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Point<T> A0{0, 0}, A{3, 4};
  const InstantCentres<T> centres = instant_centres<T>(
      4, {hinge(1, 2, A0), hinge(2, 3, A), slider(3, 4, Vector<T>{0, 1}), slider(1, 4, Vector<T>{1, 0})});
  CHECK(is_towards(centres.at(1, 3), {3, 4}));
  CHECK(is_at(centres.at(2, 4), {0, 4}));  // v_4 = ω_2 times the height of A
}

// A four-bar 1-2-3-4 whose coupler carries C, with the dyad 5 (bar CD) and 6 (bar D D0): every centre of the fifteen
// is where the two bodies, moved by the dyads' velocity polygons, have one velocity.
TEMPLATE_TEST_CASE("fifteen centres of a six-bar agree with its velocities", "[instant-centres]", Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const FourBar<T> at{{0, 0}, {1, 2}, {5, 4}, {6, 0}};
  const Point<T> C{2, 5}, D{9, 6}, D0{11, 1};
  std::vector<Joint<T>> joints = joints_of(at);
  joints.insert(joints.end(), {hinge(3, 5, C), hinge(5, 6, D), hinge(6, 1, D0)});
  const InstantCentres<T> centres = instant_centres<T>(6, joints);
  REQUIRE(centres.in_order().size() == 15);

  const FourBarMotion<T> motion = four_bar_motion(at, T(1), T(0));
  const Bar<T> five{pin_on(motion.coupler, C)}, six{fixed_pin(D0)};
  const DyadVelocity<T> v = dyad_velocity(five, six, D);
  const std::vector<PlaneMotion<T>> bodies{
      turning_about(at.A0, T(0), T(0)), motion.crank, motion.coupler, motion.rocker, five.motion(v.first_rate, T(0)),
      six.motion(v.second_rate, T(0))};
  int finite_centres = 0;
  for (const InstantCentre<T>& centre : centres.in_order()) {
    CAPTURE(centre.i, centre.j);
    REQUIRE(centre.at);
    const PlaneMotion<T>&one = bodies[static_cast<std::size_t>(centre.i - 1)],
          &other = bodies[static_cast<std::size_t>(centre.j - 1)];
    const Point<T> P = finite(*centre.at);
    ++finite_centres;
    CHECK(is(one.velocity(P), other.velocity(P), 1e3));
    if (centre.i == 1) {
      CHECK(is_at(other.pole(), P));
      continue;
    }
    const Ratio<T> ratio = angular_velocities(centres.at(1, centre.i), centres.at(1, centre.j), *centre.at);
    CHECK(is(ratio.first * other.omega, ratio.second * one.omega, 1e4));
  }
  CHECK(finite_centres == 15);
}

TEST_CASE("a degenerate pair of lines is left to the exact numbers", "[instant-centres]") {
  // 1/10, 2/10 and 3/10 are no binary numbers: hinges on the line y = 2x that no enclosure proves to be.
  const auto flat = []<class T>() {
    const auto on_line = [](int x) { return Point<T>{number<T>(x, 10), number<T>(x, 5)}; };
    return instant_centres<T>(4, joints_of(FourBar<T>{on_line(0), on_line(-2), on_line(3), on_line(7)}));
  };
  {
    const Arithmetic<Bounded> scope;
    CHECK_THROWS_AS(flat.template operator()<Bounded>(), Undecided);
  }
  {
    const Arithmetic<Deep> scope(256);
    CHECK_THROWS_AS(flat.template operator()<Deep>(), Undecided);
  }
  const Arithmetic<Exact> tower;
  CHECK_FALSE(flat.template operator()<Exact>().of(1, 3).at);
}

// The rocker's hinge misses the line of the others by 1e-30: the centres exist.
TEST_CASE("missing a change point by 1e-30 the centres are determined", "[instant-centres]") {
  const Arithmetic<Deep> scope(256);
  const Deep miss = from_rational<Deep>(Random(0).power_of_ten(-30, -30));
  const InstantCentres<Deep> centres =
      instant_centres<Deep>(4, joints_of(FourBar<Deep>{{0, 0}, {-2, 0}, {3, 0}, {7, miss}}));
  // The coupler lies along the crank: P_13 on B, P_24 on A0.
  CHECK(is_at(centres.at(1, 3), {3, 0}));
  CHECK(is_at(centres.at(2, 4), {0, 0}));
}

// Chains of 1e8 m and 1e-8 m: the coordinates of a centre do not grow with every step.
TEMPLATE_TEST_CASE("a centre found by others found before is as finite as they are", "[instant-centres]", Fast,
                   Bounded) {
  using T = TestType;
  const Scope<T> scope;
  for (const int exponent : {8, -8}) {
    const T s = from_rational<T>(Random(0).power_of_ten(exponent, exponent));
    const auto at = [&](int x, int y) { return Point<T>{s * T(x), s * T(y)}; };
    const InstantCentres<T> centres = instant_centres<T>(
        6, {hinge(1, 2, at(0, 0)), hinge(2, 3, at(1, 2)), hinge(3, 4, at(5, 4)), hinge(1, 4, at(6, 0)),
            hinge(3, 5, at(2, 5)), hinge(5, 6, at(9, 6)), hinge(6, 1, at(11, 1))});
    for (const InstantCentre<T>& centre : centres.in_order()) CHECK(is(centre.at->w, T(1)));
  }
}

}  // namespace epure::tests
