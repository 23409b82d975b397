// Givens as a user may type them.
#include "exercises/kit/statement/givens.h"
#include "exercises/kit/statement/suggest.h"
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
  CHECK(complaint("shift=-1e13") ==
        "shift = -1e13: without its sign it must be zero or lie between 1e-12 and 1e12 m");
  CHECK(complaint("shift=-1e-13").find("1e-12") != std::string::npos);
  CHECK(complaint("a=1e12") == "");
  CHECK(complaint("a=1e-12") == "");
  CHECK(complaint("a=1e15mm").find("between") == std::string::npos);  // 1e12 m
}

TEST_CASE("what is no number is refused with the symbol and a way out") {
  for (const std::string bad : {"nan", "inf", "-inf", "1,234.5", "", "abc", "3s", "1/0", "1e999", "3 4", "0x10"}) {
    INFO(bad);
    const std::string said = complaint("a=" + bad);
    CHECK(said.starts_with("a: \"" + bad + "\""));
    CHECK(said.find("write") != std::string::npos);
  }
}

TEST_CASE("what is no assignment is refused") {
  CHECK(complaint("a").find("write symbol=value") != std::string::npos);
  CHECK(complaint("=3").find("no symbol") != std::string::npos);
  CHECK(complaint("laod=3").find("did you mean load?") != std::string::npos);
  CHECK(complaint("zzz=3").find("known are: a, b, load, shift") != std::string::npos);
  CHECK(complaint("A=3").find("did you mean a?") != std::string::npos);
}

TEST_CASE("an endless text is not repeated in full") {
  CHECK(complaint(std::string(5000, 'x') + "=1").size() < 300);
  CHECK(complaint("a=" + std::string(5000, '9')).size() < 300);
  CHECK(complaint("a=" + std::string(900, '9')).size() < 300);
}

TEST_CASE("suggestions are near names, or a list of what there is") {
  CHECK(did_you_mean("omega3", {"omega_3", "omega_2", "v_B"}).english == "did you mean omega_3 or omega_2?");
  CHECK(did_you_mean("chek", {"list", "draw", "check"}).english == "did you mean check?");
  CHECK(did_you_mean("v_Q_x", {"v_T_x", "v_R_x", "v_T_x"}).english == "did you mean v_T_x or v_R_x?");
  CHECK(did_you_mean("q", {"a", "b"}).english == "known are: a, b");
  CHECK(did_you_mean("test", {"list", "bench"}).english == "known are: list, bench");  // half of its letters
  CHECK(did_you_mean("dwar", {"draw", "check"}).english == "known are: draw, check");
  CHECK(did_you_mean("darw", {"draw", "check"}).english == "did you mean draw?");
  CHECK(did_you_mean("Slider", {"gear-pair", "slider-crank-velocity"}).english ==
        "did you mean slider-crank-velocity?");
  CHECK(did_you_mean("v", {"v_A", "v_B", "a"}).english == "known are: v_A, v_B, a");
  CHECK(did_you_mean("none of it", std::vector<std::string>(20, "zz")).english.ends_with(", ..."));
}

TEST_CASE("capitals are A to Z, and no other bytes are touched") {
  for (int byte = 0; byte < 256; ++byte) {
    const char c = static_cast<char>(byte);
    const std::size_t capital = std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ").find(c);
    const char lower = capital == std::string::npos ? c : std::string("abcdefghijklmnopqrstuvwxyz")[capital];
    CHECK(lower_case({c}) == std::string{lower});
  }
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

namespace {

// A crank's angle and the instant that states it too; a pressure angle that stands alone.
const std::vector<GivenSpec> crank_specs{
    {.symbol = "n", .meaning = {"speed", "velocità"}, .unit = "rpm", .stated = "360", .range = Range::any},
    {.symbol = "t", .meaning = {"instant", "istante"}, .unit = "s", .stated = "1/72", .also = {"t1"}},
    {.symbol = "phi",
     .meaning = {"angle", "angolo"},
     .unit = "deg",
     .stated = "",
     .range = Range::any,
     .turned = TurnedThrough{.instant = "t", .speed = "n"}},
    {.symbol = "alpha", .meaning = {"angle", "angolo"}, .unit = "deg", .stated = "22", .also = {"pressure_angle"}}};

Givens with(const std::vector<std::string>& assignments) {
  Givens givens(crank_specs);
  for (const std::string& assignment : assignments) givens.set(assignment);
  return givens;
}

std::string shown(const Givens& givens, const std::string& symbol) {
  const auto reading = givens.reading(symbol);
  return reading ? geometry::to_text(reading->number) + " " + reading->unit.symbol : "none";
}

}  // namespace

TEST_CASE("an angle follows from the instant, or the instant from the angle") {
  struct Row {
    std::vector<std::string> assignments;
    const char* t;
    const char* phi;
    Angle angle;
  };
  const Row rows[] = {
      {{}, "1/72 s", "30 deg", {Rational(1, 12)}},
      {{"phi=75deg"}, "5/144 s", "75 deg", {Rational(5, 24)}},
      {{"n=400rpm", "phi=75"}, "1/32 s", "75 deg", {Rational(5, 24)}},
      {{"phi=75", "n=400rpm"}, "1/32 s", "75 deg", {Rational(5, 24)}},
      {{"n=400rpm"}, "1/72 s", "100/3 deg", {Rational(5, 54)}},
      {{"t=1/60"}, "1/60 s", "36 deg", {Rational(1, 10)}},
      {{"t1=1/60"}, "1/60 s", "36 deg", {Rational(1, 10)}},
      {{"phi=-765deg"}, "-17/48 s", "-765 deg", {Rational(-17, 8)}},
      {{"phi=0"}, "0 s", "0 deg", {}},
      {{"n=0", "phi=75"}, "none", "75 deg", {Rational(5, 24)}},
      {{"n=30rad/s"}, "1/72 s", "5/12 rad", {0, Rational(5, 12)}},
      {{"n=30rad/s", "phi=0,75rad"}, "1/40 s", "3/4 rad", {0, Rational(3, 4)}},
      {{"n=30rad/s", "phi=75deg"}, "none", "75 deg", {Rational(5, 24)}},
      {{"n=30rad/s", "phi=0"}, "0 s", "0 deg", {}},
      {{"phi=1rad"}, "none", "1 rad", {0, 1}},
  };
  for (const Row& row : rows) {
    CAPTURE(row.assignments);
    const Givens givens = with(row.assignments);
    CHECK(shown(givens, "t") == row.t);
    CHECK(shown(givens, "phi") == row.phi);
    CHECK(givens.angle("phi") == row.angle);
  }
}

TEST_CASE("of an angle and an instant one is set, not both") {
  for (const auto& both : std::vector<std::vector<std::string>>{{"t=1/72", "phi=30"}, {"phi=30", "t1=1/72"}})
    CHECK_THROWS_WITH(with(both), Contains("phi") && Contains("two ways to state one thing"));
}

TEST_CASE("what is stated in another way is as stated") {
  CHECK(with({"phi=30deg"}).as_stated());
  CHECK(with({"phi=1/12turn"}).as_stated());
  CHECK_FALSE(with({"phi=30.000001deg"}).as_stated());
  CHECK_FALSE(with({"phi=390deg"}).as_stated());
  CHECK_FALSE(with({"phi=0.5236rad"}).as_stated());
  CHECK_FALSE(with({"n=400rpm", "phi=100/3deg"}).as_stated());
  CHECK_FALSE(with({"n=37.7rad/s"}).as_stated());
  CHECK(with({"phi=30deg"}).follows("t"));
  CHECK_FALSE(with({"phi=30deg"}).follows("phi"));
  CHECK(with({}).follows("phi"));
  CHECK_FALSE(with({}).follows("alpha"));
}

TEST_CASE("a given has one name; the others are read, and not repeated") {
  CHECK(with({"pressure_angle=20"}).angle("alpha") == Angle{Rational(1, 18)});
  CHECK_THROWS_WITH(with({"t1=-1"}), StartsWith("t = -1: must be positive"));
  CHECK_THROWS_WITH(with({"t1=5m"}), StartsWith("t: \"5m\" is a length where a time is asked"));
}

TEST_CASE("a number across π keeps its unit, and its limits") {
  CHECK(shown(with({"n=37.7rad/s"}), "n") == "377/10 rad/s");
  CHECK(shown(with({"n=6Hz"}), "n") == "360 rpm");
  CHECK_THROWS_WITH(with({"n=1e13rad/s"}), Contains("between 1e-12 and 1e12 rad/s"));
  CHECK_THROWS_WITH(with({"alpha=-0.1rad"}), Contains("must be positive"));
}
