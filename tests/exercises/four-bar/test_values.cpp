// The four-bar's numbers: those of a corpus that knows positions only, to the last bit, by two routes or more.
#include <nlohmann/json.hpp>
#include <sstream>

#include "exercises/cli/run.h"
#include "tests/exercises/four-bar/cases.h"

using namespace epure;
using namespace epure::tests;
using geometry::Settled;

namespace {

// Of the quantity itself, or of the position that does not exist and that its name begins with.
std::string reference_for(const CorpusCase& c, const std::string& quantity) {
  for (const Reference& each : c.references) {
    if (each.name == quantity) return each.value;
    if (each.name.ends_with('*') && quantity.starts_with(each.name.substr(0, each.name.size() - 1)))
      return each.value;
  }
  return {};
}

bool is_none(const std::string& reference) {
  return reference == "infinite" || reference == "undefined" || reference == "absent";
}

struct Ran {
  int exit;
  std::string out, err;
};
Ran run(std::vector<std::string> arguments, const Assignments& assignments) {
  for (const std::string& assignment : assignments) {
    arguments.push_back("--set");
    arguments.push_back(assignment);
  }
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), arguments, out, err);
  return {exit, out.str(), err.str()};
}

void has_only_numbers(const nlohmann::json& json) {
  if (json.is_number()) CHECK(std::isfinite(json.get<double>()));
  if (json.is_structured())
    for (const auto& [key, each] : json.items()) has_only_numbers(each);
}

const std::string& why_absent(const CheckedExercise& in, const std::string& name) {
  const CheckedQuantity& quantity = find(in, name);
  CAPTURE(name);
  CHECK(quantity.settled.kind == Settled::Kind::absent);
  return quantity.settled.reason.english;
}

}  // namespace

TEST_CASE("four-bar: values are the corpus', to the last bit of a double, by every route", "[four-bar]") {
  int values = 0, none = 0;
  for (const CorpusCase& c : four_bar_corpus()) {
    const CheckedExercise result = four_bar().checked(assignments_of(c));
    CAPTURE(c.name, c.why, complaints(result));
    CHECK(result.passed());
    for (const CheckedQuantity& quantity : result.quantities) {
      const std::string reference = reference_for(c, quantity.spec.name);
      CAPTURE(quantity.spec.name, reference, quantity.settled.reason.english);
      REQUIRE_FALSE(reference.empty());
      is_the_reference(quantity, is_none(reference) ? "infinite" : reference);
      ++(is_none(reference) ? none : values);
    }
  }
  CHECK(four_bar_corpus().size() == 27);
  CHECK(values > 6000);
  CHECK(none > 400);
}

TEST_CASE("four-bar: units", "[four-bar]") {
  const CheckedExercise result = four_bar().checked({});
  const std::vector<std::pair<std::string, std::vector<std::string>>> promised{
      {"rad/s", {"omega_2", "omega_3", "omega_4", "dead_centre_folded.omega_3"}},
      {"rad", {"crank_angle_phi", "rocker_swing", "dead_centre_extended.crank_angle"}},
      {"deg", {"gamma_deg", "parallel_links.same_sense_main_branch_crank_angle_deg"}},
      {"m/s", {"v_A", "v_B", "v_BA", "v_C_x"}},
      {"rad/s^2", {"alpha_3", "alpha_4"}},
      {"m/s^2", {"a_B_n", "a_B_t", "a_C", "mirror_side_a_C"}},
      {"m", {"P31A", "KB", "rho_C", "inflection_diameter", "mirror_side_KC"}},
      {"1", {"tan_gamma", "time_ratio", "slider_crank_ratio_3.K_x_over_r"}}};
  for (const auto& [unit, names] : promised)
    for (const std::string& name : names) {
      CAPTURE(name);
      CHECK(find(result, name).spec.unit == unit);
    }
}

TEST_CASE("four-bar: no report holds NaN or infinity", "[four-bar]") {
  for (const CorpusCase& c : four_bar_corpus()) {
    CAPTURE(c.name);
    const Ran ran = run({"check", "four-bar", "--json"}, assignments_of(c));
    CHECK(ran.exit == 0);
    CHECK(ran.err.empty());
    const nlohmann::json report = nlohmann::json::parse(ran.out);
    has_only_numbers(report);
    for (const nlohmann::json& quantity : report["exercises"][0]["quantities"])
      CHECK(quantity["value"].is_null() == quantity.contains("absent"));
  }
}

// Everything seen in a mirror along the x axis.
TEST_CASE("four-bar: the mirror image of the linkage has the mirror image of its motion", "[four-bar]") {
  const CheckedExercise here = four_bar().checked({"alpha_2=3", "C_side=left"}),
                        there = four_bar().checked({"alpha_2=-3", "n=-50", "y_B0=0.16", "branch=left"});
  int turned = 0;
  for (const CheckedQuantity& quantity : here.quantities) {
    const std::string& name = quantity.spec.name;
    if (!has_value(quantity.settled) || name.starts_with("slider_crank")) continue;
    CAPTURE(name);
    const double one = quantity.settled.enclosure.value, other = value(there, name);
    const auto ends = [&](const char* end) { return name.ends_with(end); };
    // Angles from 0 to a full turn, and rotations from one place to another.
    if (ends("crank_angle") || name == "crank_rotation_extended_to_folded") {
      CHECK(one + other == Approx(2 * std::numbers::pi));
    } else if (ends("crank_angle_deg")) {
      CHECK(one + other == Approx(360));
    } else if (ends("_y") || name.find("omega_") != std::string::npos || name.find("alpha_") != std::string::npos ||
               ends("_angle") || ends("_angle_deg") || name.starts_with("crank_angle_phi") || ends("tan_gamma") ||
               ends("gamma_deg")) {
      CHECK(one == -other);
      turned += one != 0 ? 1 : 0;
    } else {
      CHECK(one == other);
    }
  }
  CHECK(turned > 60);
}

TEST_CASE("four-bar: at a dead centre the rocker stands still", "[four-bar]") {
  for (const Assignments& assignments : {Assignments{}, {"branch=left", "alpha_2=3"}}) {
    const CheckedExercise result = four_bar().checked(assignments);
    for (const std::string at : {"dead_centre_extended.", "dead_centre_folded."}) {
      CAPTURE(at);
      for (const char* zero : {"omega_4", "v_B", "v_B_x", "v_B_y", "a_B_n", "P31B"})
        CHECK(value(result, at + zero) == 0);
      CHECK(value(result, at + "P31_x") == value(result, at + "B_x"));
      CHECK(value(result, at + "a_B") == value(result, at + "a_B_t"));
    }
  }
}

TEST_CASE("four-bar: with crank and rocker parallel the pole is at infinity, and says so", "[four-bar]") {
  // Crank along +x to A = (2, 0), B at (5, 4), rocker along +x and along -x.
  for (const Assignments& assignments :
       {Assignments{"A0A=2", "AB=5", "B0B=4", "x_B0=1", "y_B0=4", "t=0", "AC=3"},
        Assignments{"A0A=2", "AB=5", "B0B=4", "x_B0=9", "y_B0=4", "t=0", "AC=3", "branch=left", "alpha_2=3"}}) {
    const CheckedExercise result = four_bar().checked(assignments);
    CAPTURE(assignments, complaints(result));
    CHECK(result.passed());
    CHECK(value(result, "omega_3") == 0);
    for (const char* name : {"P31_x", "P31_y", "P31A", "P31B", "P31C", "mirror_side_P31C"})
      CHECK(why_absent(result, name).find("at infinity") != std::string::npos);
    for (const char* name : {"inflection_diameter", "stationarity_diameter", "inflection_pole_x"})
      why_absent(result, name);
    CHECK(why_absent(result, "tan_gamma").find("ω₃ is zero") != std::string::npos);
    CHECK(find(result, "KA").settled.kind == Settled::Kind::certain);
  }
}

TEST_CASE("four-bar: a dead centre by lengths in whole numbers", "[four-bar]") {
  // A0A = 3 on +x, B at (8, 0), B0 at (8, 4).
  const CheckedExercise result =
      four_bar().checked({"A0A=3", "AB=5", "B0B=4", "x_B0=8", "y_B0=4", "t=0", "AC=4", "branch=right"});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(value(result, "omega_4") == 0);
  CHECK(value(result, "B_x") == 8);
  CHECK(value(result, "P31_x") == 8);
  CHECK(value(result, "P31B") == 0);
}

TEST_CASE("four-bar: positions that are change points do not count", "[four-bar]") {
  // A parallelogram: where its hinges come in line it may fold.
  const CheckedExercise result =
      four_bar().checked({"A0A=0.2", "AB=0.5", "B0B=0.2", "x_B0=0.3", "y_B0=0.4", "AC=0.3", "t=0.3", "branch=left"});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(value(result, "omega_3") == 0);
  CHECK(value(result, "omega_4") == value(result, "omega_2"));
  for (const char* at : {"dead_centre_extended.", "dead_centre_folded."})
    CHECK(why_absent(result, std::string(at) + "omega_3").find("change point") != std::string::npos);
  CHECK(why_absent(result, "rocker_swing").find("no crank-rocker") != std::string::npos);
}

TEST_CASE("four-bar: linkages without a dead centre say why", "[four-bar]") {
  const CheckedExercise drag =
      four_bar().checked({"A0A=0.3", "AB=0.35", "B0B=0.32", "x_B0=0.1", "y_B0=0.05", "AC=0.21"});
  CHECK_FALSE(why_absent(drag, "dead_centre_extended.crank_angle").empty());
  CHECK_FALSE(why_absent(drag, "dead_centre_folded.crank_angle").empty());
  CHECK_FALSE(why_absent(drag, "time_ratio").empty());
}

TEST_CASE("four-bar: the impossible is one clear sentence and exit code 2", "[four-bar]") {
  struct Refused {
    Assignments assignments;
    std::vector<std::string> says;
  };
  // At 30 degrees A is (0.1299, 0.075), 0.3888 m from B0: sqrt(0.30990² + 0.235²) = 0.388924.
  const std::vector<Refused> all{
      {{"AB=0.2", "AC=0.1", "B0B=0.1"},
       {"does not close", "30°", "AB + B₀B = 0.3 m", "too short by 0.0889 m",
        "; it closes from -125.732° to -40.8108° and from 124.078° to 208.999°"}},
      {{"A0A=1", "AB=2", "B0B=1", "x_B0=4", "y_B0=0", "AC=1", "t=0.3"}, {"; it closes at 0° only"}},
      {{"AB=0.9", "B0B=0.4", "x_B0=-0.3", "y_B0=0"}, {"differ by 0.5 m", "; it closes at no angle"}},
      // By 1e-19 of a metre, which no double between the two lengths shows.
      {{"A0A=1", "AB=2.9999999999999999999", "B0B=1", "x_B0=5", "y_B0=0", "t=0.6", "C_side=left", "AC=1"},
       {"too short by 2 m"}},
      {{"A0A=1", "AB=2.9999999999999999999", "B0B=1", "x_B0=5", "y_B0=0", "t=0", "AC=1"}, {"too short by 1e-19 m"}},
      {{"AB=0.9", "B0B=0.4"}, {"does not close", "differ by 0.5 m", "by 0.111 m"}},
      {{"AC=0.38"}, {"no right angle at C", "AC = 0.38 m", "AB = 0.37 m"}},
      {{"lambda=1"}, {"lambda = 1", "lambda > 1"}},
      {{"lambda=0.5"}, {"lambda = 0.5", "lambda > 1"}},
      {{"n=0"}, {"n = 0", "must turn"}},
      {{"x_B0=0", "y_B0=0"}, {"B₀ = (0, 0) m lies on A₀"}},
      {{"A0A=3", "AB=5", "B0B=5", "x_B0=13", "y_B0=0", "t=0"}, {"in line", "in this position alone"}},
      {{"A0A=3", "AB=2", "B0B=3", "x_B0=4", "y_B0=0", "AC=1", "phi=90"}, {"in line", "cannot drive"}},
      {{"A0A=3", "AB=9", "B0B=1", "x_B0=11", "y_B0=0", "t=0"}, {"in line", "change point", "two motions"}},
      {{"A0A=0"}, {"A0A = 0", "must be positive"}},
      {{"AB=-1"}, {"AB = -1", "must be positive"}},
      {{"AC=0"}, {"AC = 0", "must be positive"}},
      {{"branch=up"}, {"branch", "left", "right"}},
      {{"C_side=1"}, {"C_side", "left", "right"}}};
  for (const auto& [assignments, says] : all)
    for (const std::vector<std::string>& verb : {std::vector<std::string>{"check", "four-bar"},
                                                 {"check", "four-bar", "--json"},
                                                 {"draw", "four-bar/poles", "-o", "-", "--format", "svg"}}) {
      const Ran ran = run(verb, assignments);
      CAPTURE(verb, assignments, ran.err);
      CHECK(ran.exit == 2);
      CHECK(ran.out.empty());
      CHECK(ran.err.starts_with("epure: "));
      CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
      for (const std::string& words : says) CHECK(ran.err.find(words) != std::string::npos);
    }
}

// By the textbook: γ is what turns an acceleration into the ray to K, tan γ = α/ω². The two rays are the report's
// own.
TEST_CASE("four-bar: γ leads from a_A to the ray AK, as described", "[four-bar]") {
  for (const Assignments& given : {Assignments{}, {"n=-50"}, {"t=0.37"}, {"branch=left"}, {"alpha_2=3"}}) {
    const CheckedExercise result = four_bar().checked(given);
    const auto of = [&](const char* name) { return find(result, name).settled.enclosure.value; };
    const double to_K = std::atan2(of("K_y") - of("C_y"), of("K_x") - of("C_x")),
                 a_C = std::atan2(of("a_C_y"), of("a_C_x"));
    CAPTURE(given);
    CHECK(std::remainder(to_K - a_C - of("gamma_deg") * std::numbers::pi / 180, 2 * std::numbers::pi) ==
          Approx(0).margin(1e-12));
    CHECK(find(result, "gamma_deg").spec.meaning.english == "angle from a_A to the ray AK");
  }
}

TEST_CASE("four-bar: a measured number is taken or refused", "[four-bar]") {
  CHECK(run({"check", "four-bar", "--measured", "v_B=0.866"}, {}).exit == 0);
  CHECK(run({"check", "four-bar", "--measured", "v_B=1.2"}, {}).exit == 1);
  CHECK(run({"check", "four-bar", "--measured", "no_such=1"}, {}).exit == 2);
}

// A centred crank-rocker, A₀A² + A₀B₀² = AB² + B₀B²: its strokes take equally long. And a parallelogram does not
// turn.
TEST_CASE("four-bar: a ratio of one, and an angle that has no value", "[four-bar]") {
  const CheckedExercise centred = four_bar().checked({"A0A=1", "AB=4", "B0B=7", "x_B0=8", "y_B0=0", "AC=2", "t=0.1"});
  CHECK(find(centred, "time_ratio").settled.kind == Settled::Kind::certain);
  CHECK(find(centred, "time_ratio").settled.enclosure.value == 1);
  for (const RouteValue& route : find(centred, "time_ratio").routes)
    CHECK(route.settled.kind != Settled::Kind::undecided);

  const CheckedExercise parallelogram = four_bar().checked(
      {"A0A=1", "AB=4", "B0B=1", "x_B0=4", "y_B0=0", "AC=2", "t=0.1", "branch=left", "C_side=left"});
  CHECK(parallelogram.passed());
  CHECK(why_absent(parallelogram, "gamma_deg").find("no value") != std::string::npos);
  CHECK(why_absent(parallelogram, "tan_gamma").find("no value") != std::string::npos);
}
