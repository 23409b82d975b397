// The points that compass and divider find on cycloid and involute are those of the rolling circle and line.
#include "geometry/analytic/cycloid.h"
#include "geometry/motion/cycloid_by_arc.h"
#include "geometry/motion/roulette_divisions.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

// Two narrow enclosures of one number.
void agree(const Deep& a, const Deep& b) {
  const Enclosure apart = enclosure(a - b);
  CHECK(apart.lower <= 0);
  CHECK(apart.upper >= 0);
  CHECK(apart.upper - apart.lower < 1e-60);
}
void agree(const Point<Deep>& P, const Point<Deep>& Q) {
  agree(P.x, Q.x);
  agree(P.y, Q.y);
}

}  // namespace

TEST_CASE("a point of the cycloid by two arcs is where the wheel carries it", "[divisions]") {
  const Arithmetic<Deep> scope(256);
  for (const Rational& r : {Rational(1, 2), Rational(7, 3)})
    for (int i = 1; i < 24; ++i) {
      CAPTURE(i);
      const Rational turns(i, 24);
      const auto division = cycloid_division<Deep>(r, {turns});
      const Rolling wheel{.how = Rolls::circle_on_line, .r = r, .d = r};
      agree(division.M, tracing_point<Deep>(wheel, Angle{turns}));
      agree(division.on_line, contact_point<Deep>(wheel, Angle{turns}));
    }
}

TEST_CASE("a point of the involute on its tangent is where the line carries it", "[divisions]") {
  const Arithmetic<Deep> scope(256);
  const Rational R(3, 10);
  for (int i = 1; i < 50; ++i) {
    CAPTURE(i);
    const Rational turns(i, 18);
    const auto division = involute_division<Deep>(R, {turns});
    const Rolling line{.how = Rolls::line_on_circle, .R = R};
    agree(division.M, tracing_point<Deep>(line, Angle{turns}));
    agree(division.on_circle, contact_point<Deep>(line, Angle{turns}));
  }
}

TEST_CASE("the arc travelled leads back to the angle", "[divisions]") {
  const Arithmetic<Deep> scope(256);
  const Rational r(1, 2);
  // Arcs 4 r (1 - cos φ/2) that are rational.
  for (const auto& [turns, s] : {std::pair{Rational(1, 3), Rational(1)}, std::pair{Rational(1, 2), Rational(2)},
                                 std::pair{Rational(2, 3), Rational(3)}, std::pair{Rational(4, 3), Rational(5)}}) {
    const CycloidArc arc{r, s};
    const Rolling wheel{.how = Rolls::circle_on_line, .r = r, .d = r};
    agree(turned_angle<Deep>(arc), radians<Deep>(Angle{turns}));
    const auto by_arc = rolling_instant<Deep>(arc, Deep(30)),
               by_angle = rolling_instant<Deep>(wheel, Angle{turns}, Deep(30), Deep(0));
    agree(by_arc.M, by_angle.M);
    agree(by_arc.radius_of_curvature(), by_angle.radius_of_curvature());
  }
}

TEST_CASE("cusps by the arc travelled are exact in every number", "[divisions]") {
  const Rational r(1, 7);
  for (int k = 0; k < 4; ++k) {
    const CycloidArc arc{r, Rational(8 * k) * r};
    CHECK(arc.is_at_cusp());
    CHECK(arc.arches() == k);
    const Arithmetic<Bounded> scope;
    const auto at = rolling_instant<Bounded>(arc, Bounded(3));
    CHECK(sign(at.speed()) == Sign::zero);
    CHECK(sign(at.radius_of_curvature()) == Sign::zero);
    const auto sides = at.tangential_component();
    CHECK(enclosure(sides.before).upper == -enclosure(sides.after).lower);
    CHECK(enclosure(sides.after).lower > 0);
    const analytic::CycloidByArc<Bounded> second(r, Rational(8 * k) * r, Bounded(3));
    CHECK(sign(second.speed()) == Sign::zero);
    CHECK(sign(second.radius_of_curvature()) == Sign::zero);
  }
  CHECK_FALSE(CycloidArc{r, Rational(8) * r + Rational(1, 1000000)}.is_at_cusp());
  const CycloidArc past_the_top{r, Rational(5) * r};
  CHECK(past_the_top.to_top() < 0);
}
