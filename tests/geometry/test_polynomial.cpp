// Real roots: each once, in order, however near to the next; to as many bits as asked; and rational where they are.
#include "geometry/numbers/polynomial.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

using namespace epure::geometry;
using epure::tests::exact_decimal;

namespace {

const Polynomial x = Polynomial::indeterminate();
Polynomial constant(const Rational& value) { return Polynomial(value); }

}  // namespace

TEST_CASE("polynomial: real roots once each, in ascending order, the rational ones as such", "[polynomial]") {
  const Polynomial third = Polynomial(3) * x - Polynomial(1);
  const auto roots = (third * third * (x * x - Polynomial(2)) * (x * x * Polynomial(3) + Polynomial(1))).real_roots();
  REQUIRE(roots.size() == 3);
  CHECK_FALSE(roots[0].rational());
  CHECK(roots[1].rational() == Rational(1, 3));
  CHECK_FALSE(roots[2].rational());
  const Arithmetic<Deep> bits(128);
  CHECK(sign(roots[0].value()) == Sign::negative);
  CHECK(sign(roots[2].value()) == Sign::positive);
  CHECK((x * x + Polynomial(1)).real_roots().empty());
  CHECK((x * x).real_roots().size() == 1);
  CHECK((x * x).real_roots()[0].rational() == Rational(0));
}

// 8x³ - 6x - 1 = 0: the cosines of 20°, 140° and 260°.
TEST_CASE("polynomial: a root to as many bits as asked", "[polynomial]") {
  const auto roots = (x * x * x * Polynomial(8) - x * Polynomial(6) - Polynomial(1)).real_roots();
  REQUIRE(roots.size() == 3);
  const std::vector<Turn> turns{{Rational(7, 18)}, {Rational(13, 18)}, {Rational(1, 18)}};
  for (const long bits : {128L, 512L, 4096L}) {
    const Arithmetic<Deep> scope(bits);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const Deep root = roots[i].value(), cosine_of = cosine<Deep>(turns[i]);
      CHECK(arb_overlaps(root.ball(), cosine_of.ball()));
      CHECK(arb_rel_accuracy_bits(root.ball()) > bits - 8);
    }
  }
}

TEST_CASE("polynomial: roots 2.8e-40 apart", "[polynomial]") {
  const Polynomial near = x - Polynomial(1);
  const auto irrational = (near * near - constant(exact_decimal("2e-80"))).real_roots();
  REQUIRE(irrational.size() == 2);
  const auto minus_one = []<class X>(const X& root) -> X { return root - X(1); };
  CHECK(irrational[0].sign_of(minus_one) == Sign::negative);
  CHECK(irrational[1].sign_of(minus_one) == Sign::positive);
  CHECK_FALSE(irrational[0].rational());
  const auto rational = (near * near - constant(exact_decimal("1e-80"))).real_roots();
  REQUIRE(rational.size() == 2);
  CHECK(rational[1].rational() == 1 + exact_decimal("1e-40"));
  const auto touching = (near * near + constant(exact_decimal("1e-80"))).real_roots();
  CHECK(touching.empty());
}

TEST_CASE("polynomial: what a root makes of a formula, in every number", "[polynomial]") {
  const auto twice = []<class X>(const X& root) -> X { return root + root; };
  const RealRoot irrational = (x * x - Polynomial(2)).real_roots()[1],
                 half = (x * Polynomial(2) - Polynomial(1)).real_roots()[0];
  CHECK(irrational.into<Fast>(twice) == Approx(2.828427124746190).epsilon(1e-15));
  {
    const Arithmetic<Bounded> scope;
    const Bounded around = irrational.into<Bounded>(twice);
    CHECK(around.inf() < around.sup());
    CHECK(around.sup() - around.inf() < 1e-15);
    CHECK(half.into<Bounded>(twice).is_point());
  }
  const Arithmetic<Exact> scope;
  CHECK(sign(half.into<Exact>(twice) - Exact(1)) == Sign::zero);
  CHECK_THROWS_AS(irrational.into<Exact>(twice), Undecided);
  CHECK(half.sign_of([]<class X>(const X& root) -> X { return root + root - X(1); }) == Sign::zero);
}
