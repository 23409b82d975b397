// Printed numbers judged by rule, and the numbers as they stand in print.
#include <cmath>
#include <limits>

#include "exercises/kit/proof/verdict.h"
#include "exercises/kit/statement/decimal.h"
#include "geometry/numbers/given.h"
#include "tests/exercises/fake.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

PrintedVerdict verdict(const std::string& text, double value, double reading = 0) {
  return judge({"v", text, "poles", reading}, certain(value));
}

}  // namespace

TEST_CASE("the last printed digit counts, also when it is a zero") {
  CHECK(verdict("6.5", 6.54).verdict == Verdict::rounding);
  CHECK(verdict("6.50", 6.54).verdict == Verdict::disagrees);
  CHECK(verdict("13", 13.49).verdict == Verdict::rounding);
  CHECK(verdict("13", 12.51).verdict == Verdict::rounding);
  CHECK(verdict("13", 13.51).verdict == Verdict::disagrees);
  CHECK(verdict("360", 364).verdict == Verdict::disagrees);
  CHECK(verdict("4.2e3", 4249).verdict == Verdict::rounding);
  CHECK(verdict("4.2e3", 4251).verdict == Verdict::disagrees);
}

TEST_CASE("a number printed with its unit and a power of ten is read in SI units") {
  CHECK(verdict("8.077×10^4 MPa", 8.07749e10).verdict == Verdict::rounding);
  CHECK(verdict("8.077×10^4 MPa", 8.07751e10).verdict == Verdict::disagrees);
  CHECK(verdict("1.042×10^5 mm^4", 1.0415001e-7).verdict == Verdict::rounding);
  CHECK(verdict("1.042×10^5 mm^4", 1.0414999e-7).verdict == Verdict::disagrees);
  CHECK(verdict("51.509 mm", 0.0515094).verdict == Verdict::rounding);
  CHECK(verdict("51.509 mm", 0.0515096).verdict == Verdict::disagrees);
  CHECK(verdict("-3.53×10^4 N·m", -35304).verdict == Verdict::rounding);
  CHECK(verdict("-3.53×10^4 N·m", 35304).verdict == Verdict::disagrees);
  CHECK(verdict("240 N·m", 240.4).verdict == Verdict::rounding);
  CHECK(verdict("7.5e-2 μm", 7.54e-8).verdict == Verdict::rounding);
  CHECK_THROWS_AS(verdict("4×10^x mm", 1), geometry::BadGiven);
}

TEST_CASE("half a unit is exact, where doubles would slip") {
  // 0.285 lies below the decimal 0.285 as a double, so 0.29 is more than half a unit away, by 1e-17.
  CHECK(verdict("0.29", 0.285).verdict == Verdict::disagrees);
  CHECK(verdict("0.28", 0.285).verdict == Verdict::rounding);
  CHECK(verdict("0.5", 0.25).verdict == Verdict::disagrees);
  CHECK(verdict("0.2", 0.25).verdict == Verdict::rounding);
  CHECK(verdict("0.3", 0.25).verdict == Verdict::rounding);  // a tie may go either way in print
}

TEST_CASE("a number without a sign is a magnitude, one with a sign is not") {
  CHECK(verdict("2.5", -2.5).verdict == Verdict::rounding);
  CHECK(verdict("-2.5", -2.5).verdict == Verdict::rounding);
  CHECK(verdict("-2.5", 2.5).verdict == Verdict::disagrees);
  CHECK(verdict("+2.5", -2.5).verdict == Verdict::disagrees);
}

TEST_CASE("a number read off a drawing may be off by the reading and half a unit") {
  CHECK(verdict("5.25", 5.34).verdict == Verdict::disagrees);
  CHECK(verdict("5.25", 5.34, 0.1).verdict == Verdict::reading);
  CHECK(verdict("5.25", 5.354, 0.1).verdict == Verdict::reading);
  CHECK(verdict("5.25", 5.356, 0.1).verdict == Verdict::disagrees);
  CHECK(verdict("5.25", 5.254, 0.1).verdict == Verdict::rounding);  // better than it had to be
}

TEST_CASE("the difference is in hundredths of the value's magnitude, positive when more was printed") {
  CHECK(verdict("5.5", 5).difference_percent.value() == Approx(10));
  CHECK(verdict("5.5", -5).difference_percent.value() == Approx(10));
  CHECK(verdict("4.5", -5).difference_percent.value() == Approx(-10));
  CHECK(verdict("0", 0).difference_percent.value() == 0);
  CHECK_FALSE(verdict("1", 0).difference_percent.has_value());
}

TEST_CASE("a printed number of a quantity that does not exist disagrees") {
  for (const auto& settled : {absent("the pole is at infinity"), undecided("whether")}) {
    const PrintedVerdict result = judge({"v", "1.5", "poles", 10}, settled);
    CHECK(result.verdict == Verdict::disagrees);
    CHECK_FALSE(result.difference_percent.has_value());
  }
}

TEST_CASE("an explanation is given only when its formula gives the printed digits") {
  const auto explained = [](const std::string& text, double mistake, double value) {
    return judge({"v", text, "poles", 0, Explanation{{"a slip", "una svista"}, [=] { return mistake; }}},
                 certain(value));
  };
  CHECK(explained("0.22", 0.2234, 0.278).explanation.value().english == "a slip");
  CHECK(explained("0.22", 0.2234, 0.278).explanation_holds);
  CHECK_FALSE(explained("0.22", 0.226, 0.278).explanation.has_value());
  CHECK_FALSE(explained("0.22", 0.226, 0.278).explanation_holds);
  CHECK_FALSE(explained("0.22", std::numeric_limits<double>::quiet_NaN(), 0.278).explanation_holds);
  // What agrees needs none, and none is evaluated.
  CHECK_FALSE(explained("0.28", 0.226, 0.278).explanation.has_value());
  CHECK(explained("0.28", 0.226, 0.278).explanation_holds);
}

TEST_CASE("a text is a value and half a unit of its last digit, in the unit asked for") {
  struct Example {
    std::string text, unit;
    Rational value, half_unit;
  };
  const std::vector<Example> examples = {{"5.25m/s", "m/s", Rational(21, 4), Rational(1, 200)},
                                         {"5.25", "m/s", Rational(21, 4), Rational(1, 200)},
                                         {" 250 mm ", "m", Rational(1, 4), Rational(1, 2000)},
                                         {"1/3", "m", Rational(1, 3), 0},
                                         {"1/3m", "m", Rational(1, 3), 0},
                                         {"-2.50e-1", "1", Rational(-1, 4), Rational(1, 2000)},
                                         {"1e+2", "1", 100, 50},
                                         {"0.52rad", "rad", Rational(13, 25), Rational(1, 200)},
                                         {"0.52", "rad", Rational(13, 25), Rational(1, 200)},
                                         {".5", "1", Rational(1, 2), Rational(1, 20)},
                                         {"0,52", "rad", Rational(13, 25), Rational(1, 200)},
                                         {"-1,50e1mm", "mm", -15, Rational(1, 20)},
                                         {"1,5/3", "m", Rational(1, 2), 0},
                                         {"30°", "deg", 30, Rational(1, 2)},
                                         {"5.", "1", 5, Rational(1, 2)}};
  for (const Example& example : examples) {
    INFO(example.text);
    const Decimal read = read_decimal(example.text, example.unit);
    CHECK(read.value == example.value);
    CHECK(read.half_unit == example.half_unit);
  }
  for (const std::string bad : {"", "rad", "nan", "1,5,5", "5 rad rad", "3s"}) {
    INFO(bad);
    CHECK_THROWS_AS(read_decimal(bad, "rad"), geometry::BadGiven);
  }
}
