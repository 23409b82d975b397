// Polodes and coupler curves by transport: exact statements about positions, derivatives included.
#include "geometry/curves/polodes.h"
#include "geometry/curves/taylor.h"
#include "geometry/curves/turn_arcs.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

namespace {

Exact exact(int numerator, int denominator = 1) { return from_rational<Exact>(Rational(numerator, denominator)); }
bool is_equal(const Exact& a, const Exact& b) { return sign(a - b) == Sign::zero; }

SliderCrankLoop<Exact> loop_of(int r_tenths, int l_tenths) { return {exact(r_tenths, 10), exact(l_tenths, 10)}; }

// The derivative by t of a locus on an arc of the turn.
template <class Locus>
Vector<Exact> derivative(const Locus& locus, int arc, const Exact& t) {
  using Tangent = Taylor<Exact, 1>;
  const Point<Tangent> P = finite(locus(direction_on_turn(arc, Tangent::parameter(t))));
  return {P.x.c[1], P.y.c[1]};
}

}  // namespace

TEST_CASE("polodes: they touch and move alike at the pole of the reference position", "[polodes]") {
  const int arc = GENERATE(0, 2, 3);
  const Arithmetic<Exact> scope;
  const Exact t = exact(1, 2);
  const auto loop = loop_of(2, 5);
  const auto reference = coupler_position(loop, direction_on_turn(arc, t));
  const Vector<Exact> on_fixed = derivative(FixedPolode<Exact>{loop}, arc, t);
  const Vector<Exact> on_moving = derivative(MovingPolode<Exact>{loop, reference}, arc, t);
  CHECK(sign(length_squared(on_fixed)) == Sign::positive);
  CHECK(is_equal(on_fixed.x, on_moving.x));
  CHECK(is_equal(on_fixed.y, on_moving.y));
}

TEST_CASE("polodes: they roll without slipping, the pole moves equally fast along both everywhere", "[polodes]") {
  const auto loops = GENERATE(std::pair{2, 5}, std::pair{5, 2});
  const int arc = loops.first < loops.second ? GENERATE(0, 1, 2) : 0;
  const int quarter = GENERATE(-3, -1, 2);
  const Arithmetic<Exact> scope;
  auto loop = loop_of(loops.first, loops.second);
  if (loops.first > loops.second) loop.driver = Driver::coupler;
  const auto reference = coupler_position(loop, direction_on_turn(0, exact(1, 2)));
  const Exact t = exact(quarter, 4);
  const Vector<Exact> on_fixed = derivative(FixedPolode<Exact>{loop}, arc, t);
  const Vector<Exact> on_moving = derivative(MovingPolode<Exact>{loop, reference}, arc, t);
  CHECK(is_equal(length_squared(on_fixed), length_squared(on_moving)));
}

TEST_CASE("polodes: the transported triangle is congruent and comes back, exactly", "[polodes]") {
  const int k = GENERATE(range(0, 12));
  const Arithmetic<Exact> scope;
  const auto loop = loop_of(2, 5);
  const auto crank = directions_of_divided_circle<Exact>(12)[static_cast<std::size_t>(k)];
  const auto reference = coupler_position(loop, Vector<Exact>{exact(15, 17), exact(8, 17)});
  const TransportedPosition<Exact> position(reference, coupler_position(loop, crank));
  const Point<Exact> C{exact(1, 3), exact(2, 7)}, moved = position.forth(C), back = position.back(moved);
  CHECK(is_equal(length_squared(position.here.B - position.here.A), exact(1, 4)));
  CHECK(is_equal(length_squared(moved - position.here.A), length_squared(C - reference.A)));
  CHECK(is_equal(length_squared(moved - position.here.B), length_squared(C - reference.B)));
  const Exact turning = cross(position.here.B - position.here.A, moved - position.here.A);
  CHECK(is_equal(turning, cross(reference.B - reference.A, C - reference.A)));
  CHECK(is_equal(back.x, C.x));
  CHECK(is_equal(back.y, C.y));
}

TEST_CASE("polodes: a mirrored crank mirrors the fixed polode and the coupler curve", "[polodes]") {
  const int quarter = GENERATE(-4, -3, 1, 2);
  const int arc = GENERATE(0, 2);
  const Arithmetic<Exact> scope;
  const auto loop = loop_of(2, 5);
  const auto mirrored = [](const Vector<Exact>& v) { return Vector<Exact>{v.x, -v.y}; };
  const Vector<Exact> crank = direction_on_turn(arc, exact(quarter, 4)), start{exact(15, 17), exact(8, 17)};
  const Point<Exact> C{exact(1, 3), exact(2, 7)}, C_mirrored{C.x, -C.y};
  const CouplerCurve<Exact> curve{loop, coupler_position(loop, start), C};
  const CouplerCurve<Exact> mirror_curve{loop, coupler_position(loop, mirrored(start)), C_mirrored};
  const auto check_mirrored = [](const ProjectivePoint<Exact>& P, const ProjectivePoint<Exact>& Q) {
    CHECK(is_equal(P.x * Q.w, Q.x * P.w));
    CHECK(is_equal(P.y * Q.w, -(Q.y * P.w)));
  };
  check_mirrored(FixedPolode<Exact>{loop}(crank), FixedPolode<Exact>{loop}(mirrored(crank)));
  check_mirrored(curve(crank), mirror_curve(mirrored(crank)));
}

TEST_CASE("polodes: with l = r they are Cardano's circles", "[polodes]") {
  const int quarter = GENERATE(-4, -3, 0, 1, 4);
  const Arithmetic<Exact> scope;
  const auto loop = loop_of(3, 3);
  const auto reference = coupler_position(loop, Vector<Exact>{exact(15, 17), exact(8, 17)});
  const Vector<Exact> crank = direction_on_turn(0, exact(quarter, 4));
  const Point<Exact> P = finite(FixedPolode<Exact>{loop}(crank));
  const Point<Exact> Q = finite(MovingPolode<Exact>{loop, reference}(crank));
  CHECK(is_equal(length_squared(P - Point<Exact>{exact(0), exact(0)}), exact(36, 100)));
  CHECK(is_equal(length_squared(Q - reference.A), exact(9, 100)));
}

TEST_CASE("polodes: ahead is the slider-crank of mechanisms, and a loop driven by its coupler has the same pole",
          "[polodes]") {
  const Arithmetic<Exact> scope;
  const auto loop = loop_of(5, 2);
  const Vector<Exact> coupler = direction_on_turn(0, exact(-1, 2));
  const auto driven = coupler_position({loop.r, loop.l, Driver::coupler, Along::ahead}, coupler);
  const Vector<Exact> crank = quotient(exact(1), loop.r) * (driven.A - Point<Exact>{exact(0), exact(0)});
  const auto position = coupler_position(loop, crank);
  const auto mechanism = slider_crank<Exact>({Rational(1, 2), Rational(1, 5), Rational(1, 5), Rational(1, 5)}, crank);
  CHECK(is_equal(position.A.x, driven.A.x));
  CHECK(is_equal(position.B.x, driven.B.x));
  CHECK(is_equal(position.B.x, mechanism.B.x));
  CHECK(is_equal(position.P0.y * driven.P0.w, driven.P0.y * position.P0.w));
  CHECK(is_equal(position.P0.y * mechanism.pole().w, mechanism.pole().y * position.P0.w));
}

// Any offset and direction of the guide, and a coupler that drives: the polodes still roll on each other, and the
// loop is the mechanism.
TEST_CASE("polodes: offset and inclined", "[polodes]") {
  const auto [r, l] = GENERATE(std::pair{2, 5}, std::pair{5, 2});
  const int quarter = GENERATE(-3, 1), e = GENERATE(-2, 1);
  const Arithmetic<Exact> scope;
  SliderCrankLoop<Exact> loop = loop_of(r, l);
  if (r > l) loop.driver = Driver::coupler;
  loop.e = exact(e, 10);
  loop.along = {exact(4, 5), exact(-3, 5)};
  const auto reference = coupler_position(loop, direction_on_turn(0, exact(1, 2)));
  const Exact t = exact(quarter, 4);
  const Vector<Exact> on_fixed = derivative(FixedPolode<Exact>{loop}, 0, t);
  const Vector<Exact> on_moving = derivative(MovingPolode<Exact>{loop, reference}, 0, t);
  CHECK(sign(length_squared(on_fixed)) == Sign::positive);
  CHECK(is_equal(length_squared(on_fixed), length_squared(on_moving)));

  const auto here = coupler_position(loop, direction_on_turn(0, t));
  const Vector<Exact> crank = quotient(exact(1), loop.r) * (here.A - Point<Exact>{exact(0), exact(0)});
  CHECK(is_equal(length_squared(crank), exact(1)));
  CHECK(is_equal(length_squared(here.B - here.A), square(loop.l)));
  CHECK(is_equal(dot(here.B - Point<Exact>{exact(0), exact(0)}, quarter_turn(loop.along)), loop.e));
  if (sign(dot(here.B - here.A, loop.along)) != Sign::positive) return;  // the mechanism has B ahead of A
  const SliderCrankLengths lengths{{r, 10}, {l, 10}, {l, 10}, {l, 10}, {e, 10}};
  const auto mechanism = slider_crank(lengths, crank, loop.along);
  CHECK(is_equal(here.B.x, mechanism.B.x));
  CHECK(is_equal(here.B.y, mechanism.B.y));
  CHECK(is_equal(here.P0.x * mechanism.pole().w, mechanism.pole().x * here.P0.w));
}
