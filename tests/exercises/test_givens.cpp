// Givens as a user may type them.
#include "exercises/kit/givens.h"
#include "exercises/kit/suggest.h"
#include "tests/exercises/fake.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

Givens stated() { return Givens(Triangle().about().givens); }

// What is said of an assignment; empty when it is taken.
std::string complaint(const std::string& assignment) {
  Givens givens = stated();
  try {
    givens.set(assignment);
    return "";
  } catch (const BadGivens& bad) {
    CHECK_FALSE(std::string(bad.what()).empty());
    return bad.what();
  }
}

}  // namespace

TEST_CASE("givens are the exact rationals the source states") {
  const Givens givens = stated();
  CHECK(givens["a"] == Rational(3, 10));
  CHECK(givens["load"] == 0);
  CHECK(givens.as_stated());
}

TEST_CASE("a given is set from what was typed, and remembered as changed") {
  Givens givens = stated();
  givens.set("a=25cm");
  CHECK(givens["a"] == Rational(1, 4));
  CHECK(givens["b"] == Rational(2, 5));
  CHECK_FALSE(givens.as_stated());
  givens.set("a=0.3");
  CHECK(givens.as_stated());  // the same value in another spelling
}

TEST_CASE("each range refuses what it excludes, naming symbol, value and condition") {
  CHECK(complaint("a=-1") == "a = -1: must be positive");
  CHECK(complaint("a=0") == "a = 0: must be positive");
  CHECK(complaint("load=-1N") == "load = -1N: must not be negative");
  CHECK(complaint("load=0") == "");
  CHECK(complaint("shift=-1") == "");
  CHECK(complaint("shift=0") == "");
}

TEST_CASE("sizes far from anything drawn are refused") {
  CHECK(complaint("a=1e308") == "a = 1e308: must lie between 1e-12 and 1e12 m");
  CHECK(complaint("a=1e-308") == "a = 1e-308: must lie between 1e-12 and 1e12 m");
  CHECK(complaint("load=1e13") == "load = 1e13: must be zero or lie between 1e-12 and 1e12 N");
  CHECK(complaint("shift=-1e13").find("1e12 m") != std::string::npos);
  CHECK(complaint("shift=-1e-13").find("1e-12") != std::string::npos);
  CHECK(complaint("a=1e12") == "");
  CHECK(complaint("a=1e-12") == "");
  CHECK(complaint("a=1e15mm").find("between") == std::string::npos);  // 1e12 m
}

TEST_CASE("what is no number is refused with the symbol and a way out") {
  for (const std::string bad : {"nan", "inf", "-inf", "0,25", "", "abc", "3s", "1/0", "1e999", "3 4", "0x10"}) {
    INFO(bad);
    const std::string said = complaint("a=" + bad);
    CHECK(said.starts_with("a: \"" + bad + "\""));
    CHECK(said.find("write") != std::string::npos);
  }
}

TEST_CASE("what is no assignment is refused") {
  CHECK(complaint("a").find("write symbol=value") != std::string::npos);
  CHECK(complaint("=3").find("no symbol") != std::string::npos);
  CHECK(complaint("lode=3").find("did you mean load?") != std::string::npos);
  CHECK(complaint("zzz=3").find("known are: a, b, load, shift") != std::string::npos);
  CHECK(complaint("A=3").find("did you mean a?") != std::string::npos);
}

TEST_CASE("an endless text is not repeated in full") {
  CHECK(complaint(std::string(5000, 'x') + "=1").size() < 300);
  CHECK(complaint("a=" + std::string(5000, '9')).size() < 300);
  CHECK(complaint("a=" + std::string(900, '9')).size() < 300);
}

TEST_CASE("suggestions are near names, or a list of what there is") {
  CHECK(did_you_mean("omega3", {"omega_3", "omega_2", "v_B"}) == "did you mean omega_3 or omega_2?");
  CHECK(did_you_mean("chek", {"list", "draw", "check"}) == "did you mean check?");
  CHECK(did_you_mean("q", {"a", "b"}) == "known are: a, b");
  CHECK(did_you_mean("none of it", std::vector<std::string>(20, "zz")).ends_with(", ..."));
}

TEST_CASE("a given of words takes one of them and nothing else") {
  const std::vector<epure::GivenSpec> specs{
      {.symbol = "branch",
       .meaning = {"side", "lato"},
       .unit = "1",
       .stated = "right",
       .range = epure::Range::any,
       .choices = {{"left", {"left of AB₀", "a sinistra di AB₀"}}, {"right", {"right of AB₀", "a destra di AB₀"}}}}};
  epure::Givens givens(specs);
  CHECK(givens.chosen("branch").word == "right");
  CHECK(givens.as_stated());
  givens.set("branch=left");
  CHECK(givens.chosen("branch").word == "left");
  CHECK(givens.text("branch") == "left");
  CHECK_FALSE(givens.as_stated());
  for (const char* wrong : {"branch=", "branch=up", "branch=0", "branch=Left"}) {
    CHECK_THROWS_WITH(givens.set(wrong), Contains("must be left or right"));
  }
}
