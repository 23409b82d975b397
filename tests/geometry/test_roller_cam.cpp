// The eccentric cam with its roller: the equivalent mechanism moves as relative motion says, the dead centres are
// where the lift stands, and the least acceleration of the turn is the same by roots and by branch and bound.
#include <cmath>

#include "geometry/analytic/roller_cam_formulas.h"
#include "geometry/curves/follower_sweep.h"
#include "geometry/mechanisms/roller_cam.h"
#include "geometry/numbers/at_each_precision.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

using namespace epure::geometry;
using epure::tests::exact_decimal;

namespace {

const Rational r(3, 100), l(3, 20);

RollerCamLengths lengths(const Rational& e) { return {r, Rational(1, 10), Rational(1, 20), -e}; }

double lift(double of_r, double of_l, double e, double t) {
  const double d = e - of_r * std::cos(t);
  return of_r * std::sin(t) + std::sqrt(of_l * of_l - d * d);
}

}  // namespace

TEST_CASE("relative motion and the equivalent slider-crank give the follower one motion", "[roller-cam]") {
  const Vector<double> up{0, 1};
  for (const Rational& e : {Rational(0), Rational(243, 5000), Rational(-1, 10)})
    for (double t = 0.05; t < 6.28; t += 0.31) {
      const auto at = roller_cam<double>(lengths(e), {std::cos(t), std::sin(t)}, up);
      const auto one = relative_motion(at, 2.0), other = motion_by_equivalent(at, 2.0);
      CAPTURE(CGAL::to_double(e), t);
      CHECK(at.B.x == Approx(CGAL::to_double(e)).margin(1e-14));
      CHECK(one.v_B3.y == Approx(other.v_B3.y).margin(1e-12));
      CHECK(one.a_B3.y == Approx(other.a_B3.y).margin(1e-11));
      CHECK(one.coriolis.x == Approx(other.coriolis.x).margin(1e-12));
      CHECK(one.coriolis.y == Approx(other.coriolis.y).margin(1e-12));
      CHECK(one.tangential.x == Approx(other.tangential.x).margin(1e-11));
      const auto pole = finite(at.relative_pole());
      CHECK(pole.y == Approx(0).margin(1e-14));
      CHECK(one.v_B3.y == Approx(2 * pole.x).margin(1e-12));
      const auto contact = at.contact(lengths(e));
      CHECK(distance(at.A, contact) == Approx(0.1));
      CHECK(distance(at.B, contact) == Approx(0.05));
    }
}

TEST_CASE("at the dead centres the follower is highest and lowest", "[roller-cam]") {
  const Vector<double> up{0, 1};
  const auto high = roller_cam_at<double>(DeadCentre::farthest, lengths(Rational(1, 20)), up),
             low = roller_cam_at<double>(DeadCentre::nearest, lengths(Rational(1, 20)), up);
  CHECK(distance(high.A, high.B) == Approx(0.15));
  CHECK(distance(low.A, low.B) == Approx(0.15));
  CHECK(length(low.A - low.A0) == Approx(0.03));
  for (double t = 0; t < 6.28; t += 0.01) {
    const double y = lift(0.03, 0.15, 0.05, t);
    CHECK(y <= high.B.y + 1e-15);
    CHECK(y >= low.B.y - 1e-15);
  }
}

TEST_CASE("a cam turns fully while its axis stays within reach, decided exactly", "[roller-cam]") {
  Rational tiny(1);
  for (int i = 0; i < 30; ++i) tiny = tiny / 10;
  const Rational edge = l - r;
  CHECK(lengths(edge - tiny).turns_fully());
  CHECK_FALSE(lengths(edge).turns_fully());
  CHECK_FALSE(lengths(-edge).turns_fully());
  CHECK_FALSE(lengths(-edge - tiny).turns_fully());
}

TEST_CASE("the least acceleration of the turn is one, by roots and by branch and bound", "[roller-cam]") {
  struct Tried {
    Rational r, l, e;
  };
  for (const Tried& of :
       {Tried{r, l, Rational(243, 5000)}, Tried{r, l, Rational(-243, 5000)}, Tried{r, l, Rational(0)},
        Tried{Rational(7, 50), l, Rational(0)}, Tried{Rational(1, 10), l, Rational(1, 25)},
        Tried{Rational(1, 100000), l, Rational(1, 100)}, Tried{r, l, Rational(1199999, 10000000)}}) {
    const analytic::LeastFollowerAcceleration roots({of.r, of.l, of.e});
    const FollowerSweep sweep(of.r, of.l, of.e);
    const Arithmetic<Deep> scope(128);
    const Enclosure at = enclosure(roots.angle<Deep>()), swept_at = enclosure(sweep.angle<Deep>()),
                    least = enclosure(roots.least<Deep>()), swept = enclosure(sweep.least<Deep>());
    CAPTURE(at.value, least.value);
    CHECK(at.value == swept_at.value);
    CHECK(least.value == swept.value);
    // Nowhere on a grid less, by differences.
    const double R = CGAL::to_double(of.r), L = CGAL::to_double(of.l), E = CGAL::to_double(of.e), h = 1e-4;
    for (double t = 0; t < 6.2832; t += 0.002) {
      const double second = (lift(R, L, E, t + h) - 2 * lift(R, L, E, t) + lift(R, L, E, t - h)) / (h * h);
      if (second < least.value - 1e-6) FAIL(t << " " << second);
    }
  }
}

TEST_CASE("the least acceleration is found where the roller reaches its axis by next to nothing", "[roller-cam]") {
  for (const char* gap : {"1e-13", "1e-30"}) {
    CAPTURE(gap);
    for (const int side : {-1, 1}) {
      const Rational e = Rational(side) * (l - r - exact_decimal(gap));
      const Arithmetic<Deep> scope(128);
      const Enclosure swept = enclosure(FollowerSweep(r, l, e).least<Deep>()),
                      least = enclosure(analytic::LeastFollowerAcceleration({r, l, e}).least<Deep>());
      CHECK(swept.value == Approx(-0.0578668617673786));
      CHECK(swept.lower <= least.upper);
      CHECK(least.lower <= swept.upper);
    }
  }
}

TEST_CASE("what several formulas need is found once for each number of bits, and with as many", "[roller-cam]") {
  int times = 0;
  const auto third = at_each_precision([&times] {
    ++times;
    return Deep(1) / Deep(3);
  });
  const auto copy = third;
  const auto width = [](const Deep& x) { return arb_rel_accuracy_bits(x.ball()); };
  for (const long bits : {128L, 512L, 128L}) {
    const Arithmetic<Deep> scope(bits);
    CHECK(width(third()) >= bits - 2);
    CHECK(width(copy()) <= bits + 2);
  }
  CHECK(times == 2);
}
