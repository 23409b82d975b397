// The bar on a translating body: its numbers are those of a corpus that knows positions only; the source's numbers.
#include "tests/exercises/velocity-centre/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("velocity centre: what is promised is reported", "[velocity-centre]") {
  const CheckedExercise result = bar().checked({});
  CHECK(result.passed());
  for (const char* name : {"A_x", "A_y", "P0_x", "P0_y"}) CHECK(find(result, name).spec.unit == "m");
  for (const char* name : {"v_A_x", "v_A_y", "v_A"}) CHECK(find(result, name).spec.unit == "m/s");
  for (const char* name : {"a_A_x", "a_A_y", "a_A"}) CHECK(find(result, name).spec.unit == "m/s^2");
}

TEST_CASE("velocity centre: values are the corpus', to the last bit of a double, by every route",
          "[velocity-centre]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/carried_bar.txt");
  CHECK(corpus.size() == 20);
  holds_against(bar(), corpus);
}

TEST_CASE("velocity centre: the source's numbers are all right within their digits", "[velocity-centre]") {
  const CheckedExercise result = bar().checked({});
  int judged = 0;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      CHECK(verdict.verdict == Verdict::rounding);
      ++judged;
    }
  CHECK(judged == 8);
  // No verdict on other givens.
  for (const CheckedQuantity& quantity : bar().checked({"V=11"}).quantities) CHECK(quantity.printed.empty());
}

TEST_CASE("velocity centre: why there is none", "[velocity-centre]") {
  for (const char* name : {"P0_x", "P0_y", "P0O", "P0A"}) {
    is_absent(bar(), {"omega=0"}, name, "the bar translates");
    is_absent(bar(), {"omega=0", "V=0"}, name, "the bar rests");
    is_absent(bar(), {"omega=0", "V=0", "omega_dot=0", "a=0"}, name, "the bar rests");
  }
  for (const char* name : {"K_x", "K_y", "KO", "KA"}) {
    is_absent(bar(), {"omega=0", "omega_dot=0"}, name, "at infinity");
    is_absent(bar(), {"omega=0", "omega_dot=0", "a=0"}, name, "no point is accelerated");
  }
  is_absent(bar(), {"omega=0", "omega_dot=0"}, "gamma_deg", "no value");
  for (const char* angle : {"angle=90", "angle=-90", "angle=450"})
    is_absent(bar(), {angle}, "normal_slope", "no slope");
  CHECK(value(bar().checked({"omega=0"}), "KO") == 1.5);  // a = KO dω/dt
}

TEST_CASE("velocity centre: lengths in millimetres, angles in turns", "[velocity-centre]") {
  const CheckedExercise result = bar().checked({"L=800mm", "angle=1/8turn"});
  CHECK(result.givens.as_stated());
}

TEST_CASE("velocity centre: speeds are as the distances from it", "[velocity-centre]") {
  for (const Assignments& assignments :
       {Assignments{}, {"angle=200"}, {"angle=90"}, {"V=0"}, {"omega=-1/7", "L=3"}, {"angle=0"}}) {
    const CheckedExercise result = bar().checked(assignments);
    CAPTURE(assignments);
    CHECK(value(result, "v_A") * value(result, "P0O") == Approx(value(result, "v_O") * value(result, "P0A")));
  }
}
