// The Michell thrust bearing: its numbers are those of a corpus of integrals over ln h; the source's numbers and its
// table, row by row; bad givens.
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/michell-thrust/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("michell thrust: values are the corpus', to the last bit of a double, by every route", "[michell-thrust]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/michell_thrust.txt");
  CHECK(corpus.size() == 7);
  holds_against(thrust(), corpus);
}

TEST_CASE("michell thrust: the source's table is right but for the places of the load", "[michell-thrust]") {
  const CheckedExercise result = thrust().checked({});
  CHECK(result.passed());
  std::set<std::string> wrong, explained;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CHECK(verdict.explanation_holds);
      if (verdict.verdict == Verdict::disagrees) (verdict.explanation ? explained : wrong).insert(quantity.spec.name);
    }
  CHECK(wrong.empty());
  CHECK(explained == std::set<std::string>{"v", "l", "c", "N", "k", "h_2", "h_1", "alpha_deg", "c_prime",
                                           "table_n_1_6.x_N_over_l", "table_n_1_8.x_N_over_l",
                                           "table_n_1_8.A_n_minus_1_squared", "table_n_2_0.x_N_over_l",
                                           "table_n_2_2.x_N_over_l", "table_n_3_0.x_N_over_l"});
}

// Below ten times it is told in whole numbers, which are no values; found by the fuzzer of givens.
TEST_CASE("michell thrust: how much higher than long the film is drawn is told beside the values",
          "[michell-thrust]") {
  for (const Assignments& given : {Assignments{"D_e=700"}, Assignments{"x_N_over_l=0.565000000001", "mu=75"}}) {
    const CheckedExercise checked = thrust().checked(given);
    CAPTURE(given, complaints(checked));
    CHECK(checked.passed());
  }
}

TEST_CASE("michell thrust: givens that cannot be, each in one sentence", "[michell-thrust]") {
  is_refused(thrust(), {"D_i=2.2"}, "no width");
  is_refused(thrust(), {"d=520"},
             "10 gaps of d = 0.52 m take 5.2 m, and the mean circle of R_m = 0.825 m is only 5.18363 m");
  is_refused(thrust(), {"d=518.363"},
             "take 5.18363 m, and the mean circle of R_m = 0.825 m is only 5.183628 m: no room for pads");
  is_refused(thrust(), {"z=3.5"}, "whole number");
  is_refused(thrust(), {"x_N_over_l=0.5"}, "more than 0.5");
  is_refused(thrust(), {"x_N_over_l=0.951"}, "at most 0.95");
  is_refused(thrust(), {"mu=0"}, "must be positive");
  CHECK(thrust().checked({"d=518"}).passed());
}

TEST_CASE("michell thrust: every sheet is drawn, and letters find room", "[michell-thrust][sheets]") {
  draws_every_sheet(thrust(), read_corpus(EPURE_CORPUS "/michell_thrust.txt"));
  letters_find_room(thrust(), {{}, {"z=6"}, {"x_N_over_l=0.6", "n_g=300"}, {"x_N_over_l=0.75"}});
}

TEST_CASE("michell thrust: off the table only what its chord gives is not there", "[michell-thrust]") {
  for (const char* pivot : {"x_N_over_l=0.547", "x_N_over_l=0.609"}) {
    const CheckedExercise result = thrust().checked({pivot});
    CAPTURE(pivot, complaints(result));
    CHECK(result.passed());
    for (const char* name : {"n", "A", "k", "h_2", "T", "no_side_leakage.h_1", "nominal_load.M"}) {
      CAPTURE(name);
      CHECK(find(result, name).settled.kind == geometry::Settled::Kind::absent);
      CHECK(find(result, name).settled.reason.english.find("0.548 to 0.608") != std::string::npos);
    }
    for (const char* name : {"mu", "N", "x_N", "theory.n", "theory.M", "table_n_2_0.A"})
      CHECK(find(result, name).settled.kind == geometry::Settled::Kind::certain);
  }
  for (const char* pivot : {"x_N_over_l=0.548", "x_N_over_l=0.608"})
    CHECK(find(thrust().checked({pivot}), "n").settled.kind == geometry::Settled::Kind::certain);
}

TEST_CASE("michell thrust: the root and the chord's n are measured back", "[michell-thrust][sheets]") {
  const CheckedExercise result = thrust().checked({});
  CHECK(find(result, "theory.n").on_sheets.size() >= 1);
  CHECK(find(result, "n").on_sheets.size() >= 1);
  const auto chord = ends_of(line(thrust().draw("coefficients", {}), "chord"));
  CHECK(chord.second.x > chord.first.x);
  CHECK(tells(thrust().draw("coefficients", {"x_N_over_l=0.7"}), "there is no chord"));
}

TEST_CASE("michell thrust: forces have heads, the friction angle lies within them", "[michell-thrust][sheets]") {
  const DrawnSheet drawn = thrust().draw("forces", {});
  const drawings::Arrow N_p = arrow(drawn, "N_p"), T_p = arrow(drawn, "T_p"), R = arrow(drawn, "R");
  CHECK(T_p.from.x == N_p.to.x);
  CHECK(T_p.to.x == R.to.x);
  CHECK(T_p.to.y == R.to.y);
  const std::vector<drawings::AngleMark> angles = all_of<drawings::AngleMark>(drawn);
  REQUIRE(angles.size() == 1);
  CHECK(angles[0].to == Approx(std::numbers::pi / 2));
  CHECK(std::tan(angles[0].from) == Approx((R.to.y - R.from.y) / (R.to.x - R.from.x)));
  CHECK(tells(drawn, "not to scale"));
  CHECK(arrow(thrust().draw("pad", {}), "N").to.y > arrow(thrust().draw("pad", {}), "N").from.y);
}
