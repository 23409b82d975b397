// The oscillator and the pendulum: their numbers are those of a corpus of complex exponentials and Taylor series;
// every printed row is explained; bad givens; every sheet.
#include <cmath>

#include "exercises/oscillator-pendulum/printed.h"
#include "tests/exercises/held_against_corpus.h"

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
  CHECK(corpus().size() == 9);
  holds_against(tried(), corpus());
}

TEST_CASE("oscillator and pendulum: what the source printed, and why it is wrong where it is",
          "[oscillator-pendulum]") {
  const CheckedExercise result = tried().checked({});
  CHECK(result.passed());
  int right = 0, explained = 0;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      CHECK(verdict.explanation_holds);
      if (verdict.verdict == Verdict::rounding)
        ++right;
      else
        explained += verdict.explanation ? 1 : 0;
    }
  CHECK(right == 56);
  CHECK(explained == 69);
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

TEST_CASE("oscillator and pendulum: what is not there", "[oscillator-pendulum]") {
  const auto absent = [](const Assignments& assignments, const char* name, const char* because) {
    const CheckedExercise result = tried().checked(assignments);
    CAPTURE(assignments, name, find(result, name).settled.reason.english);
    CHECK(result.passed());
    CHECK(find(result, name).settled.kind == geometry::Settled::Kind::absent);
    CHECK(find(result, name).settled.reason.english.find(because) != std::string::npos);
  };
  absent({"zeta=0.5"}, "oscillator.lambda_1", "complex");
  absent({"zeta=1"}, "oscillator.C_1", "double");
  absent({"dt=0.4"}, "oscillator.x_euler_at_1", "does not divide");
  absent({"dt_p=0.003"}, "pendulum.theta_numeric_at_0p1", "does not divide");
  absent({"omega_n=1e12"}, "oscillator.x_euler_at_20", "10^300");
}

TEST_CASE("oscillator and pendulum: givens that cannot be, each in one sentence", "[oscillator-pendulum]") {
  const auto refused = [](const Assignments& assignments, const char* because) {
    CAPTURE(assignments, because);
    CHECK_THROWS_WITH(tried().checked(assignments), Contains(because));
  };
  refused({"m=-1"}, "must be positive");
  refused({"zeta=-1"}, "must not be negative");
  refused({"v_0=0"}, "nothing sets it off");
  refused({"dt=0.01"}, "at least 0.05 s");
  refused({"r=0"}, "does not swing");
  refused({"theta_0=0"}, "stays there");
  refused({"theta_0=180"}, "upper equilibrium");
  refused({"theta_0=-181"}, "no full turn");
}

TEST_CASE("oscillator and pendulum: every sheet is drawn, whatever is given", "[oscillator-pendulum][sheets]") {
  draws_every_sheet(tried(), corpus());
}

TEST_CASE("oscillator and pendulum: letters find room", "[oscillator-pendulum][sheets]") {
  letters_find_room(tried(), {{}, {"zeta=0.3", "theta_0=150"}, {"zeta=1", "theta_0=30"}, {"zeta=0", "theta_0=-100"}});
}
