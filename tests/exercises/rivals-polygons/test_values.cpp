// Rivals' theorem on the slider-crank: its numbers, certain and by two routes or three, are those of a corpus that
// knows positions only.
#include "tests/exercises/rivals-polygons/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("Rivals: what is promised is reported", "[rivals]") {
  const CheckedExercise result = rivals().checked({});
  CHECK(result.passed());
  for (const char* name : {"v_A", "v_B", "v_BA", "v_G_x", "v_G_y", "v_G"})
    CHECK(find(result, name).spec.unit == "m/s");
  for (const char* name : {"a_A_n", "a_BA_n", "a_BA_t", "a_B", "a_G_x", "a_G_y", "a_G"})
    CHECK(find(result, name).spec.unit == "m/s^2");
  CHECK(find(result, "omega_3").spec.unit == "rad/s");
  CHECK(find(result, "alpha_3").spec.unit == "rad/s^2");
}

TEST_CASE("Rivals: values are the corpus', to the last bit of a double, by every route", "[rivals]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/rivals.txt");
  CHECK(corpus.size() == 20);
  holds_against(rivals(), corpus);
}

// 307.8 and 525.0 are the corpus' stated case. With the crank square to the guide the coupler does not turn, so
// a_BA^n is nothing, and counting a_A twice doubles the polygon.
TEST_CASE("Rivals: with a_A counted twice the source's equation gives another a_B", "[rivals]") {
  const CheckedExercise result = rivals().checked({}), upright = rivals().checked({"phi=90"});
  CHECK(value(result, "a_B") == Approx(307.81056193));
  CHECK(value(result, "a_B_as_printed") == Approx(524.96301858));
  CHECK(value(upright, "a_B_as_printed") == 2 * value(upright, "a_B"));
}

TEST_CASE("Rivals: the impossible is a sentence with its values", "[rivals]") {
  const auto refusal = [](const Assignments& assignments) -> std::string {
    try {
      rivals().checked(assignments);
    } catch (const BadGivens& refused) {
      return refused.what();
    }
    return "not refused";
  };
  CHECK(refusal({"n=0"}).find("n must differ from 0") != std::string::npos);
  CHECK(refusal({"r=0.6", "phi=90"}).find("too short by 0.1 m") != std::string::npos);
  CHECK(refusal({"r=0.5", "phi=90"}).find("square to the guide") != std::string::npos);
  CHECK(refusal({"l=0"}).find("must be positive") != std::string::npos);
}

TEST_CASE("Rivals: G on A and on B moves as they do", "[rivals]") {
  const CheckedExercise at_A = rivals().checked({"AG=0"}), at_B = rivals().checked({"AG=1/2"});
  CHECK(value(at_A, "v_G") == value(at_A, "v_A"));
  CHECK(value(at_A, "a_G") == value(at_A, "a_A"));
  CHECK(value(at_A, "v_GA") == 0);
  CHECK(value(at_B, "v_G") == value(at_B, "v_B"));
  CHECK(value(at_B, "a_G_x") == value(at_B, "a_B_x"));
  CHECK(value(at_B, "a_G_y") == 0);
}
