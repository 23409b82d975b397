// Two intervals side by side against Bounded, bit for bit, and against rationals, which round nothing.
#include "bench/sweeping/two_bounded.h"
#include "bench/sweeping/uniform_turns.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

#include <cfenv>

using namespace epure::geometry;
using namespace epure::tests;

namespace {

constexpr int trials = 50000;

double any_double(Random& random) {
  const int kind = random.up_to(12);
  if (kind == 0) return 0;
  if (kind == 1) return random.up_to(7) - 3;
  const int most = kind == 2 ? 500 : kind == 3 ? 1000 : 30;  // squares overflow, and quotients; the small ones vanish
  return std::ldexp(random.fraction().to_double(), random.up_to(2 * most) - most);
}

Bounded any_interval(Random& random) {
  const double a = any_double(random), b = any_double(random);
  switch (random.up_to(3)) {
    case 0:
      return {a, a};
    case 1:
      return Bounded(a, a) + Bounded(-std::abs(a), std::abs(a)) * Bounded(0x1p-50);
    default:
      return {std::min(a, b), std::max(a, b)};
  }
}

bool is_same(const Bounded& a, const Bounded& b) { return a.inf() == b.inf() && a.sup() == b.sup(); }

// Called where the compiler cannot know what is called: so it is done, and done before the flags are asked. (A result
// that nobody reads would else not be computed at all, noinline or not.)
using Opaque = TwoBounded (*)(const TwoBounded&, const TwoBounded&);

constexpr int watched = FE_INVALID | FE_OVERFLOW;

// Wherever the processor has not raised the flag of an overflow or a NaN.
template <class Operation>
void agrees_with_bounded(const Operation& operation) {
  const Arithmetic<Bounded> scope;
  const volatile Opaque carry_out = operation;
  Random random(seed());
  int compared = 0, spoilt = 0;
  for (int i = 0; i < trials; ++i) {
    const Bounded a0 = any_interval(random), a1 = any_interval(random), b0 = any_interval(random),
                  b1 = any_interval(random);
    std::feclearexcept(watched);
    TwoBounded both;
    try {
      both = carry_out(TwoBounded(a0, a1), TwoBounded(b0, b1));
    } catch (const Undecided&) {
      CHECK_THROWS_AS((operation(a0, b0), operation(a1, b1)), Undecided);
      continue;
    }
    if (std::fetestexcept(watched) != 0) {
      ++spoilt;
      continue;
    }
    ++compared;
    INFO("seed " << seed() << ", trial " << i);
    REQUIRE(is_same(both.lane(0), operation(a0, b0)));
    REQUIRE(is_same(both.lane(1), operation(a1, b1)));
  }
  std::feclearexcept(FE_ALL_EXCEPT);
  CHECK(compared > trials / 2);
  CHECK(spoilt < trials / 4);
}

// A point of x that is a double: its own ends among them.
Rational inside(const Bounded& x, Random& random) {
  const Rational share = abs(random.fraction());
  return Rational(x.inf()) + share * (Rational(x.sup()) - Rational(x.inf()));
}
bool contains(const Bounded& x, const Rational& value) {
  return (std::isinf(x.inf()) || Rational(x.inf()) <= value) && (std::isinf(x.sup()) || value <= Rational(x.sup()));
}

}  // namespace

TEST_CASE("Two bounded: the same enclosures as Bounded") {
  agrees_with_bounded([](const auto& a, const auto& b) { return a + b; });
  agrees_with_bounded([](const auto& a, const auto& b) { return a - b; });
  agrees_with_bounded([](const auto& a, const auto& b) { return a * b; });
  agrees_with_bounded([](const auto& a, const auto& b) { return quotient(a, b); });
  agrees_with_bounded([](const auto& a, const auto&) { return square(a); });
  agrees_with_bounded([](const auto& a, const auto&) { return -a; });
  agrees_with_bounded([](const auto& a, const auto&) { return root(square(a)); });
}

TEST_CASE("Two bounded: what rationals give lies inside") {
  const Arithmetic<Bounded> scope;
  Random random(seed());
  for (int i = 0; i < 3000; ++i) {
    const Bounded a = any_interval(random), b = any_interval(random);
    const Rational x = inside(a, random), y = inside(b, random);
    const TwoBounded both_a(a, -a), both_b(b, b);
    INFO("seed " << seed() << ", trial " << i);
    REQUIRE(contains((both_a + both_b).lane(0), x + y));
    REQUIRE(contains((both_a - both_b).lane(1), -x - y));
    REQUIRE(contains((both_a * both_b).lane(0), x * y));
    REQUIRE(contains((both_a * both_b).lane(1), -x * y));
    REQUIRE(contains(square(both_a).lane(1), x * x));
    if (sign(b) != Sign::positive && sign(b) != Sign::negative) continue;
    REQUIRE(contains(quotient(both_a, both_b).lane(0), x / y));
    REQUIRE(contains(quotient(both_a, both_b).lane(1), -x / y));
    const Bounded found = root(TwoBounded(b * b, b * b)).lane(0);
    REQUIRE(contains(found * found, y * y));
    REQUIRE(contains(found, abs(y)));
  }
}

TEST_CASE("Two bounded: a sign is decided when both lanes have it") {
  const Arithmetic<Bounded> scope;
  const Bounded plus(1, 2), minus(-2, -1), across(-1, 1), zero(0);
  CHECK(sign(TwoBounded(plus, plus)) == Sign::positive);
  CHECK(sign(TwoBounded(minus, minus)) == Sign::negative);
  CHECK(sign(TwoBounded(zero, -zero)) == Sign::zero);
  for (const Bounded& other : {minus, across, zero, Bounded(0, 1)}) {
    CHECK(sign(TwoBounded(plus, other)) == Sign::undecided);
    CHECK(sign(TwoBounded(other, plus)) == Sign::undecided);
  }
  CHECK(sign(TwoBounded(Bounded(-1, 0), minus)) == Sign::undecided);
  CHECK(is_same(quotient(TwoBounded(plus, plus), TwoBounded(plus, minus)).lane(1), plus / minus));
  CHECK_THROWS_AS(quotient(TwoBounded(plus, plus), TwoBounded(plus, across)), Undecided);
  CHECK_THROWS_AS(quotient(TwoBounded(plus, plus), TwoBounded(zero, plus)), Undecided);
}

TEST_CASE("Two bounded: a NaN or an overflow raises the processor's flag") {
  const Arithmetic<Bounded> scope;
  const double infinity = std::numeric_limits<double>::infinity();
  const TwoBounded beyond(Bounded(1, infinity)), point(0), large(Bounded(1e200));
  const auto raises = [](int flag, Opaque operation, const TwoBounded& a, const TwoBounded& b) {
    const volatile Opaque carry_out = operation;
    std::feclearexcept(FE_ALL_EXCEPT);
    carry_out(a, b);
    const bool is_raised = std::fetestexcept(flag) != 0;
    std::feclearexcept(FE_ALL_EXCEPT);
    return is_raised;
  };
  const Opaque product = [](const TwoBounded& a, const TwoBounded& b) { return a * b; };
  CHECK(raises(FE_INVALID, product, beyond, point));
  CHECK(raises(FE_INVALID, product, point, beyond));
  CHECK(raises(FE_INVALID, product, -beyond, point));
  CHECK(raises(FE_OVERFLOW, product, large, large));
  CHECK(raises(FE_OVERFLOW, product, -large, large));
  CHECK(raises(
      FE_OVERFLOW, [](const TwoBounded& a, const TwoBounded&) { return square(a); }, large, large));
  CHECK_FALSE(raises(FE_INVALID | FE_OVERFLOW, product, large, point));
}

// Entries are at most 2 ulp of 2^-53 wide, the four of them weigh |cos| + |sin| <= √2 twice: 6.3e-16. The two
// products are rounded by 2^-52 of their sizes, which make 1 together, at both ends: 4.5e-16; their sum by
// 2^-53: 2.3e-16.
TEST_CASE("Uniform turns: every direction of n is enclosed, to within 1.3e-15") {
  for (const int n : {1, 2, 3, 7, 24, 360, 1009, 10007}) {
    const UniformTurns turns(static_cast<std::size_t>(n));
    REQUIRE(turns.rows() * turns.width() >= static_cast<std::size_t>(n));
    const Arithmetic<Bounded> rounding;
    const Arithmetic<Deep> precision(128);
    for (int k = 0; k<n; k += n> 5000 ? 97 : 1) {
      const auto place = static_cast<std::size_t>(k);
      const auto found = turns(place / turns.width(), place % turns.width() / 2);
      const auto holds = [&](const TwoBounded& x, const Deep& value) {
        const Bounded lane = x.lane(k % 2);
        return sign(value - Deep::from_double(lane.inf())) != Sign::negative &&
               sign(Deep::from_double(lane.sup()) - value) != Sign::negative && lane.sup() - lane.inf() <= 1.3e-15;
      };
      INFO(k << "/" << n);
      REQUIRE(holds(found.cosine, cosine<Deep>(Turn{Rational(k, n)})));
      REQUIRE(holds(found.sine, sine<Deep>(Turn{Rational(k, n)})));
    }
  }
}
