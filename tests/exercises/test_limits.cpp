// Every exercise at the ends of what is documented: each given at its smallest and largest size, the scales, the
// papers and the languages. A user's input never makes a check fail or an internal error: exit 0, 2 or 4.
#include <nlohmann/json.hpp>
#include <sstream>

#include "exercises/cli/run.h"
#include "exercises/kit/proof/exercise.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

Ran ask(const std::vector<std::string>& words) {
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), words, out, err);
  return {exit, out.str(), err.str()};
}

// Gears can be wrong in themselves; then all that fails is that.
bool only_gears_fail(const std::string& report) {
  const nlohmann::json exercise = nlohmann::json::parse(report).at("exercises").at(0);
  if (exercise.at("id") != "gear-pair") return false;
  for (const nlohmann::json& failure : exercise.at("failures"))
    for (const nlohmann::json& quantity : exercise.at("quantities"))
      if (failure.get<std::string>().starts_with(quantity.at("name").get<std::string>() + ": ")) return false;
  return true;
}

void is_answered(const std::vector<std::string>& words) {
  const Ran ran = ask(words);
  CAPTURE(words, ran.exit, ran.err);
  CHECK((ran.exit == 0 || ran.exit == 2 || ran.exit == 4 || (ran.exit == 1 && only_gears_fail(ran.out))));
  if (ran.exit == 2) CHECK(ran.err.starts_with("epure: "));
}

std::vector<std::string> ends_of(const GivenSpec& given) {
  std::vector<std::string> ends;
  for (const Choice& choice : given.choices) ends.push_back(choice.word);
  if (ends.empty()) ends = {"0", "1e-12", "1e12", "-1e-12", "-1e12"};
  return ends;
}

}  // namespace

// A check draws all sheets, too.
TEST_CASE("each given at the ends of its range: every exercise is checked, or refuses", "[limits]") {
  for (const Listed& exercise : catalogue())
    for (const GivenSpec& given : exercise->about().givens)
      for (const std::string& end : ends_of(given))
        is_answered({"check", exercise.id(), "--json", "--set", given.symbol + "=" + end});
}

TEST_CASE("all lengths at the ends of their range, together", "[limits]") {
  for (const Listed& exercise : catalogue())
    for (const char* end : {"=1e-12", "=1e12"}) {
      std::vector<std::string> words{"check", exercise.id(), "--json"};
      for (const GivenSpec& given : exercise->about().givens)
        if (given.unit == "m") words.insert(words.end(), {"--set", given.symbol + end});
      is_answered(words);
    }
}

// Curves of which a double sees one point.
TEST_CASE("a circle that rolls in another of all but its size", "[limits]") {
  const std::vector<std::vector<std::string>> all{{"r=1", "R=1.00000000000000001", "d=1"},
                                                  {"r=999999999999.99999999", "R=1e12", "d=1e12"},
                                                  {"r=1", "R=1.00000001", "d=1", "phi=1e12"}};
  for (const auto& givens : all) {
    std::vector<std::string> words{"check", "roulette", "--json", "--set", "how=circle_inside_circle"};
    for (const std::string& given : givens) words.insert(words.end(), {"--set", given});
    is_answered(words);
  }
}

// Doubles end between the two branches: coupler and rocker are folded for them.
TEST_CASE("an iteration that doubles cannot lead to a branch", "[limits]") {
  is_answered({"check", "four-bar-constraints", "--json", "--set", "A0B0=1.0000000000000001", "--set", "A0A=1",
               "--set", "AB=1", "--set", "B0B=1", "--set", "phi=0", "--set", "theta_3_start=1", "--set",
               "theta_4_start=0"});
}

TEST_CASE("the smallest and the largest scale, on every sheet", "[limits]") {
  const Scratch scratch;
  for (const Listed& exercise : catalogue())
    for (const SheetSpec& sheet : exercise->about().sheets)
      for (const char* scale : {"1:1000000", "1000000:1"})
        is_answered({"draw", exercise.id() + "/" + sheet.name, "--format", "svg", "--scale", scale});
}

TEST_CASE("every sheet on every paper in every language, bare and whole", "[limits]") {
  const Scratch scratch;
  for (const Listed& exercise : catalogue())
    for (const std::string paper : {"a3", "a4"})
      for (const std::string language : {"en", "it"})
        for (const bool bare : {false, true}) {
          std::vector<std::string> words{"draw", exercise.id(), "--paper", paper, "--lang", language};
          if (bare) words.push_back("--bare");
          CAPTURE(words);
          CHECK(ask(words).exit == 0);
        }
}
