// N.11 against the corpus, from starts near and far; and its sheets.
#include <cmath>

#include "exercises/four-bar-constraints/exercise.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "tests/exercises/four_bar_on_x_cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::string id = "four-bar-constraints";

CheckedExercise checked(const Assignments& assignments) { return tests::checked(id, assignments); }

// From the case's own angles, cut off after a digit.
Assignments with_start(const CorpusCase& c) {
  Assignments all = assignments_of(c);
  const auto one_digit = [&](const char* name) {
    const long tenths = std::lround(10 * std::stod(c.reference(name)));
    return std::to_string(tenths) + "/10";
  };
  all.push_back("theta_3_start=" + one_digit("theta_3"));
  all.push_back("theta_4_start=" + one_digit("theta_4"));
  return all;
}

}  // namespace

TEST_CASE("four-bar-constraints: as stated everything is settled by three routes", "[four-bar-constraints]") {
  const CheckedExercise result = checked({});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  for (const CheckedQuantity& quantity : result.quantities) CHECK(quantity.routes.size() == 3);
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& number : quantity.printed) {
      CAPTURE(quantity.spec.name, number.text);
      CHECK(number.explanation_holds);
      CHECK((number.verdict == Verdict::rounding || number.explanation.has_value()));
    }
}

TEST_CASE("four-bar-constraints: to the last bit of the corpus", "[four-bar-constraints]") {
  int cases = 0, values = 0;
  for (const CorpusCase& c : cases_on_x()) {
    CAPTURE(c.name, c.why);
    const bool closes = c.reference("closure_gap").empty(), moves = c.reference("omega_4") != "undefined";
    // A tenth of a radian beside a near change point, or between links of 1e8 m, leads elsewhere.
    if (!closes || !moves || c.name.starts_with("near_change_point") || c.name == "long_coupler") continue;
    const CheckedExercise result = checked(with_start(c));
    values += hold_against(result, c);
    CHECK(value(result, "jacobian_determinant_psi_y") == std::stod(c.reference("psi_y_determinant")));
    ++cases;
  }
  CHECK(cases >= 14);
  CHECK(values == 24 * cases);
}

// The start decides the branch; whole turns in it do not.
TEST_CASE("four-bar-constraints: either branch, and whole turns aside", "[four-bar-constraints]") {
  const CheckedExercise above = checked({}), below = checked({"theta_3_start=-1.4", "theta_4_start=0.6"}),
                        turned = checked({"theta_3_start=-11.3", "theta_4_start=-0.87"});
  CHECK(value(above, "jacobian_determinant_psi_y") < 0);
  CHECK(value(below, "jacobian_determinant_psi_y") > 0);
  CHECK(value(below, "theta_3") == Approx(-1.453939572).epsilon(1e-9));  // printed in N.10
  CHECK(value(below, "theta_4") == Approx(0.6582004834).epsilon(1e-9));
  CHECK(value(turned, "theta_3") == value(above, "theta_3"));
}

// Each step of the iteration, redone here from its definition, in another order of operations.
TEST_CASE("four-bar-constraints: the iterates are Newton's", "[four-bar-constraints]") {
  const auto of = four_bar_constraints::problem(givens_of(id, {"theta_3_start=0.5", "theta_4_start=-1.8"}));
  REQUIRE(of.run.iterates.size() > 3);
  const double theta_2 = std::acos(-1.0) / 9;
  for (std::size_t k = 0; k + 1 < of.run.iterates.size(); ++k) {
    const double t3 = of.run.iterates[k].q(0), t4 = of.run.iterates[k].q(1);
    const double x = 0.2 * std::cos(theta_2) + 0.5 * std::cos(t3) + 0.7 * std::cos(t4) - 0.8,
                 y = 0.2 * std::sin(theta_2) + 0.5 * std::sin(t3) + 0.7 * std::sin(t4);
    // Along each link the residual is what only the other's turning can take away.
    const double sine = std::sin(t4 - t3);
    const double step_3 = (x * std::cos(t4) + y * std::sin(t4)) / (-0.5 * sine),
                 step_4 = (x * std::cos(t3) + y * std::sin(t3)) / (0.7 * sine);
    CAPTURE(k);
    CHECK(of.run.iterates[k].residual_norm == Approx(std::hypot(x, y)).margin(1e-15));
    CHECK(of.run.iterates[k + 1].q(0) - t3 == Approx(step_3).epsilon(1e-9).margin(1e-15));
    CHECK(of.run.iterates[k + 1].q(1) - t4 == Approx(step_4).epsilon(1e-9).margin(1e-15));
  }
}

TEST_CASE("four-bar-constraints: a start in degrees or in turns is an angle all the same", "[four-bar-constraints]") {
  for (const Assignments& start : {Assignments{"theta_3_start=70deg", "theta_4_start=-50deg"},
                                   Assignments{"theta_3_start=7/36turn", "theta_4_start=-5/36turn"}}) {
    const auto of = four_bar_constraints::problem(givens_of(id, start));
    CAPTURE(start);
    CHECK(of.run.iterates.front().q(0) == Approx(1.2217304763960306).epsilon(1e-15));  // 70 π/180
    CHECK(of.run.iterates.front().q(1) == Approx(-0.8726646259971648).epsilon(1e-15));
    CHECK(of.run.iterates.size() <= 4);
  }
}

TEST_CASE("four-bar-constraints: a singular start and other impossible givens are one sentence",
          "[four-bar-constraints]") {
  const std::vector<std::pair<Assignments, std::string>> all{
      {{"theta_3_start=1", "theta_4_start=1"}, "singular"},
      {{"theta_3_start=0", "theta_4_start=0"}, "coupler and rocker are parallel"},
      {{"A0B0=2"}, "does not close"},
      {{"n=0"}, "must turn"},
      {{"theta_3_start=20m"}, "theta_3_start"}};
  for (const auto& [assignments, says] : all) {
    CAPTURE(assignments);
    try {
      checked(assignments);
      FAIL("was accepted");
    } catch (const BadGivens& refused) {
      CAPTURE(refused.what());
      CHECK(std::string(refused.what()).find(says) != std::string::npos);
    }
  }
}

TEST_CASE("four-bar-constraints: every sheet is drawn, whatever is given", "[four-bar-constraints][sheets]") {
  draws_every_sheet(id, {{},
                         {"theta_3_start=-1.4", "theta_4_start=0.6"},
                         {"theta_3_start=0.5", "theta_4_start=-1.8"},
                         {"theta_3_start=100", "theta_4_start=3"},
                         {"n=-300", "alpha_2=50", "theta_2=200"},
                         {"A0B0=800", "A0A=200", "AB=500", "B0B=700"}});
}

TEST_CASE("four-bar-constraints: letters find room", "[four-bar-constraints][sheets]") {
  letters_find_room(id, {{}, {"theta_3_start=0.5", "theta_4_start=-1.8"}});
}

// The gap drawn is the residual: from the rocker's end to the coupler's.
TEST_CASE("four-bar-constraints: the open linkage is drawn as it is", "[four-bar-constraints][sheets]") {
  const Givens givens = givens_of(id, {"theta_3_start=0.5", "theta_4_start=-1.8"});
  const auto of = four_bar_constraints::problem(givens);
  const Solution solution = find_exercise(catalogue(), id).solution(givens);
  REQUIRE(four_bar_constraints::iterates(solution) == of.run.iterates.size());
  for (std::size_t k = 0; k < of.run.iterates.size(); ++k) {
    const Place from = solution.place(four_bar_constraints::end_of_rocker(k)),
                to = solution.place(four_bar_constraints::end_of_coupler(k));
    CHECK(to.x - from.x == Approx(of.run.iterates[k].residual(0)).margin(1e-14));
    CHECK(to.y - from.y == Approx(of.run.iterates[k].residual(1)).margin(1e-14));
  }
}

// The table of the three methods, as it stands on its sheet.
TEST_CASE("four-bar-constraints: each method has its own column", "[four-bar-constraints][sheets]") {
  const Givens givens = givens_of(id, {"n=-300", "alpha_2=50"});
  const Solution solution = find_exercise(catalogue(), id).solution(givens);
  std::vector<std::string> cells;
  for (const drawings::Mark& mark : draw(id, "comparison", {"n=-300", "alpha_2=50"}).sheet.figure.marks)
    if (const auto* writing = std::get_if<drawings::Writing>(&mark)) cells.push_back(writing->text);
  REQUIRE(cells.size() == 3 + 12 * 4);
  for (std::size_t row = 0; row < 12; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      const std::string route = std::vector<std::string>{"constraint equations", "analytic", "polar diagram"}[column];
      const std::string name =
          std::vector<std::string>{"theta_3", "theta_4", "omega_3", "omega_4", "alpha_3", "alpha_4",
                                   "v_G2",    "v_G3",    "v_G4",    "a_G2",    "a_G3",    "a_G4"}[row];
      CAPTURE(name, route);
      REQUIRE(solution.value(name, route));
      const int told = route == "polar diagram" ? 3 : 6;  // figures: as many as a drawing gives
      CHECK(cells[3 + 4 * row + 1 + column] == figures(*solution.value(name, route), told, Language::english));
    }
}
