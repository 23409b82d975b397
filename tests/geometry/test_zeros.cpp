// Zeros over a turn: none is missed, none is invented, and what cannot be decided is said to be open.
#include <algorithm>
#include <cmath>

#include "geometry/curves/zeros.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

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

template <class Function>
Zeros zeros(const Function& function) {
  return search_zeros(
      [&](int arc, const Bounded& t) { return function(direction_on_turn(arc, BoundedTangent::parameter(t))); },
      65536);
}

double degrees(const Vector<double>& d) { return std::atan2(d.y, d.x) * 180 / pi<Fast>(); }

std::vector<double> angles(const Zeros& found) {
  std::vector<double> all;
  for (const Zero& zero : found.found) {
    const double angle = degrees(direction_of({zero.arc, enclosure(zero.t).value}));
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
  CHECK(angles(level) == std::vector<double>{0, 180});

  // 4/5 and -4/5: exactly the directions in which the arcs meet.
  for (const Rational& c : {Rational(4, 5), Rational(-4, 5)}) {
    const Zeros corners = zeros(Height{c});
    CHECK(corners.open.empty());
    REQUIRE(corners.found.size() == 2);
  }

  const Zeros six = zeros(ThirdHarmonic{});
  REQUIRE(six.found.size() == 6);
  CHECK(six.open.empty());
  const std::vector<double> all = angles(six);
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
