// The slider-crank's numbers: complete, certain, by two routes, and those of a corpus that shares no code with them.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "geometry/numbers/given.h"
#include "tests/exercises/slider_crank_cases.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

using namespace epure;
using namespace epure::tests;
using geometry::Settled;

namespace {

// What each exercise must report, with its unit.
struct Promised {
  std::string unit;
  std::vector<std::string> names;
};
const std::vector<Promised> velocities{
    {"rad/s", {"omega_2", "omega_3"}},
    {"rad", {"crank_angle_phi", "coupler_angle"}},
    {"deg", {"crank_angle_phi_deg"}},
    {"m/s",
     {"v_A", "v_B_x", "v_B_y", "v_B", "v_C", "v_M", "v_C_x", "v_C_y", "v_M_x", "v_M_y", "v_BA", "v_CA", "v_MA"}},
    {"m", {"A_x", "A_y", "B_x", "B_y", "C_x", "C_y", "M_x", "M_y", "P0_x", "P0_y", "P0A", "P0B", "P0C", "P0M"}}};
const std::vector<Promised> accelerations{{"m/s^2",
                                           {"a_A", "a_B_x", "a_B_y", "a_B", "a_C_x", "a_C_y", "a_C", "a_M_x", "a_M_y",
                                            "a_M", "a_BA_n", "a_BA_t", "a_BA", "a_CA", "a_MA"}},
                                          {"rad/s^2", {"alpha_3"}},
                                          {"rad", {"gamma"}},
                                          {"m",
                                           {"P0_x",
                                            "P0_y",
                                            "K_x",
                                            "K_y",
                                            "KA",
                                            "KB",
                                            "KC",
                                            "KM",
                                            "P0C",
                                            "P0M",
                                            "inflection_diameter",
                                            "inflection_pole_x",
                                            "inflection_pole_y",
                                            "inflection_centre_x",
                                            "inflection_centre_y",
                                            "stationarity_diameter",
                                            "stationarity_centre_x",
                                            "stationarity_centre_y",
                                            "Cprime_C",
                                            "rho_C",
                                            "curvature_centre_C_x",
                                            "curvature_centre_C_y",
                                            "Cprime_x",
                                            "Cprime_y",
                                            "Mprime_M",
                                            "rho_M",
                                            "curvature_centre_M_x",
                                            "curvature_centre_M_y",
                                            "Mprime_x",
                                            "Mprime_y"}}};

double ulp(double x) { return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x); }

void is_certain(const CheckedQuantity& quantity) {
  CAPTURE(quantity.spec.name, quantity.settled.reason.english);
  std::set<std::string> routes;
  for (const RouteValue& value : quantity.routes) routes.insert(value.route);
  CHECK(routes.size() >= 2);
  const auto& [lower, value, upper] = quantity.settled.enclosure;
  if (quantity.settled.kind == Settled::Kind::absent) {
    CHECK_FALSE(quantity.settled.reason.english.empty());
    return;
  }
  REQUIRE(quantity.settled.kind == Settled::Kind::certain);
  CHECK(std::isfinite(value));
  CHECK(lower <= value);
  CHECK(value <= upper);
  CHECK(upper - lower <= 4 * ulp(value));
  CHECK_FALSE((value == 0 && std::signbit(value)));
}

// A case of the corpus as assignments. Instants before 0 or within a picosecond of it cannot be given: a whole turn
// later everything but the crank angle is the same.
struct Stated {
  std::vector<std::string> assignments;
  bool a_turn_later;
};
Stated stated(const CorpusCase& c) {
  Stated all{{}, c.givens.at("t1") < exact_decimal("1e-12") && c.givens.at("t1") != 0};
  for (const auto& [symbol, value] : c.givens) {
    const Rational shift = symbol == "t1" && all.a_turn_later ? CGAL::abs(60 / c.givens.at("n")) : Rational(0);
    all.assignments.push_back(symbol + "=" + geometry::to_text(value + shift));
  }
  return all;
}

// The same in another notation, as JSON: every number finite.
void has_only_numbers(const nlohmann::json& json) {
  if (json.is_number()) CHECK(std::isfinite(json.get<double>()));
  if (json.is_string()) {
    CHECK(json.get<std::string>().find("nan") == std::string::npos);
    CHECK(json.get<std::string>().find("inf ") == std::string::npos);
  }
  if (json.is_structured())
    for (const auto& [key, value] : json.items()) has_only_numbers(value);
}

struct Ran {
  int exit;
  std::string out, err;
};
Ran run(std::vector<std::string> arguments, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    arguments.push_back("--set");
    arguments.push_back(assignment);
  }
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), arguments, out, err);
  return {exit, out.str(), err.str()};
}

}  // namespace

TEST_CASE("the slider-crank reports what it promises, certainly and by two routes", "[slider-crank]") {
  for (const auto& [id, promised] : {std::pair{of_velocity, velocities}, std::pair{of_acceleration, accelerations}}) {
    const CheckedExercise result = checked(id, {});
    CAPTURE(id, complaints(result));
    CHECK(result.passed());
    for (const Promised& group : promised)
      for (const std::string& name : group.names) {
        const CheckedQuantity* quantity = find(result, name);
        INFO(name);
        REQUIRE(quantity);
        CHECK(quantity->spec.unit == group.unit);
        is_certain(*quantity);
        CHECK(quantity->settled.kind == Settled::Kind::certain);
      }
  }
}

TEST_CASE("the slider-crank passes with whatever can be given", "[slider-crank]") {
  for (const Try& with : tries())
    for (const std::string& id : {of_velocity, of_acceleration}) {
      const CheckedExercise result = checked(id, with.assignments);
      CAPTURE(id, with.why, complaints(result));
      CHECK(result.passed());
      for (const CheckedQuantity& quantity : result.quantities) is_certain(quantity);
    }
}

TEST_CASE("the slider-crank's values are the corpus', to the last bit of a double", "[slider-crank]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/slider_crank.txt");
  int cases = 0, values = 0, absent = 0;
  for (const CorpusCase& c : corpus) {
    if (!c.reference("closure_gap").empty() || c.reference("omega_3") == "undefined") continue;
    ++cases;
    const auto [assignments, a_turn_later] = stated(c);
    for (const std::string& id : {of_velocity, of_acceleration}) {
      const CheckedExercise result = checked(id, assignments);
      CAPTURE(c.name, c.why, id, complaints(result));
      CHECK(result.passed());
      for (const CheckedQuantity& quantity : result.quantities) {
        const std::string& name = quantity.spec.name;
        if (a_turn_later && name.starts_with("crank_angle")) continue;
        const std::string reference = c.reference(name);
        CAPTURE(name, reference);
        REQUIRE_FALSE(reference.empty());
        if (reference == "infinite" || reference == "undefined") {
          ++absent;
          CHECK(quantity.settled.kind == Settled::Kind::absent);
        } else {
          ++values;
          REQUIRE(quantity.settled.kind == Settled::Kind::certain);
          CHECK(quantity.settled.enclosure.value == std::stod(reference));
        }
      }
    }
  }
  CHECK(cases >= 88);
  CHECK(values > 6500);
  CHECK(absent >= 130);
}

TEST_CASE("what does not exist says why, and no report holds NaN or infinity", "[slider-crank]") {
  for (const Try& with : tries()) {
    CAPTURE(with.why);
    const bool has_alpha = std::any_of(with.assignments.begin(), with.assignments.end(),
                                       [](const std::string& text) { return text.starts_with("alpha_2"); });
    std::vector<std::string> checks{"check", of_acceleration, "--json"};
    if (!has_alpha) checks.insert(checks.begin() + 1, of_velocity);
    const Ran ran = run(checks, with.assignments);
    CHECK(ran.exit == 0);
    CHECK(ran.err.empty());
    const nlohmann::json report = nlohmann::json::parse(ran.out);
    has_only_numbers(report);
    for (const nlohmann::json& each : report["exercises"])
      for (const nlohmann::json& quantity : each["quantities"])
        CHECK(quantity["value"].is_null() == quantity.contains("absent"));
  }
  // The pole at infinity takes its circle with it, and says so.
  for (const std::string instant : {"t1=1/24s", "t1=1/8s"}) {
    const CheckedExercise first = checked(of_velocity, {instant}), second = checked(of_acceleration, {instant});
    for (const std::string name : {"P0_x", "P0_y", "P0A", "P0B", "P0C", "P0M"}) {
      CHECK(find(first, name)->settled.kind == Settled::Kind::absent);
      CHECK(find(first, name)->settled.reason.english.find("at infinity") != std::string::npos);
    }
    for (const std::string name : {"inflection_diameter", "inflection_pole_x", "Cprime_C", "Mprime_x"})
      CHECK(find(second, name)->settled.kind == Settled::Kind::absent);
    CHECK(find(first, "omega_3")->settled.enclosure.value == 0);
    CHECK(find(second, "KA")->settled.kind == Settled::Kind::certain);
  }
  for (const std::string instant : {"t1=0", "t1=1/12s"}) {
    const CheckedExercise second = checked(of_acceleration, {instant});
    CHECK(find(second, "alpha_3")->settled.enclosure.value == 0);
    CHECK(find(second, "stationarity_diameter")->settled.kind == Settled::Kind::absent);
    CHECK(find(second, "stationarity_diameter")->settled.reason.english.find("is a line") != std::string::npos);
  }
}

TEST_CASE("the impossible is one clear sentence and exit code 2", "[slider-crank]") {
  struct Refused {
    std::vector<std::string> assignments;
    std::vector<std::string> says;
  };
  const std::vector<Refused> all{
      {{"r=0.4", "l=0.2", "AC=0.15", "BC=0.1", "t1=1/24"},
       {"does not close", "90°", "too short by 0.2 m", "from -30° to 30° and from 150° to 210°"}},
      // A is 0.1 + 0.15 m from the guide, then 0.2 + 0.15; arcsin of -0.1/0.2 and of 0.4/0.2.
      {{"l=0.25", "AC=0.2", "BC=0.15", "e=-0.15"}, {"square to the guide", "30°"}},
      {{"l=0.25", "AC=0.2", "BC=0.15", "e=-0.15", "t1=1/24"}, {"too short by 0.1 m", "from -210° to 30°"}},
      // Two and three turns on, and three back.
      {{"l=0.25", "AC=0.2", "BC=0.15", "e=-0.15", "phi=810"}, {"810°", "too short by 0.1 m", "from 510° to 750°"}},
      {{"l=0.25", "AC=0.2", "BC=0.15", "e=-0.15", "phi=-990"},
       {"-990°", "too short by 0.1 m", "from -930° to -690°"}},
      {{"l=0.25", "AC=0.2", "BC=0.15", "e=0.15", "delta=10", "t1=7/54"},
       {"too short by 0.1 m", "280°", "from -20° to 220°"}},
      {{"e=0.9"}, {"does not close", "closes at no angle", "0.9 m from A₀"}},
      {{"e=x"}, {"e"}},
      {{"delta=20m"}, {"delta"}},
      // 0.4 sin 40° - 0.2 = 0.0571150 m
      {{"r=0.4", "l=0.2", "AC=0.15", "BC=0.1", "t1=1/54"}, {"does not close", "too short by 0.0571 m"}},
      // By 1e-19 of a metre, less than a double between the two lengths shows.
      {{"r=1", "l=0.9999999999999999999", "AC=0.7", "BC=0.7", "n=60", "t=0.25"}, {"too short by 1e-19 m"}},
      {{"r=0.4", "l=0.2", "AC=0.15", "BC=0.1", "t1=1/72"}, {"square to the guide", "30°"}},
      // Crank and coupler square to the guide: s = r cos ψ ± √(l² - (r sin ψ - e)²) by hand, to the first order.
      {{"l=0.2", "AC=0.15", "BC=0.1", "t1=1/24"},
       {"change point", "90°", "ω₃/ω₂ = 1 and v_B/ω₂ = 0 m, or ω₃/ω₂ = -1 and v_B/ω₂ = -0.4 m"}},
      {{"l=0.2", "AC=0.15", "BC=0.1", "phi=-90"}, {"ω₃/ω₂ = 1 and v_B/ω₂ = 0 m, or ω₃/ω₂ = -1 and v_B/ω₂ = 0.4 m"}},
      {{"r=0.3", "e=-0.2", "phi=90"},
       {"ω₃/ω₂ = 0.774597 and v_B/ω₂ = 0.0872983 m, or ω₃/ω₂ = -0.774597 and v_B/ω₂ = -0.687298 m"}},
      {{"r=0.5", "l=0.4", "e=0.9", "phi=90"}, {"closes at this angle alone, and cannot move"}},
      {{"AC=0.05"}, {"the plate ABC does not close", "AB = 0.5 m", "AC + BC = 0.45 m", "by 0.05 m"}},
      {{"BC=1"}, {"the plate ABC does not close", "BC = 1 m", "AB + AC = 0.8 m", "by 0.2 m"}},
      {{"AC=1"}, {"the plate ABC does not close", "AC = 1 m", "AB + BC = 0.9 m", "by 0.1 m"}},
      {{"r=0"}, {"r = 0", "must be positive"}},
      {{"r=-1"}, {"r = -1", "must be positive"}},
      {{"n=0"}, {"n = 0", "must turn"}},
      {{"t1=-1/72"}, {"t = -1/72", "must not be negative"}}};
  for (const auto& [assignments, says] : all)
    for (const std::string& id : {of_velocity, of_acceleration})
      for (const std::vector<std::string>& verb : {std::vector<std::string>{"check", id},
                                                   {"check", id, "--json"},
                                                   {"draw", id + "/poles", "-o", "-", "--format", "svg"}}) {
        const Ran ran = run(verb, assignments);
        CAPTURE(verb, assignments, ran.err);
        CHECK(ran.exit == 2);
        CHECK(ran.out.empty());
        CHECK(ran.err.starts_with("epure: "));
        CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
        for (const std::string& words : says) CHECK(ran.err.find(words) != std::string::npos);
      }
}

TEST_CASE("a crank at rest is refused, with what to do when its acceleration is given", "[slider-crank]") {
  const Ran ran = run({"check", of_acceleration}, {"n=0", "alpha_2=5"});
  CHECK(ran.exit == 2);
  for (const char* words : {"n = 0 rpm", "the crank must turn", "also where alpha_2 is given", "n = 1e-9"})
    CHECK(ran.err.find(words) != std::string::npos);
  // What it says to do: at rest only alpha_2 counts, a_A = 5 rad/s² 0.2 m.
  const Ran slow = run({"check", of_acceleration}, {"n=1e-9", "alpha_2=5"});
  CHECK(slow.exit == 0);
  CHECK(slow.out.find(" 1 m/s^2 ") != std::string::npos);
}

// Clockwise instead of counter-clockwise the mechanism passes mirror images of its positions; C, always on the left
// of AB, is no mirror image, but A, B and M are.
TEST_CASE("a crank that turns the other way mirrors the motion", "[slider-crank]") {
  const CheckedExercise here = checked(of_velocity, {}), there = checked(of_velocity, {"n=-360"});
  const CheckedExercise here_2 = checked(of_acceleration, {"alpha_2=100"}),
                        there_2 = checked(of_acceleration, {"n=-360", "alpha_2=-100"});
  const auto value = [](const CheckedExercise& in, const std::string& name) {
    return find(in, name)->settled.enclosure.value;
  };
  for (const std::string name :
       {"A_x", "B_x", "M_x", "P0_x", "P0A", "P0M", "v_A", "v_B", "v_M", "v_BA", "v_B_x", "v_M_x"})
    CHECK(value(there, name) == value(here, name));
  for (const std::string name :
       {"A_y", "M_y", "P0_y", "omega_2", "omega_3", "coupler_angle", "v_M_y", "crank_angle_phi"})
    CHECK(value(there, name) == -value(here, name));
  for (const std::string name : {"a_B_x", "a_M_x", "a_M", "K_x", "KB", "inflection_diameter", "stationarity_diameter",
                                 "inflection_pole_x", "rho_M", "curvature_centre_M_x"})
    CHECK(value(there_2, name) == value(here_2, name));
  for (const std::string name : {"alpha_3", "a_M_y", "K_y", "gamma", "inflection_centre_y", "curvature_centre_M_y"})
    CHECK(value(there_2, name) == -value(here_2, name));
}
