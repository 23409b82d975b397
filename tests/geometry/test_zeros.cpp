// Zeros over a turn: none is missed, none is invented, each is enclosed to as many digits as asked, and what cannot
// be decided is said to be open.
#include <cmath>

#include "geometry/analytic/four_bar.h"
#include "geometry/curves/zeros.h"
#include "geometry/mechanisms/collineation_axis.h"
#include "geometry/numbers/given.h"
#include "tests/geometry/reference.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

using namespace epure::geometry;
using epure::tests::exact_decimal;
using epure::tests::narrow;
using epure::tests::overlaps;

namespace {

// y - c: the zeros are where the unit circle meets a horizontal.
struct Height {
  Rational c;
  template <class X>
  X operator()(const Vector<X>& d) const {
    return d.y - from_rational<X>(c);
  }
};

// cos 3φ = 4x³ - 3x.
struct ThirdHarmonic {
  template <class X>
  X operator()(const Vector<X>& d) const {
    return d.x * (X(4) * square(d.x) - X(3));
  }
};

// Only where x > 1/2, and zero at y = 0 there.
struct HalfBlind {
  template <class X>
  X operator()(const Vector<X>& d) const {
    const X above = d.x - from_rational<X>(Rational(1, 2));
    if (sign(above) == Sign::undecided) throw Undecided("whether it exists");
    if (sign(above) == Sign::negative) throw Impossible("not there");
    return d.y * root(above);
  }
};

// d²θ₄/dθ₂² of a four-bar with its frame on x, on one branch.
struct RockerAcceleration {
  analytic::FourBar linkage;
  analytic::Branch branch;
  template <class X>
  X operator()(const Vector<X>& d) const {
    const analytic::CrankState<X> crank{d.x, d.y, X(1), X(0)};
    return analytic::motion(linkage, crank, analytic::position(linkage, crank, branch)).alpha_4;
  }
};

double degrees(const Vector<double>& d) { return std::atan2(d.y, d.x) * 180 / pi<Fast>(); }

template <class Function>
std::vector<double> angles(const Function& function, const Zeros& found) {
  std::vector<double> all;
  for (const Zero& zero : found.found) {
    const double angle = degrees(direction_of<Fast>(function, zero));
    all.push_back(angle < 0 ? angle + 360 : angle);
  }
  std::sort(all.begin(), all.end());
  return all;
}

double total(const std::vector<Gap>& gaps) {
  double sum = 0;
  for (const Gap& gap : gaps) sum += gap.width;
  return sum;
}

}  // namespace

TEST_CASE("zeros: each once, also where pieces and arcs of the turn meet", "[zeros]") {
  const Zeros level = zeros(Height{0});
  CHECK(level.open.empty());
  CHECK(level.absent.empty());
  REQUIRE(level.found.size() == 2);
  CHECK(angles(Height{0}, level) == std::vector<double>{0, 180});

  // 4/5 and -4/5: exactly the directions in which the arcs meet.
  for (const Rational& c : {Rational(4, 5), Rational(-4, 5)}) {
    const Zeros corners = zeros(Height{c});
    CHECK(corners.open.empty());
    REQUIRE(corners.found.size() == 2);
  }

  const Zeros six = zeros(ThirdHarmonic{});
  REQUIRE(six.found.size() == 6);
  CHECK(six.open.empty());
  const std::vector<double> all = angles(ThirdHarmonic{}, six);
  for (std::size_t i = 0; i < 6; ++i) CHECK(all[i] == Approx(30 + 60.0 * static_cast<double>(i)).epsilon(1e-14));
}

TEST_CASE("zeros: none where there is none, open where it touches", "[zeros]") {
  const Zeros none = zeros(Height{Rational(1000001, 1000000)});
  CHECK(none.found.empty());
  CHECK(none.open.empty());
  const Zeros touching = zeros(Height{1});
  CHECK(touching.found.empty());
  REQUIRE(touching.open.size() == 1);
  CHECK(total(touching.open) < 1e-5);
  const Zeros nearly = zeros(Height{Rational(999999, 1000000)});
  CHECK(nearly.found.size() == 2);
  CHECK(nearly.open.empty());
  const Zeros everywhere = search_zeros([](int, const Bounded&) { return BoundedTangent(0); }, 1000);
  CHECK(everywhere.found.empty());
  CHECK(total(everywhere.open) == Approx(2 * pi<Fast>()));
}

TEST_CASE("zeros: where the function does not exist is absent, its ends are open", "[zeros]") {
  const Zeros found = zeros(HalfBlind{});
  REQUIRE(found.found.size() == 1);
  CHECK(found.found.front().t.do_overlap(Bounded(0)));
  // From 60° to 300° it is absent.
  CHECK(total(found.absent) == Approx(4 * pi<Fast>() / 3).epsilon(1e-9));
  CHECK(found.open.size() == 2);
  CHECK(total(found.open) < 1e-10);
}

// Python with mpmath, 60 digits: θ₂ of the extremes of dθ₄/dθ₂, found by bisection on the derivative of arg(B - B₀),
// B where the circles meet.
TEST_CASE("zeros: the extremes of a rocker's speed to 38 digits", "[zeros]") {
  struct Case {
    RockerAcceleration of;
    std::vector<std::string> degrees;
  };
  const analytic::FourBar exercise{Rational(1, 5), Rational(1, 2), Rational(7, 10), Rational(4, 5), 0};
  const analytic::FourBar drag_link{Rational(3, 5), Rational(1, 2), Rational(7, 10), Rational(1, 5), 0};
  const std::vector<Case> cases{
      {{exercise, analytic::Branch::left},
       {"131.4290478982002011381076585746057359693", "352.675953327130997404189746684831271682"}},
      {{exercise, analytic::Branch::right},
       {"7.324046672869002595810253315168728318043", "228.5709521017997988618923414253942640307"}},
      {{drag_link, analytic::Branch::left},
       {"219.5166380169491014326262862794859998876", "354.5210538784840179798333471795485201014"}}};
  for (const Case& c : cases) {
    const Zeros found = zeros(c.of);
    CHECK(found.open.empty());
    CHECK(found.absent.empty());
    REQUIRE(found.found.size() == c.degrees.size());
    const Arithmetic<Deep> bits(256);
    for (const std::string& text : c.degrees) {
      const Rational expected = exact_decimal(text);
      const bool is_met = std::any_of(found.found.begin(), found.found.end(), [&](const Zero& zero) {
        const Vector<Deep> d = direction_of<Deep>(c.of, zero);
        Deep angle = arc_tangent(d.y, d.x);
        if (sign(angle) == Sign::negative) angle += Deep(2) * pi<Deep>();
        const Deep in_degrees = angle * Deep(180) / pi<Deep>();
        return narrow(in_degrees) && overlaps(in_degrees, expected);
      });
      CAPTURE(text);
      CHECK(is_met);
    }
  }
}

// Near its change point a linkage asks for many looks; the proof must still come, and each rung must know more.
TEST_CASE("zeros: a linkage a thousandth from its change point, and more bits know more", "[zeros]") {
  const RockerAcceleration near{{Rational(1, 5), Rational(1, 2), Rational(7, 10), Rational(4005, 10000), 0},
                                analytic::Branch::left};
  const Zeros found = zeros(near);
  CHECK(found.open.empty());
  REQUIRE(!found.found.empty());
  CHECK(found.found.size() % 2 == 0);
  for (const Zero& zero : found.found) {
    std::vector<double> widths;
    for (const long bits : {128L, 256L, 512L}) {
      const Arithmetic<Deep> scope(bits);
      const Deep t = direction_of<Deep>(near, zero).y;
      widths.push_back(arb_rel_accuracy_bits(t.ball()) > bits - 40 ? 1 : 0);
    }
    CHECK(widths == std::vector<double>{1, 1, 1});
  }
}

// Frame and coupler of 1e8 m between cranks of 1 m drown the construction in doubles.
TEST_CASE("zeros: many bits find what doubles leave open", "[zeros]") {
  const Rational far(100000000);
  const CollineationAxisAcrossCoupler axis{{Rational(1), far + Rational(1, 2), Rational(2), far, Rational(0)},
                                           Side::left};
  const RockerAcceleration closure{{Rational(1), far + Rational(1, 2), Rational(2), far, 0}, analytic::Branch::left};
  const Zeros by_axis = zeros(axis), by_closure = zeros(closure);
  CHECK(by_axis.open.empty());
  CHECK(by_closure.open.empty());
  REQUIRE(by_axis.found.size() == by_closure.found.size());
  for (std::size_t i = 0; i < by_axis.found.size(); ++i) {
    CHECK(by_axis.found[i].arc == by_closure.found[i].arc);
    CHECK(by_axis.found[i].t.do_overlap(by_closure.found[i].t));
  }
}

// A = (1, 0), B = (1, 4), B0 = (4, 0): the coupler is square to the frame, on which the collineation axis lies.
TEST_CASE("zeros: one on an axis is proved to be there, and is then a direction for every number", "[zeros]") {
  const RockerAcceleration upright{{Rational(1), Rational(4), Rational(5), Rational(4), 0}, analytic::Branch::left};
  Zeros found = zeros(upright);
  REQUIRE(found.found.size() == 2);
  place_on_axes(upright, found);
  const auto on_axis = std::find_if(found.found.begin(), found.found.end(),
                                    [](const Zero& zero) { return zero.arc == 0 && zero.t.is_point(); });
  REQUIRE(on_axis != found.found.end());
  const Arithmetic<Exact> scope;
  const Vector<Exact> d = direction_of<Exact>(upright, *on_axis);
  CHECK(sign(d.y) == Sign::zero);
  CHECK(sign(d.x - Exact(1)) == Sign::zero);
  // Nearly on the axis is not on it.
  Zeros beside = zeros(Height{Rational(1, 1000000000) * Rational(1, 1000000000)});
  place_on_axes(Height{Rational(1, 1000000000) * Rational(1, 1000000000)}, beside);
  for (const Zero& zero : beside.found) CHECK_FALSE(zero.t.is_point());
}

TEST_CASE("zeros: exact numbers cannot construct them", "[zeros]") {
  const Zeros level = zeros(Height{Rational(1, 3)});
  const Arithmetic<Exact> scope;
  CHECK_THROWS_AS(direction_of<Exact>(Height{Rational(1, 3)}, level.found.front()), Undecided);
}
