// The oscillator and the pendulum: their numbers are those of a corpus of complex exponentials and Taylor series;
// every printed row is explained; bad givens; every sheet.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "exercises/kit/proof/solution.h"
#include "exercises/oscillator-pendulum/printed.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& tried() {
  static const Tried exercise("oscillator-pendulum");
  return exercise;
}
const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/oscillator_pendulum.txt");
  return cases;
}

}  // namespace

TEST_CASE("oscillator and pendulum: values are the corpus', to the last bit of a double, by every route",
          "[oscillator-pendulum]") {
  CHECK(corpus().size() == 10);
  holds_against(tried(), corpus());
}

TEST_CASE("oscillator and pendulum: what the source printed, and why it is wrong where it is",
          "[oscillator-pendulum]") {
  const CheckedExercise result = tried().checked({});
  CHECK(result.passed());
  const Judged prints = judged(result);
  CHECK(prints.rounding == 56);
  CHECK(prints.explained == 69);
  CHECK(prints.unexplained == 0);
}

TEST_CASE("oscillator and pendulum: nearly critical damping loses no digit", "[oscillator-pendulum]") {
  const double critical = value(tried().checked({"zeta=1"}), "oscillator.x_at_5");
  for (const char* zeta :
       {"zeta=1.000000000000001", "zeta=0.999999999999999", "zeta=1.000000000000000000000000000001"}) {
    const CheckedExercise near = tried().checked({zeta});
    CAPTURE(zeta);
    CHECK(near.passed());
    CHECK(std::abs(value(near, "oscillator.x_at_5") / critical - 1) < 1e-14);
    const auto& x = find(near, "oscillator.x_at_5").settled;
    CHECK(x.kind == geometry::Settled::Kind::certain);
    CHECK(x.enclosure.upper - x.enclosure.lower <= 4 * ulp(x.enclosure.value));
  }
  CHECK(find(tried().checked({"zeta=1"}), "oscillator.x_dot_at_5").settled.enclosure.upper == 0);
}

// exp(-160000) and the like lie between zero and the least double: one route knows their sign, the other need not.
TEST_CASE("oscillator and pendulum: motions that end below all doubles", "[oscillator-pendulum]") {
  for (const Assignments& assignments :
       {Assignments{"omega_n=4000", "zeta=1"}, Assignments{"omega_n=36723", "zeta=1"},
        Assignments{"omega_n=36723", "zeta=1.0000001"}}) {
    const CheckedExercise checked = tried().checked(assignments);
    CAPTURE(complaints(checked));
    CHECK(checked.passed());
    const geometry::Enclosure x = find(checked, "oscillator.x_at_40").settled.enclosure;
    CHECK(x.value == 0);
    CHECK(x.upper == std::numeric_limits<double>::denorm_min());
  }
}

TEST_CASE("oscillator and pendulum: what is not there", "[oscillator-pendulum]") {
  is_absent(tried(), {"zeta=0.5"}, "oscillator.lambda_1", "complex");
  is_absent(tried(), {"zeta=1"}, "oscillator.C_1", "double");
  is_absent(tried(), {"dt=0.4"}, "oscillator.x_euler_at_1", "does not divide");
  is_absent(tried(), {"dt_p=0.003"}, "pendulum.theta_numeric_at_0p1", "does not divide");
  is_absent(tried(), {"omega_n=1e12"}, "oscillator.x_euler_at_20", "10^300");
}

TEST_CASE("oscillator and pendulum: givens that cannot be, each in one sentence", "[oscillator-pendulum]") {
  is_refused(tried(), {"m=-1"}, "must be positive");
  is_refused(tried(), {"zeta=-1"}, "must not be negative");
  is_refused(tried(), {"v_0=0"}, "nothing sets it off");
  is_refused(tried(), {"dt=0.01"}, "at least 0.05 s");
  is_refused(tried(), {"r=0"}, "does not swing");
  is_refused(tried(), {"theta_0=0"}, "stays there");
  is_refused(tried(), {"theta_0=180"}, "upper equilibrium");
  is_refused(tried(), {"theta_0=-181"}, "no full turn");
}

TEST_CASE("oscillator and pendulum: what is told of the recursion holds for these givens", "[sheets]") {
  const auto plane = [](const Assignments& given) { return told_on(tried(), "pendulum-plane", given); };
  CHECK_THAT(plane({}), Contains("adds energy at every step") && Contains("after 500 ms, 1000 ms"));
  CHECK_THAT(plane({"theta_0=170", "dt_p=0.03"}),
             Contains("others take from it") && Contains("goes over the top") && !Contains("Rings"));
  CHECK_THAT(plane({"theta_0=86", "dt_p=0.1"}), Contains("others take from it"));
  const auto angle = [](const Assignments& given) { return told_on(tried(), "angle", given); };
  CHECK_THAT(angle({}), Contains("_{n}$ of the recursion: the step at which"));
  CHECK_THAT(angle({"theta_0=170", "dt_p=0.03"}), Contains("goes over the top, and has no period"));
}

TEST_CASE("oscillator and pendulum: every sheet is drawn, whatever is given", "[oscillator-pendulum][sheets]") {
  draws_every_sheet(tried(), corpus());
}

TEST_CASE("oscillator and pendulum: letters find room", "[oscillator-pendulum][sheets]") {
  letters_find_room(tried(), {{},
                              {"zeta=0.3", "theta_0=150"},
                              {"zeta=1", "theta_0=30"},
                              {"zeta=0", "theta_0=-100"},
                              {"theta_0=5"},
                              {"theta_0=-170"}});
}

TEST_CASE("oscillator and pendulum: the tables have all their rows, and those that are quantities too", "[sheets]") {
  const Exercise& exercise = find_exercise(catalogue(), "oscillator-pendulum");
  const Solution solution = exercise.solution(tried().givens({}));
  const auto oscillator = exercise.long_table("oscillator-table", solution),
             pendulum = exercise.long_table("pendulum-table", solution);
  REQUIRE((oscillator && pendulum));
  CHECK(oscillator->rows() == 41);
  CHECK(pendulum->rows() == 101);
  const auto agrees = [&](const LongTable& table, const std::string& kind, std::size_t row, const std::string& name) {
    CAPTURE(name);
    const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                     [&](const LongTable::Column& each) { return each.name == kind; });
    REQUIRE(column != table.columns.end());
    CHECK(column->values.at(row) == solution[name]);
  };
  agrees(*oscillator, "x", 10, "oscillator.x_at_5");
  agrees(*oscillator, "x_dot_euler", 20, "oscillator.x_dot_euler_at_10");
  agrees(*oscillator, "x_ddot_euler", 40, "oscillator.x_ddot_euler_at_20");
  agrees(*pendulum, "theta", 30, "pendulum.theta_at_0p3");
  agrees(*pendulum, "R_12_y", 100, "pendulum.R_12_y_at_1");
  agrees(*pendulum, "theta_ddot_numeric", 50, "pendulum.theta_ddot_numeric_at_0p5");
  agrees(*pendulum, "R_12_x_numeric", 100, "pendulum.R_12_x_numeric_at_1");
}

TEST_CASE("oscillator and pendulum: a table ends where doubles do, and where its steps do", "[sheets]") {
  const Exercise& exercise = find_exercise(catalogue(), "oscillator-pendulum");
  const auto rows = [&](const Assignments& givens, const char* sheet) {
    return exercise.long_table(sheet, exercise.solution(tried().givens(givens)))->rows();
  };
  CHECK(rows({"dt=0.3"}, "oscillator-table") == 67);
  CHECK(rows({"dt=30"}, "oscillator-table") == 1);
  CHECK(rows({"dt_p=0.03"}, "pendulum-table") == 34);
  CHECK(rows({"omega_n=1000000000"}, "oscillator-table") < 41);  // Euler's method grows by 10^9 at each step
}

TEST_CASE("oscillator and pendulum: forces stand at the positions, to a scale that is told", "[sheets]") {
  for (const Assignments& given : {Assignments{}, {"theta_0=30"}, {"theta_0=-100"}}) {
    CAPTURE(given);
    const CheckedExercise result = tried().checked(given);
    for (const char* reaction : {"R_12_x_at_0", "R_12_y_at_0", "R_12_x_at_0p2", "R_12_y_at_0p2", "R_12_x_at_0p4"}) {
      CAPTURE(reaction);
      const auto& sheets = find(result, std::string("pendulum.") + reaction).on_sheets;
      CHECK(std::any_of(sheets.begin(), sheets.end(), [](const OnSheet& each) { return each.sheet == "positions"; }));
    }
    const DrawnSheet drawn = tried().draw("positions", given);
    std::size_t scales = 0;
    for (const std::string& scale : drawn.sheet.title_block.scales) scales += scale.find(" N") != std::string::npos;
    CHECK(scales == 2);  // of the positions, of the polygon
  }
}

// At 0.6 s the pendulum is all but back where it was let go.
TEST_CASE("oscillator and pendulum: every point of the hodograph has its time", "[sheets]") {
  const DrawnSheet drawn = tried().draw("hodograph", {});
  std::set<std::string> letters;
  for (const drawings::Label& each : drawn.sheet.figure.labels) letters.insert(each.text);
  for (const char* time : {"0; 600", "100", "200", "300", "400", "500", "700", "800", "900", "1000"}) {
    CAPTURE(time);
    CHECK(letters.contains(time));
  }
  CHECK(letters.contains("$\\vec{\\it{R}}_{12}$"));
}
