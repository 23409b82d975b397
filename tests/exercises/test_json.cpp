// check --json against its schema, epure.check/1.
#include <nlohmann/json.hpp>
#include <set>

#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;
using nlohmann::json;

namespace {

std::set<std::string> keys(const json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

// Only these keys, and all but the optional ones.
void has_keys(const json& object, const std::set<std::string>& needed, const std::set<std::string>& optional = {}) {
  const auto present = keys(object);
  for (const std::string& name : needed) {
    INFO(name << " in " << object.dump());
    CHECK(present.contains(name));
  }
  for (const std::string& name : present) {
    INFO(name << " in " << object.dump());
    CHECK((needed.contains(name) || optional.contains(name)));
  }
}

bool is_number_or_null(const json& value) { return value.is_number() || value.is_null(); }

void has_value_keys(const json& object) {
  for (const std::string name : {"value", "lower", "upper"}) CHECK(is_number_or_null(object.at(name)));
  if (object.at("value").is_number() && object.at("lower").is_number()) {
    CHECK(object["lower"].get<double>() <= object["value"].get<double>());
    CHECK(object["value"].get<double>() <= object["upper"].get<double>());
  }
  CHECK((object.contains("absent") || object.contains("undecided")) >= object.at("value").is_null());
  CHECK(object.contains("absent") <= object.at("value").is_null());
}

void holds_schema(const json& report) {
  has_keys(report, {"schema", "epure", "exercises"});
  CHECK(report.at("schema") == "epure.check/1");
  REQUIRE(report.at("exercises").is_array());
  REQUIRE_FALSE(report["exercises"].empty());
  for (const json& exercise : report["exercises"]) {
    has_keys(exercise, {"id", "source", "givens", "quantities", "passed"}, {"failures", "undecided"});
    CHECK(exercise["passed"] == !(exercise.contains("failures") || exercise.contains("undecided")));
    has_keys(exercise.at("source"), {"document", "item"});
    CHECK(exercise.at("passed").is_boolean());
    REQUIRE_FALSE(exercise.at("givens").empty());
    for (const json& given : exercise["givens"]) {
      has_keys(given, {"symbol", "value", "unit"}, {"number"});
      CHECK(given.at("value").is_string());
    }
    REQUIRE_FALSE(exercise.at("quantities").empty());
    for (const json& quantity : exercise["quantities"]) {
      has_keys(quantity, {"name", "symbol", "unit", "value", "lower", "upper", "routes"},
               {"on_sheet", "printed", "measured", "absent", "undecided"});
      has_value_keys(quantity);
      REQUIRE(quantity.at("routes").is_array());
      for (const json& route : quantity["routes"]) {
        has_keys(route, {"route", "value", "lower", "upper"}, {"absent", "undecided"});
        has_value_keys(route);
      }
      if (quantity.contains("on_sheet")) has_keys(quantity["on_sheet"], {"value", "resolution"});
      for (const json& printed : quantity.value("printed", json::array())) {
        has_keys(printed, {"text", "route", "difference_percent", "verdict"}, {"explanation"});
        CHECK(std::set<std::string>{"rounding", "reading", "disagrees"}.contains(printed.at("verdict")));
      }
      for (const json& measured : quantity.value("measured", json::array()))
        has_keys(measured, {"text", "value", "difference", "difference_percent", "allowed", "allowed_by", "verdict"});
    }
  }
}

json parsed(const Ran& ran) {
  CHECK(ran.err.empty());
  CHECK(ran.out.ends_with("}\n"));
  json report = json::parse(ran.out);
  holds_schema(report);
  return report;
}

json report(std::vector<std::string> arguments, int exit = 0) {
  arguments.insert(arguments.begin(), {"check", "triangle", "--json"});
  const Ran ran = run(arguments);
  CHECK(ran.exit == exit);
  return parsed(ran)["exercises"][0];
}

}  // namespace

TEST_CASE("the report of the triangle, number by number") {
  const json triangle = report({});
  CHECK(triangle["id"] == "triangle");
  CHECK(triangle["source"] == json{{"document", "euclid"}, {"item", "I.47"}});
  CHECK(triangle["givens"][0] == json{{"symbol", "a"}, {"value", "3/10"}, {"unit", "m"}, {"number", 0.3}});
  CHECK(triangle["givens"][2] == json{{"symbol", "load"}, {"value", "0"}, {"unit", "N"}, {"number", 0}});
  CHECK(triangle["passed"] == true);
  const json& c = triangle["quantities"][0];
  CHECK(c["name"] == "c");
  CHECK(c["symbol"] == "c₀");
  CHECK(c["value"] == 0.5);
  CHECK(c["lower"] == 0.5);
  CHECK(c["upper"] == 0.5);
  CHECK(c["routes"][0] == json{{"route", "ruler"}, {"value", 0.5}, {"lower", 0.5}, {"upper", 0.5}});
  CHECK(c["routes"][1]["route"] == "analytic");
  CHECK(std::abs(c["on_sheet"]["value"].get<double>() - 0.5) <= c["on_sheet"]["resolution"].get<double>());
  CHECK(c["on_sheet"]["resolution"].get<double>() < 1e-4);
  CHECK(c["printed"].size() == 2);
  CHECK(c["printed"][0]["verdict"] == "rounding");
  CHECK(c["printed"][1]["verdict"] == "reading");
  CHECK(c["printed"][1]["difference_percent"].get<double>() == Approx(2));
  CHECK_FALSE(c["printed"][1].contains("explanation"));
  const json& c_y = triangle["quantities"][2];
  CHECK(c_y["value"] == -0.4);
  CHECK(c_y["on_sheet"]["value"].get<double>() < 0);
  CHECK(c_y["printed"][0]["verdict"] == "disagrees");
  CHECK(c_y["printed"][0]["explanation"] == "the catheti were added");
  CHECK_FALSE(triangle["quantities"][3].contains("on_sheet"));
  CHECK_FALSE(triangle["quantities"][3].contains("printed"));
}

TEST_CASE("numbers are written with the fewest digits that read back the same") {
  const std::string text = run({"check", "triangle", "--json", "--set", "a=0.1"}).out;
  CHECK(text.find("\"value\": 0.1,") != std::string::npos);
  CHECK(text.find("0.1000000000000000") == std::string::npos);
}

TEST_CASE("other givens are reported, and the source's numbers are not") {
  const json triangle = report({"--set", "a=25cm"});
  CHECK(triangle["givens"][0]["value"] == "1/4");
  CHECK(triangle["givens"][0]["number"] == 0.25);
  for (const json& quantity : triangle["quantities"]) CHECK_FALSE(quantity.contains("printed"));
}

TEST_CASE("list as JSON tells what exercises state, whatever the language") {
  const Ran ran = run({"list", "--json"});
  CHECK(ran.exit == 0);
  const json all = json::parse(ran.out);
  CHECK(all["schema"] == "epure.list/1");
  CHECK(all["epure"] == json::parse(run({"check", "triangle", "--json"}).out)["epure"]);
  CHECK(all["epure"]["libraries"].contains("Cairo"));
  REQUIRE(all["exercises"].size() == 1);
  const json& triangle = all["exercises"][0];
  CHECK(triangle["question"] == "Find the hypotenuse.");
  CHECK(triangle["givens"][0] == json{{"symbol", "a"},
                                      {"value", "3/10"},
                                      {"unit", "m"},
                                      {"number", 0.3},
                                      {"letters", "a"},
                                      {"meaning", "base"},
                                      {"range", "positive"}});
  CHECK(triangle["givens"][2]["range"] == "not negative");
  CHECK(triangle["quantities"][0]["symbol"] == "c₀");
  CHECK(run({"list", "triangle", "--json", "--lang", "it"}).out == ran.out);
  const json two = json::parse(run_on_two({"list", "other", "triangle", "--json"}).out)["exercises"];
  CHECK(two[0]["id"] == "other");
  CHECK(two[1]["id"] == "triangle");
  CHECK(run_on_two({"list", "--json"}).out == run_on_two({"list", "all", "--json"}).out);
}

TEST_CASE("a failed check is JSON all the same") {
  Triangle wrong;
  wrong.spoil_values = [](auto& values) { value_of(values, "c", "analytic") = certain(0.6); };
  const Ran ran = run_on(wrong, {"check", "triangle", "--json"});
  CHECK(ran.exit == 1);
  const json exercise = parsed(ran)["exercises"][0];
  CHECK(exercise["passed"] == false);
  CHECK(exercise["failures"] == json{"c: in [0.5, 0.5] by ruler, but in [0.6, 0.6] by analytic"});
}

TEST_CASE("what is absent or undecided is null, and says why") {
  Triangle open;
  open.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) {
      value_of(values, "omega", route) = absent("it does not turn");
      value_of(values, "angle", route) = undecided("whether it turns");
    }
  };
  const Ran ran = run_on(open, {"check", "triangle", "--json"});
  CHECK(ran.exit == 4);
  const json exercise = parsed(ran)["exercises"][0], quantities = exercise["quantities"];
  CHECK(quantities[3]["value"].is_null());
  CHECK(quantities[3]["upper"].is_null());
  CHECK(quantities[3]["absent"] == "it does not turn");
  CHECK(quantities[4]["value"].is_null());
  CHECK_FALSE(quantities[4].contains("absent"));
  CHECK(quantities[4]["undecided"] == "whether it turns");
  CHECK(quantities[4]["routes"][1]["undecided"] == "whether it turns");
  CHECK(exercise["undecided"] == json{"angle: undecided by ruler, analytic (whether it turns)"});
}

TEST_CASE("a quantity that one route alone decides has its value, and the doubt") {
  Triangle open;
  open.spoil_values = [](auto& values) { value_of(values, "angle", "ruler") = undecided("whether it turns"); };
  const json angle = parsed(run_on(open, {"check", "triangle", "--json"}))["exercises"][0]["quantities"][4];
  CHECK(angle["value"] == 0.75);
  CHECK(angle["undecided"] == "angle: undecided by ruler (whether it turns)");
}

TEST_CASE("JSON is English in every language") {
  const auto json_in = [](const std::string& language) {
    return run({"check", "triangle", "--json", "--lang", language, "--measured", "c=0.6"}).out;
  };
  CHECK(json_in("it") == json_in("en"));
}

TEST_CASE("the arithmetic decides the bounds") {
  const json fast = report({"--arithmetic", "fast"})["quantities"][0];
  CHECK(fast["value"] == 0.5);
  CHECK(fast["lower"].is_null());
  CHECK(fast["routes"][0]["upper"].is_null());
  const json bounded = report({"--arithmetic", "bounded"})["quantities"][0];
  CHECK(bounded["lower"].get<double>() < 0.5);
  CHECK(bounded["upper"].get<double>() > 0.5);
}

TEST_CASE("measured numbers stand with their quantity") {
  const json c = report({"--measured", "c=0.52m", "--measured", "c=0.5"}, 1)["quantities"][0];
  REQUIRE(c["measured"].size() == 2);
  CHECK(c["measured"][0]["text"] == "0.52m");
  CHECK(c["measured"][0]["value"] == 0.52);
  CHECK(c["measured"][0]["difference_percent"].get<double>() == Approx(4));
  CHECK(c["measured"][0]["allowed"].get<double>() == Approx(0.01));
  CHECK(c["measured"][0]["verdict"] == "beyond reading");
  CHECK(c["measured"][1]["verdict"] == "within reading");
}

TEST_CASE("several exercises stand in the order asked for, each once") {
  const json both = parsed(run_on_two({"check", "triangle", "all", "--json"}));
  REQUIRE(both["exercises"].size() == 2);
  CHECK(both["exercises"][0]["id"] == "triangle");
  CHECK(both["exercises"][1]["id"] == "other");
}

TEST_CASE("wrong usage leaves standard output empty also with --json") {
  const Ran ran = run({"check", "triangle", "--json", "--set", "a=0"});
  CHECK(ran.exit == 2);
  CHECK(ran.out.empty());
}
