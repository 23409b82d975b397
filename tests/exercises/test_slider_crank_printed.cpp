// The source's own numbers: what is rounding, what is reading, and mistakes that evaluate to what was printed.
#include "exercises/kit/proof/verdict.h"
#include "tests/exercises/slider_crank_cases.h"
#include "tests/support/catch.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Printed& printed(const std::string& id, const std::string& quantity, const std::string& text) {
  for (const Printed& each : exercise(id).about().printed())
    if (each.quantity == quantity && each.text == text) return each;
  throw std::logic_error("nothing like it is printed");
}

PrintedVerdict judged(const std::string& id, const Printed& number) {
  return judge(number, find(checked(id, {}), number.quantity)->settled);
}

}  // namespace

TEST_CASE("every printed number has its verdict, and a mistake gives its digits", "[slider-crank][printed]") {
  int explained = 0, rounding = 0, reading = 0, unexplained = 0;
  for (const std::string& id : {of_velocity, of_acceleration}) {
    const CheckedExercise result = checked(id, {});
    std::size_t count = 0;
    for (const CheckedQuantity& quantity : result.quantities)
      for (const PrintedVerdict& verdict : quantity.printed) {
        CAPTURE(id, quantity.spec.name, verdict.text);
        ++count;
        CHECK(verdict.explanation_holds);
        CHECK(verdict.difference_percent);
        rounding += verdict.verdict == Verdict::rounding ? 1 : 0;
        reading += verdict.verdict == Verdict::reading ? 1 : 0;
        if (verdict.verdict != Verdict::disagrees) continue;
        ++(verdict.explanation ? explained : unexplained);
      }
    CHECK(count == result.about.printed().size());
  }
  CHECK(explained >= 11);
  CHECK(unexplained == 0);
  CHECK(rounding >= 5);
  CHECK(reading >= 10);
}

// 37.7² · 0.20 = 284.258; 0.22²/1.65 = 0.02933; 0.33²/1.02 = 0.1068: by hand.
TEST_CASE("explanations are evaluated", "[slider-crank][printed]") {
  CHECK(printed(of_acceleration, "a_A", "284.26").explanation->evaluate() == Approx(284.258));
  CHECK(printed(of_acceleration, "rho_C", "0.03").explanation->evaluate() == Approx(0.0293333).epsilon(1e-5));
  CHECK(printed(of_acceleration, "rho_M", "0.11").explanation->evaluate() == Approx(0.1067647).epsilon(1e-5));
  // KA = 0.91741 m and P0C = 0.27841 m of the corpus, at 0.795.
  CHECK(printed(of_acceleration, "KA", "0.73").explanation->evaluate() == Approx(0.7293421).epsilon(1e-5));
  CHECK(printed(of_acceleration, "P0C", "0.22").explanation->evaluate() == Approx(0.2213372).epsilon(1e-5));
}

TEST_CASE("other digits get another verdict", "[slider-crank][printed]") {
  CHECK(judged(of_velocity, printed(of_velocity, "v_A", "7.54")).verdict == Verdict::rounding);
  Printed changed = printed(of_velocity, "v_A", "7.54");
  changed.text = "7.55";
  CHECK(judged(of_velocity, changed).verdict == Verdict::disagrees);

  CHECK(judged(of_velocity, printed(of_velocity, "v_B", "5.33")).verdict == Verdict::reading);
  changed = printed(of_velocity, "v_B", "5.33");
  changed.text = "6.33";
  CHECK(judged(of_velocity, changed).verdict == Verdict::disagrees);
  changed.text = "5.10";
  CHECK(judged(of_velocity, changed).verdict == Verdict::rounding);

  // A mistake that does not give the digits explains nothing.
  changed = printed(of_acceleration, "a_A", "284.26");
  CHECK(judged(of_acceleration, changed).explanation);
  changed.text = "284.36";
  const PrintedVerdict verdict = judged(of_acceleration, changed);
  CHECK(verdict.verdict == Verdict::disagrees);
  CHECK_FALSE(verdict.explanation_holds);
  CHECK_FALSE(verdict.explanation);
}
