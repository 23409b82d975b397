// A class that measured the slider-crank N.1, each student's crank and speed being another's. The key's values, and
// the numbers that slips lead to, are by mpmath with 40 digits from v_B = -ω₂ r (sin φ + cos φ · r sin φ / c),
// ω₃ = -ω₂ r cos φ / c, P₀B = (r cos φ + c) tan φ, where c² = l² - r² sin² φ.
#include <chrono>
#include <fstream>
#include <sstream>

#include "exercises/cli/csv_reader.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/measured.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string examples = EPURE_EXAMPLES;

std::vector<std::string> marking(const std::string& answers, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"mark", "slider-crank-velocity", "--answers", answers};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The verdict on one answer to one quantity.
std::string verdict_on(const std::string& quantity, const std::string& answer,
                       const std::vector<std::string>& more = {}) {
  std::ofstream("one.csv") << quantity << "\n\"" << answer << "\"\n";
  std::vector<std::string> words = marking("one.csv", {"--format", "csv"});
  words.insert(words.end(), more.begin(), more.end());
  const Ran ran = run_on_all(words);
  CAPTURE(ran.err);
  REQUIRE(ran.exit == 0);
  return read_csv(ran.out, "marks").rows.at(0).cells.at(3) + "; " +
         read_csv(ran.out, "marks").rows.at(0).cells.back();
}

}  // namespace

TEST_CASE("the example of the page on marking") {
  const Ran ran =
      run_on_all(marking(examples + "/answers.csv", {"--key", examples + "/key.csv", "--set", "phi=30deg"}));
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());  // the key is of these givens
  std::ifstream page(examples + "/marks.txt");
  std::ostringstream told;
  told << page.rdbuf();
  CHECK(ran.out == told.str());
}

TEST_CASE("a key of another crank angle is refused") {
  const Ran ran =
      run_on_all(marking(examples + "/answers.csv", {"--key", examples + "/key.csv", "--set", "phi=31deg"}));
  CHECK(ran.exit == 2);
  CHECK(ran.out.empty());
  CHECK(tells(ran.err, "epure: 1001 v_B: 4.78189018818962 in the key's line 2, but "));
  CHECK(tells(ran.err, "(14 more like it)"));
}

// v_B / P0B, both read to half a millimetre at 1 cm ≙ 2.5 m/s and 1:5: 13.3286 (0.125/5.10278 + 0.0025/0.382843).
TEST_CASE("what is calculated from readings may be off by what these may; more digits are not punished") {
  const Exercise& exercise = *std::find_if(catalogue().begin(), catalogue().end(),
                                           [](const Listed& each) { return each.id() == "slider-crank-velocity"; })
                                  ->
                                  operator->();
  const CheckedExercise checked = check(exercise, Givens(exercise.about().givens), Rung::climb);
  for (const CheckedQuantity& quantity : checked.quantities)
    if (quantity.spec.name == "omega_3") {
      const Allowance allowed = allowance(checked, quantity, {});
      CHECK(nearest(allowed.size) == Approx(0.4135422117));
      CHECK(allowed.by.english == "v_B / P0B, 0.5 mm in each: 2.4 % + 0.65 %");
    }
  for (const std::string number : {"13", "13.0", "13.04", "13.0400001", "13.74", "12.92"})
    CHECK(run_on_all({"check", "slider-crank-velocity", "--quiet", "--measured", "omega_3=" + number}).exit == 0);
  for (const std::string number : {"13.75", "12.91", "12", "+13.3"})
    CHECK(run_on_all({"check", "slider-crank-velocity", "--quiet", "--measured", "omega_3=" + number}).exit == 1);
}

// The value of z2 is also that of a radius over a short clearance, that of a weight also a force over a coefficient
// of another case; the slope of the beam at B is 0.000783.
TEST_CASE("no way of calculating makes a number right that is far from it") {
  const auto exit_of = [](const std::string& id, const std::string& measured) {
    return run_on_all({"check", id, "--quiet", "--measured", measured}).exit;
  };
  CHECK(exit_of("gear-pair", "z2=33") == 1);
  CHECK(exit_of("spool-slip", "weight_b=500") == 1);
  CHECK(exit_of("spool-slip", "weight_b=296") == 0);
  for (const char* wrong : {"-0.004", "0.0009", "0.01"})
    CHECK(exit_of("boat-crane", "theta_B=" + std::string(wrong)) == 1);
  CHECK(exit_of("boat-crane", "theta_B=0.00079") == 0);
}

TEST_CASE("slips that need solving again") {
  const Scratch scratch;
  CHECK(tells(verdict_on("v_B", "7.92"),
              "slip; v_B: 7.92 m/s, true 5.10278 ± 0.12: sine for cosine (90° - phi for phi)"));
  CHECK(tells(verdict_on("v_B", "13.24"), ": r doubled (diameter for radius)"));
  CHECK(tells(verdict_on("v_B", "6.62"), ": l halved (radius for diameter)"));
  CHECK(tells(verdict_on("omega_3", "2.53"), ": phi deg taken for radians"));
  CHECK(tells(verdict_on("v_B", "48.73"), ": rpm taken for rad/s (factor 30/π)"));
  CHECK(tells(verdict_on("v_B", "7.54"), ": this is v_A"));
  CHECK(tells(verdict_on("v_B", "8.9"), "wrong; v_B: 8.9 m/s, true 5.10278 ± 0.12"));
  CHECK(tells(verdict_on("v_B", "5.2"), "right; "));
}

// In this position B lies on the axis: B_y and v_B_y are zero.
TEST_CASE("a zero is nobody's slip") {
  const Scratch scratch;
  CHECK(verdict_on("v_B", "0").starts_with("wrong; "));
  CHECK(verdict_on("v_B", "0.00 m/s").starts_with("wrong; "));
  CHECK(verdict_on("P0B", "0").starts_with("wrong; "));
  CHECK(verdict_on("v_B", "0.01").starts_with("wrong; "));
  CHECK(verdict_on("v_B_y", "0").starts_with("right; "));
}

// φ_t1 = 7 rad, s₄ is one arch; the percentage is of the true number, not of one a turn away.
TEST_CASE("an angle turned through is no direction") {
  const auto measured = [](const std::string& id, const std::string& told) {
    return run_on_all({"check", id, "--measured", told});
  };
  CHECK(measured("cycloid-involute", "involute.phi_t1=0.717").exit == 1);
  CHECK(measured("cycloid-involute", "involute.phi_t1=7.00").exit == 0);
  CHECK(measured("cycloid-involute", "cycloid.phi_at_s4=0").exit == 1);
  CHECK(measured("four-bar", "crank_rotation_extended_to_folded=-4.804").exit == 1);  // 1.479 the other way round
  CHECK(tells(measured("four-bar-analytic", "theta_4=3").out, "difference -2.4 (-273 %)"));
}

// θ₃ = 1.2313 and θ₄ = -0.8808 to a hundredth: what is a thousand times larger may be off by 10 rad, more than a
// turn.
TEST_CASE("a wrong direction is nobody's multiple, and neither is what could as well be right") {
  const Scratch scratch;
  std::ofstream("angles.csv")
      << "number,theta_3,theta_4\n1,-1,-0.5\n2,2.6,3\n3,0.3,1.7\n4,70.55,+0.8808\n5,0.0215,-8.808\n";
  const Ran ran = run_on_all({"mark", "four-bar-analytic", "--answers", "angles.csv", "--format", "csv"});
  REQUIRE(ran.exit == 0);
  const CsvTable marks = read_csv(ran.out, "marks");
  const auto judged = [&](std::size_t row) {
    const std::vector<std::string>& cells = marks.rows.at(row).cells;
    return std::pair(cells.at(3), cells.at(5));
  };
  for (const std::size_t row : {0, 1, 2}) CHECK(judged(row) == std::pair<std::string, std::string>("wrong", "wrong"));
  CHECK(judged(3) == std::pair<std::string, std::string>("slip", "slip"));  // degrees; the opposite sense
  CHECK(judged(4) == std::pair<std::string, std::string>("slip", "slip"));  // radians as degrees; ten times
  for (const char* any : {"0.9", "5", "60"})                                // 0.0184 ± 0.12 m/s
    CHECK(verdict_on("v_B", any, {"--set", "phi=0.1deg"}).starts_with("wrong; "));
}

TEST_CASE("a column is known by letters that end in parentheses") {
  const Scratch scratch;
  std::ofstream("one.csv") << "number;x(13 s);x(13 s) [mm]\n1;1;1\n";
  CHECK(run_on_all({"mark", "oscillator-pendulum", "--answers", "one.csv"}).err.find("two columns for") !=
        std::string::npos);
  std::ofstream("one.csv") << "number;x(13 s)\n1;1\n";
  CHECK(tells(run_on_all({"mark", "oscillator-pendulum", "--answers", "one.csv", "--format", "csv"}).out,
              "oscillator.x_at_13 verdict"));
}

TEST_CASE("what stands for no answer, and how sure an answer is") {
  const Scratch scratch;
  for (const char* none : {"assente", "#N/D", "absent"}) CHECK(verdict_on("v_B", none) == "no answer; ");
  CHECK(verdict_on("v_B", "5.1 m/s (circa)").starts_with("right; "));
}

TEST_CASE("five hundred students of their own givens take seconds") {
  const Scratch scratch;
  std::ofstream key("key.csv"), answers("answers.csv");
  key << "number,r\n";
  answers << "number,v_B,v_C,v_M,v_BA,omega_3,P0A,P0B,P0C,P0M,v_CA\n";
  for (int i = 0; i < 500; ++i) {
    key << i << ",0." << 180 + i % 40 << i << "m\n";
    answers << i << ",5,4,5,7,13,0.5,0.4,0.3,0.4,9\n";
  }
  key.close();
  answers.close();
  const auto begin = std::chrono::steady_clock::now();
  const Ran ran = run_on_all(marking("answers.csv", {"--key", "key.csv", "--format", "csv"}));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  CHECK(ran.exit == 0);
  CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') == 501);
  WARN("500 students, 10 quantities: " << taken.count() << " s");
}
