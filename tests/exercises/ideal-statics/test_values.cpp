// Five mechanisms in equilibrium: their numbers are those of a corpus that knows positions and moments only; the
// source's numbers; what cannot be in equilibrium.

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
  const Judged prints = judged(result);
  CHECK(prints.rounding == 10);
  CHECK(prints.reading == 7);
  CHECK(prints.explained == 5);
  CHECK(prints.unexplained == 0);
}

TEST_CASE("ideal statics: what cannot be in equilibrium is said with value and condition", "[ideal-statics]") {
  for (const char* theta : {"wedge_collar.theta=0", "wedge_collar.theta=90", "wedge_collar.theta=-10"})
    is_refused(statics(), {theta}, "must lie between 0° and 90°");
  is_refused(statics(), {"wedge_collar.y_upper=0.035"}, "the collar has no length");
  is_refused(statics(), {"double_slider.theta=90"}, "Q stands without P");
  is_refused(statics(), {"sliding_levers.arm_P=0"}, "cannot turn it");
  is_refused(statics(), {"sliding_levers.nu=253"}, "would part in C");
  is_refused(statics(), {"sliding_levers.x_Q=0.35"}, "passes through the hinge");
  // The normal at 45° from (0.25, 0.1) runs into A0 or B0 exactly.
  is_refused(statics(), {"sliding_levers.nu=135", "sliding_levers.x_C=0.25", "sliding_levers.y_C=0.1"},
             "cannot hold it");
  is_refused(statics(), {"sliding_levers.nu=45", "sliding_levers.x_C=0.1", "sliding_levers.y_C=0.1"}, "without P");
  is_refused(statics(), {"fairbairn.AB=0.1754"}, "does not reach the lever, which passes A at 0.175438 m");
  is_refused(statics(), {"fairbairn.theta=90"}, "must lie between -90° and 90°");
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
