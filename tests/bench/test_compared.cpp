// Errors and bounds as the bench reports them, on numbers whose errors can be told by hand.
#include "bench/measure_family.h"
#include "tests/support/catch.h"

namespace epure::tests {

using namespace bench;

TEST_CASE("an error is relative to the truth, and a bound is half the width") {
  const Arithmetic<Bounded> rounding;
  CHECK(compared(Fast(1.5), Rational(1)).error == 0.5);
  CHECK(compared(Fast(-1.5), Rational(-2)).error == 0.25);
  CHECK(!compared(Fast(1.5), Rational(1)).bound);
  const Compared wide = compared(Bounded(1, 3), Rational(4));
  CHECK(wide.value == 2);
  CHECK(wide.error == 0.5);
  CHECK(wide.bound == 0.25);
  CHECK(compared(Bounded(-3, -1), Rational(-2)).bound == 0.5);
}

// A bound too small by a factor of two would be seen here at once.
TEST_CASE("where the truth is an end of the enclosure the error is the bound") {
  const Arithmetic<Bounded> rounding;
  for (const int truth : {1, 3}) {
    const Compared at_the_end = compared(Bounded(1, 3), Rational(truth));
    CHECK(at_the_end.error == at_the_end.bound);
  }
  const Arithmetic<Deep> precision(64);
  const Deep one(1), eighth = from_rational<Deep>(Rational(1, 8));
  const Deep ball = one + Deep::from_bounded(Bounded(-0.125, 0.125));
  const Compared x = compared(ball, Rational(9, 8));
  CHECK(x.value == 1);
  CHECK(x.error == Approx(1.0 / 9));
  REQUIRE(x.bound);
  CHECK(*x.bound >= x.error);
  CHECK(*x.bound < 1.001 * x.error);
  CHECK(compared(one + eighth, Rational(9, 8)).error == 0);
}

TEST_CASE("an enclosure that misses the truth, a sign of a zero and a proof against what exists are wrong") {
  const Arithmetic<Bounded> rounding;
  const CorpusCase c{"case", "by hand", {}, {}, {{"one", "1"}, {"zero", "0"}, {"none", "absent"}}};
  const auto wrong = [&](const char* name, const Reading<Bounded>& reading) {
    Account account("family", "bounded");
    account.take(c, name, reading);
    return account.result().wrong;
  };
  CHECK(wrong("one", Reading<Bounded>::of(Bounded(0.5, 1))) == 0);
  CHECK(wrong("one", Reading<Bounded>::of(Bounded(0.5, 0.9))) == 1);
  CHECK(wrong("one", Reading<Bounded>::of(Bounded(5, 9))) == 1);
  CHECK(wrong("one", Reading<Bounded>::absent({"proved", "proved"})) == 1);
  CHECK(wrong("one", Reading<Bounded>::undecided({"open", "open"})) == 0);
  CHECK(wrong("zero", Reading<Bounded>::of(Bounded(-1, 1))) == 0);
  CHECK(wrong("zero", Reading<Bounded>::of(Bounded(0.5, 1))) == 1);
  CHECK(wrong("none", Reading<Bounded>::absent({"proved", "proved"})) == 0);
}

TEST_CASE("an enclosure without bounds is no error of the number's") {
  const Arithmetic<Bounded> rounding;
  CHECK(std::isinf(*compared(Bounded(-INFINITY, INFINITY), Rational(1)).bound));
  CHECK(std::isinf(compared(Fast(NAN), Rational(1)).error));
}

}  // namespace epure::tests
