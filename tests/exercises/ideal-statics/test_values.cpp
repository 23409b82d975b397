// Five mechanisms in equilibrium: their numbers are those of a corpus that knows positions and moments only; the
// source's numbers; what cannot be in equilibrium.
#include <map>

#include "exercises/kit/linkages/loaded_mechanisms.h"
#include "tests/exercises/ideal-statics/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("ideal statics: values are the corpus', to the last bit of a double, by every route", "[ideal-statics]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/ideal_statics.txt");
  CHECK(corpus.size() == 17);
  holds_against(statics(), corpus);
}

TEST_CASE("ideal statics: the source's numbers", "[ideal-statics]") {
  const CheckedExercise result = statics().checked({});
  std::map<Verdict, int> verdicts;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      ++verdicts[verdict.verdict];
      CHECK(verdict.explanation_holds);
      CHECK(verdict.explanation.has_value() == (verdict.verdict == Verdict::disagrees));
    }
  CHECK(verdicts[Verdict::rounding] == 10);
  CHECK(verdicts[Verdict::reading] == 7);
  CHECK(verdicts[Verdict::disagrees] == 5);
}

TEST_CASE("ideal statics: what cannot be in equilibrium is said with value and condition", "[ideal-statics]") {
  const auto refused = [](const Assignments& assignments, const char* because) {
    CAPTURE(assignments);
    CHECK_THROWS_WITH(statics().checked(assignments), Contains(because));
  };
  for (const char* theta : {"wedge_collar.theta=0", "wedge_collar.theta=90", "wedge_collar.theta=-10"})
    refused({theta}, "must lie between 0° and 90°");
  refused({"wedge_collar.y_upper=0.035"}, "the collar has no length");
  refused({"double_slider.theta=90"}, "Q stands without P");
  refused({"sliding_levers.arm_P=0"}, "cannot turn it");
  refused({"sliding_levers.nu=253"}, "would part in C");
  refused({"sliding_levers.x_Q=0.35"}, "passes through the hinge");
  // The normal at 45° from (0.25, 0.1) runs into A0 or B0 exactly.
  refused({"sliding_levers.nu=135", "sliding_levers.x_C=0.25", "sliding_levers.y_C=0.1"}, "cannot hold it");
  refused({"sliding_levers.nu=45", "sliding_levers.x_C=0.1", "sliding_levers.y_C=0.1"}, "without P");
  refused({"fairbairn.AB=0.1754"}, "does not reach the lever, which passes A at 0.175438 m");
  refused({"fairbairn.theta=90"}, "must lie between -90° and 90°");
}

TEST_CASE("ideal statics: the limits missed by little are no limits", "[ideal-statics]") {
  for (const char* given : {"wedge_collar.theta=89.999999999", "wedge_collar.theta=0.000000001",
                            "sliding_levers.nu=73.000000001", "double_slider.theta=1e-9"}) {
    CAPTURE(given);
    CHECK(statics().checked({given}).passed());
  }
  // AB = AC sin 30° exactly: the crank touches the lever, square to it.
  const CheckedExercise touching = statics().checked({"fairbairn.theta=30", "fairbairn.AC=0.4"});
  CHECK(touching.passed());
  CHECK(value(touching, "fairbairn.M") == 0);
  CHECK_THROWS_WITH(statics().checked({"fairbairn.theta=30", "fairbairn.AC=0.400000000000000000000000000001"}),
                    Contains("does not reach"));
}
