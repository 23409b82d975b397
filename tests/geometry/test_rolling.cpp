// Rolling circles and lines: positions against the textbook's equations, exact at special angles; instants at cusps;
// angles of turns and radians.
#include "geometry/curves/roulettes.h"
#include "tests/geometry/every_number.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

using namespace epure::geometry;
using namespace epure::tests;

namespace {

const Rolling cycloid{Rolls::circle_on_line, 1, 0, 1};
const Angle third_of_a_turn{Rational(1, 3)};

}  // namespace

TEMPLATE_TEST_CASE("rolling: the cycloid at a third of a turn and at its cusp", "[rolling]", Fast, Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const auto at = rolling_instant<T>(cycloid, third_of_a_turn, T(2), T(0));
  // P0M = (-sin φ, 1 - cos φ) = (-√3/2, 3/2); ω clockwise 2: v = -2 k x P0M = (3, √3).
  const T root3 = root(T(3));
  CHECK(is(at.M, {-number<T>(1, 2) * root3, number<T>(3, 2)}));
  CHECK(is(at.velocity(), {T(3), root3}));
  // a = ω² r towards the centre: 4 (sin φ, cos φ).
  CHECK(is(at.acceleration(), {T(2) * root3, T(-2)}));
  // ρ = 2 P0M, on the other side of the line.
  CHECK(is(at.radius_of_curvature(), T(2) * root3));
  CHECK(is(finite(at.centre_of_curvature()), {number<T>(1, 2) * root3, number<T>(-3, 2)}));
  const auto cusp = rolling_instant<T>(cycloid, Angle{3}, T(2), T(5));
  CHECK(cusp.is_at_cusp);
  CHECK(sign(cusp.velocity().x) == Sign::zero);
  CHECK(sign(cusp.velocity().y) == Sign::zero);
  CHECK(is(cusp.tangential_component().before, T(-4)));
  CHECK(is(cusp.tangential_component().after, T(4)));
  CHECK(sign(cusp.radius_of_curvature()) == Sign::zero);
  CHECK(is(arc_length<T>(cycloid, Angle{3}), T(24)));
  CHECK(is(arc_length<T>(cycloid, third_of_a_turn), T(2)));
}

TEST_CASE("angles: decided by what they are, not by their digits", "[angle]") {
  CHECK(sign_of({}) == 0);
  CHECK(sign_of({Rational(-1, 2), 3}) == -1);
  CHECK(sign_of({Rational(-1, 2), Rational(22, 7)}) == 1);  // π < 22/7
  // π by 40 digits, cut off and rounded up: https://oeis.org/A000796
  const Rational below = exact_decimal("3.141592653589793238462643383279502884197"), last = exact_decimal("1e-39");
  CHECK(sign_of({Rational(-1, 2), below}) == -1);
  CHECK(sign_of({Rational(-1, 2), below + last}) == 1);
  CHECK(whole_turns({Rational(7, 2)}) == 3);
  CHECK(whole_turns({-2}) == -2);
  CHECK(whole_turns({Rational(-1, 9)}) == -1);
  CHECK(whole_turns({5, 2 * below}) == 5);
  CHECK(whole_turns({5, 2 * (below + last)}) == 6);
  CHECK(whole_turns({0, -1000000}) == -159155);  // 1e6/2π = 159154.94...
  CHECK_FALSE(is_whole_turns({1, Rational(1, 1000)}));
}

TEST_CASE("angles: sines and cosines of turns and radians together", "[angle]") {
  const Arithmetic<Deep> deep(200);
  const Angle eighths{Rational(37, 8), Rational(1, 1000)}, sevenths{Rational(-3, 7), Rational(5, 3)};
  // mpmath, 40 digits.
  CHECK(overlaps(sine<Deep>(eighths), exact_decimal("-0.7078135342965218171278488016463049958914")));
  CHECK(overlaps(cosine<Deep>(sevenths), exact_decimal("0.5181352633428229415932744643060372272851")));
  const Arithmetic<Bounded> bounded;
  CHECK(overlaps(enclosure(sine<Bounded>(eighths)), exact_decimal("-0.7078135342965218171278488016463049958914")));
  CHECK(overlaps(enclosure(cosine<Bounded>(sevenths)), exact_decimal("0.5181352633428229415932744643060372272851")));
  // Beside a whole number of half turns a sine is as small as what is left over, to the last digit of a double.
  CHECK(sine<Fast>(Angle{Rational(13, 2), exact_decimal("1e-30")}) == -1e-30);
  CHECK(cosine<Fast>(Angle{Rational(-1, 4), exact_decimal("1e-30")}) == 1e-30);
  // (2π - 1) 1e-30 short of half a turn, mpmath.
  const Angle short_of_half{Rational(1, 2) - exact_decimal("1e-30"), exact_decimal("1e-30")};
  CHECK(std::fabs(sine<Fast>(short_of_half) - 5.2831853071795864769e-30) <= 4 * 0x1p-53 * 6e-30);
  const Arithmetic<Exact> exact;
  CHECK_THROWS_AS(sine<Exact>(eighths), LeavesTheTower);
  CHECK(is(radians<Exact>({0, 2}), Exact(2)));
  const Arithmetic<Calcium> calcium;
  CHECK_THROWS_AS(cosine<Calcium>(eighths), Undecided);
}

TEST_CASE("rolling: cusps lie where the rim touches down, ends included", "[rolling]") {
  const auto turns_of = [](const std::vector<Angle>& found) {
    std::vector<Rational> turns;
    for (const Angle& at : found) {
      CHECK(at.radians == 0);
      turns.push_back(at.turns);
    }
    return turns;
  };
  CHECK(turns_of(cusps(cycloid, {-1}, {2})) == std::vector<Rational>{-1, 0, 1, 2});
  CHECK(turns_of(cusps(cycloid, {-1, Rational(1, 1000000)}, {0, Rational(44, 7)})) == std::vector<Rational>{0, 1});
  CHECK(turns_of(cusps(cycloid, {0, 1}, {0, Rational(6283, 1000)})).empty());
  // An astroid's circle has turned by three quarters between cusps, a nephroid's by a turn and a half.
  CHECK(turns_of(cusps({Rolls::circle_inside_circle, 1, 4, 1}, {}, {3})) ==
        std::vector<Rational>{0, Rational(3, 4), Rational(3, 2), Rational(9, 4), 3});
  CHECK(turns_of(cusps({Rolls::circle_outside_circle, 1, 2, 1}, {}, {3})) ==
        std::vector<Rational>{0, Rational(3, 2), 3});
  CHECK(turns_of(cusps({Rolls::line_on_circle, 0, 1, 0}, {-1}, {2})) == std::vector<Rational>{0});
  CHECK(turns_of(cusps({Rolls::line_on_circle, 0, 1, 0}, {1}, {2})).empty());
  CHECK(cusps({Rolls::circle_on_line, 1, 0, Rational(999999999, 1000000000)}, {-1}, {2}).empty());
  for (const Angle& at : cusps({Rolls::circle_inside_circle, 3, 7, 3}, {-5}, {5}))
    CHECK(is_at_cusp({Rolls::circle_inside_circle, 3, 7, 3}, at));
}

TEMPLATE_TEST_CASE("rolling: in a ring twice as large the rim runs on a diameter", "[rolling]", Fast, Bounded, Deep,
                   Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  const Rolling la_hire{Rolls::circle_inside_circle, 1, 2, 1};
  for (const int twelfths : {1, 2, 3, 6, 8, -5}) {
    const Angle phi{Rational(twelfths, 12)};
    CHECK(is(tracing_point<T>(la_hire, phi), {T(2) * cosine<T>(phi), T(0)}));
    const auto at = rolling_instant<T>(la_hire, phi, T(1), T(0));
    CHECK(sign(at.centre_of_curvature().w) == Sign::zero);
    CHECK(is(at.normal_component(), T(0)));
    CHECK_THROWS_AS(at.radius_of_curvature(), Impossible);
  }
}

TEMPLATE_TEST_CASE("rolling: the plane's motion is that of its contact, centre and point", "[rolling]", Fast, Bounded,
                   Deep, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  for (const Rolling& g : {cycloid, Rolling{Rolls::circle_outside_circle, 1, 3, Rational(1, 2)},
                           Rolling{Rolls::circle_inside_circle, 1, 3, 2}, Rolling{Rolls::line_on_circle, 0, 2, 1}}) {
    const PlaneMotion<T> motion = rolling_motion<T>(g, third_of_a_turn, T(2), T(-1));
    const auto at = rolling_instant<T>(g, third_of_a_turn, T(2), T(-1));
    const Point<T> P0 = contact_point<T>(g, third_of_a_turn), M = tracing_point<T>(g, third_of_a_turn);
    CHECK(is(finite(motion.pole()), P0));
    CHECK(is(finite(motion.inflection_pole()), P0 + (at.J - at.motion.A)));
    CHECK(is(motion.velocity(M), at.velocity()));
    CHECK(is(motion.acceleration(M), at.acceleration(), 100));
    CHECK(is(at.normal_acceleration() + at.tangential_acceleration(), at.acceleration(), 100));
    CHECK(is(finite(motion.centre_of_curvature(M)), P0 + (finite(at.centre_of_curvature()) - at.motion.A), 100));
    CHECK(is(cross(at.M_prime() - at.motion.A, at.M - at.motion.A), T(0)));
  }
}

TEST_CASE("rolling: drawn over an interval of angles to the tolerance, cusps included", "[rolling]") {
  for (const Rolling& g : {cycloid, Rolling{Rolls::circle_outside_circle, 1, 3, 1},
                           Rolling{Rolls::circle_inside_circle, 1, 4, 1}, Rolling{Rolls::line_on_circle, 0, 2, 0}}) {
    const SpanTrace traced = trace_span(Roulette{g}, -1, 13, 1e-6);
    CHECK(traced.deviation <= 1e-6);
    const Point<Fast> first = tracing_point<Fast>(g, Angle{0, -1}), last = tracing_point<Fast>(g, Angle{0, 13});
    CHECK(is({traced.arcs.front().start.x, traced.arcs.front().start.y}, first));
    CHECK(is({traced.arcs.back().end.x, traced.arcs.back().end.y}, last));
  }
}

TEST_CASE("rolling: a path from an instant on keeps its digits, far from the fixed centre and after many turns",
          "[rolling]") {
  // M from the contact of φ, when the body has turned on by `since`: the textbook's equations in mpmath, 80 digits.
  struct Case {
    Rolling g;
    Angle phi;
    double since;
    const char *x, *y;
  };
  const Rational tiny = exact_decimal("1e-12"), huge = exact_decimal("1e12");
  for (const Case& c : {Case{{Rolls::circle_inside_circle, 1, 1 + tiny, 1},
                             {Rational(4, 9)},
                             0x1p-40,
                             "-2.184001206467279455990219e-13",
                             "-0.684040286651356390267207"},
                        Case{{Rolls::circle_outside_circle, tiny, huge, tiny},
                             {Rational(1, 9)},
                             0.5,
                             "6.359015510678406868701999e-13",
                             "-4.313604669971749325561923e-13"},
                        Case{{Rolls::circle_on_line, Rational(3, 20), 0, Rational(1, 10)},
                             {0, huge},
                             0.5,
                             "0.0906972856816331191957854",
                             "0.05123970827185049338167625"},
                        Case{{Rolls::line_on_circle, 1, Rational(9, 20), Rational(1, 10)},
                             {0, huge},
                             -0.5,
                             "-412133398155.2724801467999",
                             "-180682213084.1309835915358"}}) {
    CAPTURE(c.x);
    const Rational x = exact_decimal(c.x), y = exact_decimal(c.y);
    const Rational size = std::max(abs(x), abs(y)), off_by = size * exact_decimal("1e-15");
    const Point<Fast> fast = RouletteSince<Fast>(c.g, c.phi)(c.since);
    CHECK(abs(Rational(fast.x) - x) < off_by);
    CHECK(abs(Rational(fast.y) - y) < off_by);
    const Arithmetic<Bounded> scope;
    const Point<Bounded> bounded = RouletteSince<Bounded>(c.g, c.phi)(Bounded(c.since));
    const Rational printed = size * exact_decimal("1e-24");
    CHECK(overlaps(enclosure(bounded.x), x, printed));
    CHECK(overlaps(enclosure(bounded.y), y, printed));
    CHECK(Rational(bounded.x.sup()) - Rational(bounded.x.inf()) < 10 * off_by);
    CHECK(Rational(bounded.y.sup()) - Rational(bounded.y.inf()) < 10 * off_by);
  }
}

TEST_CASE("rolling: the way is counted from arch to arch", "[rolling]") {
  const Arithmetic<Exact> scope;
  const auto way = [](const Rolling& g, const Angle& phi) { return arc_length<Exact>(g, phi); };
  CHECK(is(way(cycloid, {Rational(-5, 2)}), Exact(-20)));
  // 8 r (R + r)/R and 8 r (R - r)/R: a cardioid of 16 r, an astroid of 6 R all round.
  CHECK(is(way({Rolls::circle_outside_circle, 1, 1, 1}, {2}), Exact(16)));
  CHECK(is(way({Rolls::circle_inside_circle, 1, 4, 1}, {3}), Exact(24)));
  CHECK(is(way({Rolls::line_on_circle, 0, 3, 0}, {0, -2}), Exact(-6)));
  CHECK_THROWS_AS(way({Rolls::circle_on_line, 1, 0, 2}, {1}), LeavesTheTower);
}
