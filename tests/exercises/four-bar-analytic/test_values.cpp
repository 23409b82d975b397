// N.10 against the corpus and against numbers found with mpmath.
#include <cmath>
#include <map>

#include "tests/exercises/four-bar-analytic/cases.h"

using namespace epure;
using namespace epure::tests;
using geometry::Settled;

namespace {

CheckedExercise checked(const Assignments& assignments) { return tests::checked(id, assignments); }

Assignments with_branch(const CorpusCase& c, const std::string& branch) {
  Assignments all = assignments_of(c);
  all.push_back("branch=" + branch);
  return all;
}

const Assignments drag_link{"A0B0=0.2", "A0A=0.6"};

}  // namespace

TEST_CASE("four-bar-analytic: as stated everything is settled by two routes", "[four-bar-analytic]") {
  const CheckedExercise result = checked({});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(result.quantities.size() >= 85);
}

TEST_CASE("four-bar-analytic: to the last bit of the corpus", "[four-bar-analytic]") {
  int cases = 0, values = 0;
  for (const CorpusCase& c : cases_on_x()) {
    CAPTURE(c.name, c.why);
    const Assignments assignments = with_branch(c, c.choices.at("branch"));
    const bool closes = c.reference("closure_gap").empty(), moves = c.reference("omega_4") != "undefined";
    if (!closes || !moves) {
      CHECK_THROWS_AS(checked(assignments), BadGivens);
      continue;
    }
    values += hold_against(checked(assignments), c);
    ++cases;
  }
  CHECK(cases >= 18);
  CHECK(values > 60 * cases);
}

// θ₃, θ₄ and the rates of the configuration not chosen are those of the case with the other branch.
TEST_CASE("four-bar-analytic: the other branch", "[four-bar-analytic]") {
  std::map<std::string, CorpusCase> named;
  for (const CorpusCase& c : cases_on_x()) named[c.name] = c;
  const CheckedExercise here = checked(assignments_of(named.at("n10")));
  for (const std::string name : {"theta_3", "theta_4", "omega_3", "omega_4", "alpha_3", "alpha_4"}) {
    CAPTURE(name);
    CHECK(value(here, name + "_other_branch") == std::stod(named.at("n10_other_branch").reference(name)));
    CHECK(find(here, name + "_other_branch").routes.size() >= 2);
  }
}

// The corpus follows the corner C of a plate with its right angle at C: AC = 3/10 on the left of AB = 1/2, so C lies
// AC²/AB = 9/50 along and 6/25 across.
TEST_CASE("four-bar-analytic: any point of the coupler", "[four-bar-analytic]") {
  int values = 0;
  for (const CorpusCase& c : cases_on_x()) {
    if (c.name != "n10" && c.name != "n10_other_branch" && c.name != "n10_60_degrees") continue;
    REQUIRE(c.givens.at("AC") == Rational(3, 10));
    Assignments assignments = with_branch(c, c.choices.at("branch"));
    assignments.insert(assignments.end(),
                       {"AP_along=9/50", c.choices.at("C_side") == "left" ? "AP_across=6/25" : "AP_across=-6/25"});
    const CheckedExercise result = checked(assignments);
    for (const std::string name : {"#_x", "#_y", "v_#_x", "v_#_y", "v_#", "a_#_x", "a_#_y", "a_#", "rho_#",
                                   "curvature_centre_#_x", "curvature_centre_#_y", "#prime_x", "#prime_y"}) {
      std::string of_P = name, of_C = name;
      of_P.replace(of_P.find('#'), 1, "P");
      of_C.replace(of_C.find('#'), 1, "C");
      CAPTURE(c.name, of_P);
      CHECK(value(result, of_P) == std::stod(c.reference(of_C)));
      ++values;
    }
  }
  CHECK(values == 3 * 13);
}

// Projections of the corpus' a_G3 on AB, and across; its parts normal to the path and along it are the corpus' own.
TEST_CASE("four-bar-analytic: the acceleration of G3 in parts", "[four-bar-analytic]") {
  for (const CorpusCase& c : cases_on_x()) {
    if (c.name != "n10") continue;
    const CheckedExercise result = checked({});
    const auto of = [&](const char* name) { return std::stod(c.reference(name)); };
    const double x = (of("B_x") - of("A_x")) / 0.5, y = (of("B_y") - of("A_y")) / 0.5;
    CHECK(value(result, "a_G3_component_along_AB") == Approx(of("a_G3_x") * x + of("a_G3_y") * y).epsilon(1e-13));
    CHECK(value(result, "a_G3_component_normal_to_AB") == Approx(of("a_G3_y") * x - of("a_G3_x") * y).epsilon(1e-13));
    CHECK(value(result, "a_G3_path_normal") == of("a_G3_n"));
    CHECK(value(result, "a_G3_path_tangential") == of("a_G3_t"));
  }
}

// Python with mpmath, 120 working digits: extremes by bisection on the numerical derivative of ω₄ = ω₂ dθ₄/dθ₂, with
// B where the circles meet; zeros from the triangles A₀B B₀ with A₀B = AB ± A₀A.
TEST_CASE("four-bar-analytic: zeros and extremes of omega_4", "[four-bar-analytic]") {
  struct Expected {
    Assignments of;
    double max, at_max, min, at_min;
  };
  const std::vector<Expected> all{
      {{},
       12.22640423846618461224053051484191977437,
       131.4290478982002011381076585746057359693,
       -14.20132209043987630196099463247456108508,
       352.675953327130997404189746684831271682},
      {{"branch=right"},
       12.22640423846618461224053051484191977437,
       228.5709521017997988618923414253942640307,
       -14.20132209043987630196099463247456108508,
       7.324046672869002595810253315168728318043},
      {{"n=-400", "theta_2=77"},
       14.20132209043987630196099463247456108508,
       352.675953327130997404189746684831271682,
       -12.22640423846618461224053051484191977437,
       131.4290478982002011381076585746057359693},
      {drag_link, 63.14407130419043560118285831760857138431, 354.5210538784840179798333471795485201014,
       29.63405825507247373459938973028979187077, 219.5166380169491014326262862794859998876}};
  for (const Expected& expected : all) {
    CAPTURE(expected.of);
    const CheckedExercise result = checked(expected.of);
    CAPTURE(complaints(result));
    CHECK(result.passed());
    CHECK(value(result, "omega_4_max") == expected.max);
    CHECK(value(result, "theta_2_at_omega_4_max_deg") == expected.at_max);
    CHECK(value(result, "omega_4_min") == expected.min);
    CHECK(value(result, "theta_2_at_omega_4_min_deg") == expected.at_min);
  }
  const CheckedExercise left = checked({}), right = checked({"branch=right"});
  CHECK(value(left, "theta_2_at_omega_4_zero_1_deg") == 55.15009542095351558852);
  CHECK(value(left, "theta_2_at_omega_4_zero_2_deg") == 240);
  CHECK(value(right, "theta_2_at_omega_4_zero_1_deg") == 120);
  CHECK(value(right, "theta_2_at_omega_4_zero_2_deg") == 304.8499045790464844115);
}

// A = (1, 0), B = (1, 4), B₀ = (4, 0): an extreme exactly at θ₂ = 0, where 360° begins too.
TEST_CASE("four-bar-analytic: an extreme on the axis is proved to be there", "[four-bar-analytic]") {
  const CheckedExercise result = checked({"A0A=1", "AB=4", "B0B=5", "A0B0=4", "theta_2=30", "n=60"});
  CHECK(result.passed());
  CHECK(value(result, "theta_2_at_omega_4_min_deg") == 0);
  // P₂₄ = (1, 0): ω₄/ω₂ = 1/(1 - 4), at 2π rad/s.
  CHECK(value(result, "omega_4_min") == Approx(-2 * 3.14159265358979323846 / 3).epsilon(1e-15));
}

TEST_CASE("four-bar-analytic: what does not exist says why", "[four-bar-analytic]") {
  const auto absent = [](const CheckedExercise& in, const std::string& name, const std::string& says) {
    CAPTURE(name, find(in, name).settled.reason.english);
    CHECK(find(in, name).settled.kind == Settled::Kind::absent);
    CHECK(find(in, name).settled.reason.english.find(says) != std::string::npos);
  };
  const CheckedExercise drag = checked(drag_link);
  absent(drag, "theta_2_at_omega_4_zero_1_deg", "no such dead centre");
  absent(drag, "theta_2_at_omega_4_zero_2_deg", "no such dead centre");

  const CheckedExercise rocking = checked({"A0B0=0.5", "A0A=0.4", "AB=0.2", "B0B=0.45", "theta_2=60"});
  CHECK(rocking.passed());
  for (const std::string name : {"omega_4_max", "omega_4_min", "theta_2_at_omega_4_max_deg"})
    absent(rocking, name, "beyond all bounds");

  // Change point: A₀A + B₀B = AB + A₀B₀.
  const CheckedExercise folding = checked({"A0B0=0.4"});
  CHECK(folding.passed());
  absent(folding, "omega_4_max", "folds flat");
  CHECK(find(folding, "theta_2_at_omega_4_zero_1_deg").settled.kind == Settled::Kind::certain);
  absent(folding, "theta_2_at_omega_4_zero_2_deg", "in line");

  // P lies where crank and rocker meet: on the pole, and its path has a cusp.
  const CheckedExercise at_pole =
      checked({"A0B0=6", "A0A=1", "AB=3", "B0B=4", "theta_2=0", "n=60", "AP_along=3", "AP_across=-4"});
  CHECK(at_pole.passed());
  for (const std::string name : {"rho_P", "curvature_centre_P_x", "Pprime_P"}) absent(at_pole, name, "cusp");
}

// Very near its change point the extremes still are decided, by both routes.
TEST_CASE("four-bar-analytic: a ten-millionth from the change point", "[four-bar-analytic]") {
  const CheckedExercise result = checked({"A0B0=0.4000001"});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(value(result, "omega_4_min") < -90);
}

TEST_CASE("four-bar-analytic: mirrored in the frame", "[four-bar-analytic]") {
  const CheckedExercise here = checked({"alpha_2=70"}),
                        there = checked({"theta_2=-20", "n=-400", "alpha_2=-70", "branch=right"});
  for (const std::string name :
       {"A_x", "B_x", "v_B", "v_G3_x", "a_G4_x", "a_G3", "P0_x", "rho_G3", "K_x", "G3prime_x"})
    CHECK(value(there, name) == value(here, name));
  for (const std::string name :
       {"A_y", "B_y", "theta_3", "theta_4", "omega_3", "omega_4", "alpha_3", "alpha_4", "v_G3_y", "a_G4_y", "P0_y",
        "K_y", "curvature_centre_G3_y", "a_G3_component_normal_to_AB"})
    CHECK(value(there, name) == -value(here, name));
}

TEST_CASE("four-bar-analytic: the impossible is one sentence", "[four-bar-analytic]") {
  struct Refused {
    Assignments assignments;
    std::vector<std::string> says;
  };
  const std::vector<Refused> all{{{"A0B0=2"}, {"does not close", "1.81", "too short"}},
                                 {{"A0B0=0.1"}, {"does not close", "cannot fold up"}},
                                 {{"n=0"}, {"n = 0", "must turn"}},
                                 {{"AB=0"}, {"AB = 0", "must be positive"}},
                                 {{"branch=up"}, {"branch", "left or right"}},
                                 // AB₀ = 1.4 - 0.2 = AB + B₀B: stretched, and so it closes in no other position.
                                 {{"A0B0=1.4", "theta_2=0"}, {"in this position alone", "cannot move"}},
                                 // AB₀ = 5 = AB + B₀B
                                 {{"A0B0=4", "A0A=3", "AB=2", "B0B=3", "theta_2=90"}, {"limit position"}},
                                 // All in line, and 2 + 8 = 6 + 4: 20 ω₄² - 8 ω₄ - 4 = 0, ω₄ = (8 ± √384)/40.
                                 {{"A0B0=8", "A0A=2", "AB=6", "B0B=4", "theta_2=180"},
                                  {"change point", "two motions", "ω₄/ω₂ = 0.689898", "ω₄/ω₂ = -0.289898"}}};
  for (const auto& [assignments, says] : all) {
    CAPTURE(assignments);
    try {
      checked(assignments);
      FAIL("was accepted");
    } catch (const BadGivens& refused) {
      const std::string message = refused.what();
      CAPTURE(message);
      for (const std::string& words : says) CHECK(message.find(words) != std::string::npos);
    }
  }
}

TEST_CASE("four-bar-analytic: what the source printed", "[four-bar-analytic]") {
  const CheckedExercise result = checked({});
  int rounding = 0, explained = 0;
  std::vector<std::string> unexplained;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& number : quantity.printed) {
      CAPTURE(quantity.spec.name, number.text);
      CHECK(number.explanation_holds);
      if (number.verdict == Verdict::rounding)
        ++rounding;
      else if (number.explanation)
        ++explained;
      else
        unexplained.push_back(quantity.spec.name);
    }
  CHECK(rounding == 37);
  CHECK(explained == 18);
  CHECK(unexplained == std::vector<std::string>{"theta_4", "a_B"});
}

// The crank's direction is then algebraic of a degree in the ten thousands: exact numbers grow without end, and the
// routes must do without them. (P on B, whose path is the circle about B0.)
TEST_CASE("four-bar-analytic: a zero at an angle that no exact number can follow", "[four-bar-analytic]") {
  const CheckedExercise result = checked({"theta_2=15.3482", "AP_along=0.5"});
  CAPTURE(complaints(result));
  CHECK(result.failures.empty());
}
