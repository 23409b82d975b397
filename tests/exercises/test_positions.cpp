// The crank's place, stated by an instant or by an angle, in turns or in radians, in every exercise that has one; and
// the givens as reports and sheets name them.
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "drawings/page.h"
#include "drawings/text/text.h"
#include "exercises/cli/run.h"
#include "tests/exercises/held_against_corpus.h"
#include "tests/support/catch.h"

using namespace epure;
using namespace epure::tests;

namespace {

struct Answer {
  int exit;
  std::string out, err;
};
Answer ask(const std::string& verb, const std::string& id, const Assignments& assignments,
           const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{verb, id};
  for (const std::string& assignment : assignments) arguments.insert(arguments.end(), {"--set", assignment});
  arguments.insert(arguments.end(), more.begin(), more.end());
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), arguments, out, err);
  return {exit, out.str(), err.str()};
}

Assignments joined(Assignments all, const Assignments& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

const std::vector<std::string> with_an_instant{"slider-crank-velocity", "slider-crank-acceleration", "four-bar"};
const std::vector<std::string> with_an_angle{
    "slider-crank-velocity", "slider-crank-acceleration", "four-bar", "four-bar-analytic", "four-bar-constraints",
    "rivals-polygons",       "velocity-centre",           "roulette", "cycloid-involute"};

std::string column(const DrawnSheet& drawn) { return std::get<drawings::Paragraph>(drawn.sheet.column[1]).text; }

}  // namespace

TEST_CASE("an angle and its instant give the same report, byte for byte", "[positions]") {
  struct Same {
    Assignments with, instant, angle;
  };
  const Same all[] = {
      {{"n=360rpm"}, {"t=1/24s"}, {"phi=90deg"}},    {{"n=360rpm"}, {"t1=5/144s"}, {"phi=75deg"}},
      {{"n=400rpm"}, {"t=1/32s"}, {"phi=75°"}},      {{"n=400rpm"}, {"t=1/80"}, {"phi=1/12turn"}},
      {{"n=360"}, {"t=85/432s"}, {"phi=425deg"}},    {{"n=-30rpm"}, {"t=0,5s"}, {"phi=-90"}},
      {{"n=30rad/s"}, {"t=1/40s"}, {"phi=0,75rad"}}, {{"n=30rad/s"}, {"t=1/4s"}, {"phi=7.5rad"}},
  };
  for (const std::string& id : with_an_instant)
    for (const Same& same : all) {
      if (id == "four-bar" && same.instant.front().starts_with("t1")) continue;
      CAPTURE(id, same.with, same.instant);
      for (const std::vector<std::string>& how : {std::vector<std::string>{}, {"--json"}}) {
        const Answer by_instant = ask("check", id, joined(same.with, same.instant), how),
                     by_angle = ask("check", id, joined(same.with, same.angle), how);
        CHECK(by_instant.exit == 0);
        CHECK((by_instant.out == by_angle.out));
      }
    }
}

TEST_CASE("both instants of the involute are stated by angles as well", "[positions]") {
  const std::string id = "cycloid-involute";
  CHECK(ask("check", id, {"phi_1=7rad", "phi_2=14rad"}).out == ask("check", id, {}).out);
  CHECK(ask("check", id, {"omega_2=477rpm", "phi_1=100deg"}).exit == 0);
  CHECK(ask("check", id, {"phi_1=100deg", "phi_2=2,5rad"}).exit == 0);
  CHECK(ask("check", id, {"phi_1=7", "phi_2=14"}).out == ask("check", id, {}).out);
  CHECK(ask("check", id, {"phi_1=-1rad"}).exit == 2);
}

TEST_CASE("the source's position by its angle is the source's, with its printed numbers", "[positions]") {
  for (const auto& [id, phi] :
       std::vector<std::pair<std::string, std::string>>{{"slider-crank-velocity", "phi=30deg"},
                                                        {"slider-crank-acceleration", "phi=1/12rev"},
                                                        {"four-bar", "phi=30"}})
    CHECK((ask("check", id, {phi}).out == ask("check", id, {}).out));
}

TEST_CASE("every exercise with a crank takes its angle, in any unit, and passes", "[positions]") {
  for (const std::string& id : with_an_angle)
    for (const std::string phi :
         {"phi=75deg", "phi=-285deg", "phi=1.3rad", "phi=-1,3rad", "phi=5/24rev", "phi=795"}) {
      if (id == "cycloid-involute" && phi.find('-') != std::string::npos) continue;  // its wheel starts at φ = 0
      CAPTURE(id, phi);
      const Answer answer = ask("check", id, {phi});
      CHECK(answer.exit == 0);
      CHECK(answer.err.empty());
    }
}

TEST_CASE("old names are read, the one name is told", "[positions]") {
  struct Old {
    const char *id, *old_name, *name;
  };
  for (const auto& [id, old_name, name] : {Old{"slider-crank-velocity", "t1=1/60", "t=1/60"},
                                           {"slider-crank-acceleration", "t1=1/60s", "t=1/60s"},
                                           {"four-bar-analytic", "theta_2=75", "phi=75"},
                                           {"four-bar-constraints", "theta_2=25deg", "phi=25"},
                                           {"velocity-centre", "angle=75", "phi=75"}}) {
    CAPTURE(id, old_name);
    const Answer answer = ask("check", id, {old_name});
    CHECK(answer.exit == 0);
    CHECK(answer.out == ask("check", id, {name}).out);
    const std::string symbol(name, std::string_view(name).find('='));
    CHECK(answer.out.find(" " + symbol + " = ") != std::string::npos);
    CHECK(ask("check", id, {old_name, name}).err == "epure: " + symbol + " is set twice; which value is meant?\n");
    // A long line is broken between words.
    const std::string listed = std::regex_replace(ask("list", id, {}).out, std::regex("\\s+"), " ");
    CHECK(listed.find("(also " + std::string(old_name, std::string_view(old_name).find('='))) != std::string::npos);
  }
  CHECK(ask("check", "slider-crank-velocity", {"t=0.01", "phi=75"}).exit == 2);
}

TEST_CASE("JSON tells a given under its one name, with its others", "[positions]") {
  const auto givens = [](const std::string& id, const Assignments& assignments) {
    return nlohmann::json::parse(ask("check", id, assignments, {"--json"}).out)["exercises"][0]["givens"];
  };
  const auto find = [](const nlohmann::json& all, const std::string& symbol) {
    for (const auto& given : all)
      if (given["symbol"] == symbol) return given;
    return nlohmann::json();
  };
  const auto stated = givens("slider-crank-velocity", {});
  CHECK(find(stated, "t") ==
        nlohmann::json{{"symbol", "t"}, {"value", "1/72"}, {"number", 1.0 / 72}, {"unit", "s"}, {"also", {"t1"}}});
  CHECK(find(stated, "phi") == nlohmann::json{{"symbol", "phi"}, {"value", "30"}, {"number", 30.0}, {"unit", "deg"}});
  CHECK(find(stated, "r") == nlohmann::json{{"symbol", "r"}, {"value", "1/5"}, {"number", 0.2}, {"unit", "m"}});
  const auto in_radians = givens("slider-crank-velocity", {"n=37.7rad/s", "phi=75deg"});
  CHECK(find(in_radians, "n") ==
        nlohmann::json{{"symbol", "n"}, {"value", "377/10"}, {"number", 37.7}, {"unit", "rad/s"}});
  CHECK(find(in_radians, "t").is_null());  // 75 deg at 37.7 rad/s: no fraction of a second
  CHECK(find(in_radians, "phi")["value"] == "75");
}

// By mpmath, 30 digits, from the textbook's formulas: sin β = (r/l) sin φ, ω₃ = -ω₂ r cos φ/(l cos β),
// v_B = -ω₂ r sin φ + ω₃ l sin β.
TEST_CASE("radians stay exact", "[positions]") {
  const Tried slider_crank("slider-crank-velocity");
  const CheckedExercise result = slider_crank.checked({"n=37.7rad/s", "phi=1.3rad"});
  CHECK(result.passed());
  CHECK(value(result, "omega_2") == 37.7);
  CHECK(value(result, "crank_angle_phi") == 1.3);
  CHECK(value(result, "omega_3") == -4.37163537731879015195672655543);
  CHECK(value(result, "v_B") == 8.10769372834061477962261318202);
  // 30 rpm is π rad/s, and a wheel turned through π/2.
  const CheckedExercise rolled = Tried("roulette").checked({"omega=30rpm", "phi=0.25rev", "how=circle_on_line"});
  CHECK(rolled.passed());
  CHECK(value(rolled, "v_M_x") == 0.471238898038468985769396507492);  // π r
  const CheckedExercise guide = slider_crank.checked({"delta=0.5rad"});
  CHECK(guide.passed());
  CHECK(guide.givens.text("delta") == "1/2");
}

TEST_CASE("a sheet states what was stated, as it was typed", "[positions]") {
  const auto says = [](const std::string& id, const std::string& sheet, const Assignments& assignments,
                       Language language = Language::english) {
    return column(Tried(id).draw(sheet, assignments, {.language = language}));
  };
  const std::string blank = "\u00a0", id = "slider-crank-velocity";
  const auto equation = [&](const std::string& letters, const std::string& number) {
    return letters + blank + "=" + blank + number;
  };
  const std::string stated = says(id, "poles", {});
  CHECK_THAT(stated, Contains(equation("$t$", "1/72" + blank + "s")));
  CHECK_THAT(stated, !Contains("$φ$"));
  const std::string angle = says(id, "poles", {"n=37.7rad/s", "phi=75deg", "delta=0,5rad"});
  CHECK_THAT(angle, Contains(equation("$φ$", "75°")));
  CHECK_THAT(angle, Contains(equation("$n$", "37.7" + blank + "rad/s")));
  CHECK_THAT(angle, Contains(equation("$δ$", "0.5" + blank + "rad")));
  CHECK_THAT(angle, !Contains("$t$"));
  CHECK_THAT(says(id, "poles", {"r=0,25"}, Language::italian), Contains(equation("$r$", "0,25" + blank + "m")));
  CHECK_THAT(says(id, "poles", {"r=0.1234567"}), Contains(equation("$r$", "0.1234567" + blank + "m")));
  CHECK_THAT(says(id, "poles", {"r=2/9"}), Contains(equation("$r$", "2/9" + blank + "m")));
  CHECK_THAT(says(id, "poles", {"e=-0.012345678901"}), Contains(equation("$e$", "−0.012345678901" + blank)));
  CHECK_THAT(says(id, "poles", {"r=0.21234567890123456"}),
             Contains("$r$" + blank + "≈" + blank + "0.2123456789" + blank + "m"));
}

TEST_CASE("givens of forty digits stay on the sheet", "[positions][sheets]") {
  const std::string digits = "0123456789012345678901234567890123456789";
  const std::vector<std::pair<std::string, Assignments>> all{
      {"slider-crank-velocity",
       {"r=0.2" + digits, "l=0.5" + digits, "AC=0.3" + digits, "BC=0.4" + digits, "n=360." + digits,
        "e=0.01" + digits, "phi=31." + digits, "delta=-0.1" + digits + "rad"}},
      {"slider-crank-acceleration",
       {"r=1" + digits + "/5" + digits, "alpha_2=-100." + digits, "phi=0.6" + digits + "rad"}},
      {"four-bar", {"A0A=0.15" + digits, "x_B0=-0.18" + digits, "t=0.1" + digits}},
      {"four-bar-analytic", {"A0B0=0.8" + digits, "phi=20." + digits}},
      {"rivals-polygons", {"AG=-0.25" + digits, "alpha_2=3" + digits.substr(0, 10) + "/7" + digits.substr(0, 10)}},
      {"roulette", {"phi=160." + digits, "phi_rad=0.1" + digits, "omega=30." + digits + "rpm"}},
      {"gear-pair", {"m=10." + digits, "alpha=0.38" + digits + "rad", "x1=0.1" + digits, "j=0.02" + digits}},
      {"velocity-centre", {"L=0.8" + digits, "omega_dot=-3." + digits, "V=12." + digits}},
      {"pin-in-slot", {"M1=30." + digits, "J2=1." + digits, "omega=1." + digits}},
      {"cycloid-involute", {"d=1." + digits, "omega_2=477." + digits + "rpm", "t1=0.14" + digits}},
  };
  for (const auto& [id, assignments] : all) {
    const Tried tried(id);
    for (const SheetSpec& sheet : tried.about().sheets)
      for (const Language language : {Language::english, Language::italian}) {
        CAPTURE(id, sheet.name, language == Language::english);
        const drawings::Page page =
            drawings::compose(tried.draw(sheet.name, assignments, {.language = language}).sheet);
        constexpr double frame = 10;  // mm from the paper's edge, at least
        for (const drawings::Primitive& primitive : page.primitives) {
          const auto* text = std::get_if<drawings::PlacedText>(&primitive);
          if (!text) continue;
          CAPTURE(text->text);
          CHECK(text->baseline.x >= page.extent.low.x + frame);
          CHECK(text->baseline.x + drawings::measure(text->text, text->size, text->weight).width <=
                page.extent.high.x - frame);
        }
      }
  }
}
