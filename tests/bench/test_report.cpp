// What the bench measures and says. Nothing here depends on how long something takes.
#include "bench/bench.h"
#include "bench/benchmark.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/curves.h"
#include "bench/families.h"
#include "bench/measured.h"
#include "drawings/output.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/exercise.h"
#include "tests/support/catch.h"

namespace epure::tests {
namespace {

using namespace bench;
using Json = nlohmann::json;

// As a bench of a minute says, with every extreme: nothing wrong, everything wrong, nothing promised.
Report example() {
  Report report;
  report.machine = {"Processor of an Example 1234 64-Core", "GCC 12.2.0", 64};
  const std::vector<std::string> families{"four-bar-position",
                                          "four-bar-second-order",
                                          "slider-crank-second-order",
                                          "pole-and-circles",
                                          "curvature",
                                          "polode-point",
                                          "coupler-curve-point",
                                          "roulette-point",
                                          "gear-flank-point",
                                          "vector-polygon",
                                          "circles",
                                          "cancelling"};
  double spread = 1;
  for (const std::string& family : families) {
    spread *= 1.3;
    const WorstResult worst{"parallel-missed-by-1e-30: x_centre", 1.2345678e17, -3.2e-12};
    report.families.push_back({family, "fast", 40 * spread, 1e-3 * spread * spread, 1e-16, {}, 0, 120, 17, worst});
    report.families.push_back({family, "bounded", 160 * spread, 1e-7 / spread, 1e-17, 0.9, 0.3, 120, 0, worst});
    report.families.push_back({family, "deep", 7000 * spread, 1e-35, 1e-38, 1e-31, 0.2, 120, 0, worst});
    report.families.push_back({family, "exact", 90000 * spread, 0, 0, 0.0, 0.1, 120, 0, worst});
  }
  for (const std::string& family : families)
    report.decisions.push_back({family, 400, 1, 210, 60, 129, 2.6, "dead-centre-offset-before-1e-30: room_to_guide"});
  report.positions.push_back({"four-bar by hand", "fast", 46.4, 1e-14, {}});
  report.positions.push_back({"four-bar by hand", "bounded", 147, 1e-14, 1e-13});
  for (const char* curve : {"cycloid", "involute", "coupler curve", "polode"})
    for (int i = 0; i < 5; ++i) {
      const double tolerance = std::pow(10, -4 - i), scale = std::pow(10, i);
      report.curves.push_back({curve, tolerance, 0.8 * tolerance, 0.7 * tolerance,
                               static_cast<std::size_t>(20 * std::pow(scale, 0.25)), 1.5, 700,
                               i == 4 ? 0 : static_cast<std::size_t>(100 * std::sqrt(scale)), 0.2, 9000});
    }
  for (const char* sheet : {"slider-crank-acceleration/polar-diagram", "four-bar/poles", "gear-pair/wheels"})
    report.sheets.push_back({sheet, 36.2, 24.5, {12, 0.3, 0.5, 3.5, 2.6, 2.7, 6.9, 6.8, 1.2}});
  return report;
}

struct Ran {
  int exit;
  std::string out, err;
};
Ran run(const std::vector<std::string>& arguments) {
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), arguments, out, err, {.bench = benchmark});
  return {exit, out.str(), err.str()};
}

class Folder {
 public:
  Folder() { std::filesystem::remove_all(path_); }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() / "epure-test-bench";
};

}  // namespace

TEST_CASE("the JSON has the schema's keys and no others") {
  const Report report = example();
  const Json json = Json::parse(json_of(report));
  CHECK(json.at("schema") == "epure.bench/1");
  CHECK(json.size() == 2);
  REQUIRE(json.at("results").size() == report.families.size());
  for (const Json& each : json.at("results")) {
    CHECK(each.size() == 6);
    const std::string number = each.at("number");
    CHECK((number == "fast" || number == "bounded" || number == "deep" || number == "exact"));
    CHECK(each.at("family").is_string());
    CHECK(each.at("ns_per_result").is_number());
    CHECK(each.at("max_relative_error").is_number());
    CHECK(each.at("handed_over").is_number());
    CHECK(each.at("max_relative_bound").is_null() == (number == "fast"));
  }
}

TEST_CASE("the table has a row for each family and number, each curve and each sheet") {
  const Report report = example();
  const std::string text = text_of(report);
  CHECK(text.find("GCC 12.2.0") != text.npos);
  for (const char* expected : {"four-bar-second-order", "30 % of 120", "none", "coupler curve", "1.48", "9.0e-01"}) {
    INFO(expected);
    CHECK(text.find(expected) != text.npos);
  }
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  CHECK(lines == 2 + (1 + report.families.size()) + 1 + (1 + report.decisions.size()) + 1 +
                     (1 + report.positions.size()) + 1 + (1 + report.curves.size()) + 1 + (1 + report.sheets.size()));
}

TEST_CASE("what is short to say is said shortly") {
  CHECK(short_time(0.04) == "0.04 ns");
  CHECK(short_time(1234) == "1.23 µs");
  CHECK(short_time(5.6e6) == "5.6 ms");
  CHECK(short_time(7.8e9) == "7.8 s");
  CHECK(short_error(0) == "0");
  CHECK(short_error(1.26e-16) == "1.3e-16");
  CHECK(short_error(INFINITY) == "∞");
}

TEST_CASE("the bench's sheets are drawn without one label on another") {
  for (const auto paper : {drawings::Paper::a4, drawings::Paper::a3})
    for (const auto language : {Language::english, Language::italian})
      for (const drawings::Sheet& sheet : sheets_of(example(), language, paper)) {
        INFO(sheet.id);
        const std::vector<std::string> conflicts = drawings::overlaps(sheet);
        for (const std::string& conflict : conflicts) UNSCOPED_INFO(conflict);
        CHECK(conflicts.empty());
        for (const drawings::Mark& mark : sheet.figure.marks)
          if (const auto* writing = std::get_if<drawings::Writing>(&mark))
            CHECK(writing->baseline.y > drawings::drawing_area(paper).low.y);
        CHECK(drawings::svg(sheet).find("<svg") != std::string::npos);
      }
}

TEST_CASE("every family is measured, with every number") {
  std::vector<std::string> families, measured;
  for_each_family([&](const auto& family) { families.emplace_back(family.name); });
  for (const FamilyJob& job : family_jobs()) measured.push_back(job.name);
  std::sort(families.begin(), families.end());
  std::sort(measured.begin(), measured.end());
  CHECK(families == measured);
}

TEST_CASE("errors made lie within the bounds promised, and doubles are seen to fail") {
  for (const FamilyJob& job : family_jobs()) {
    INFO(job.name);
    const std::vector<FamilyResult> rows = job.measure(EPURE_HARD_CORPUS, 1e-4);
    REQUIRE(rows.size() == 4);
    for (const FamilyResult& row : rows) {
      INFO(row.number);
      CHECK(row.family == job.name);
      CHECK(row.results >= 10);
      CHECK(row.results == rows.front().results);
      CHECK(row.ns_per_result > 0);
      CHECK(row.handed_over >= 0);
      CHECK(row.handed_over <= 1);
      if (row.max_relative_bound) CHECK(row.max_relative_error <= *row.max_relative_bound);
      if (row.number != "fast") CHECK(row.wrong == 0);
    }
    CHECK(!rows[0].max_relative_bound);
    CHECK(rows[0].max_relative_error > 1e-8);  // the corpora are hard
    CHECK(rows[1].max_relative_bound.value() <= 1);
    CHECK(rows[2].max_relative_bound.value() <= 1e-30);
    CHECK(rows[2].max_relative_error > 0);
    CHECK(rows[3].max_relative_error == 0);
    CHECK(rows[1].handed_over > 0);
  }
}

// In vector-polygon the lines that miss being parallel by 1e-22 and 1e-30 have a meeting point; doubles give up.
TEST_CASE("what doubles cannot give counts as wrong") {
  for (const FamilyJob& job : meeting_jobs())
    if (job.name == "vector-polygon") CHECK(job.measure(EPURE_HARD_CORPUS, 1e-4)[0].wrong >= 16);
}

TEST_CASE("the deviation of a drawn curve, looked for, is within the one promised, and that within the one asked") {
  const std::vector<CurveResult> curves = measure_curves(2, 1e-4);
  CHECK(curves.size() == 8);
  for (const CurveResult& each : curves) {
    INFO(each.curve << ' ' << each.tolerance);
    CHECK(each.proved <= each.tolerance);
    CHECK(each.verified <= each.proved + 1e-12);  // the true points are doubles
    CHECK(each.verified > each.proved / 1000);
    CHECK(each.arcs > 3);
    CHECK(each.uniform_lines > each.arcs);
    CHECK(each.uniform_bytes > 0);
  }
}

TEST_CASE("a bench that was asked for wrongly says so at once") {
  CHECK(run({"bench", "--help"}).exit == 0);
  CHECK(run({"bench", "--help"}).out.find("--seconds") != std::string::npos);
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{{"bench", "--frobnicate"},
                                                                                     {"bench", "circles"},
                                                                                     {"bench", "--seconds", "soon"},
                                                                                     {"bench", "--seconds", "0"},
                                                                                     {"bench", "--format", "png"},
                                                                                     {"bench", "--paper", "a0"},
                                                                                     {"bench", "--lang", "fr"},
                                                                                     {"bench", "--out", ""}}) {
    const Ran ran = run(wrong);
    INFO(wrong.back());
    CHECK(ran.exit == 2);
    CHECK(ran.out.empty());
    CHECK(ran.err.find("measuring") == std::string::npos);
  }
}

TEST_CASE("a short bench writes its sheets, prints JSON alone, and says meanwhile what it measures", "[slow]") {
  const Folder folder;
  const Ran ran = run({"bench", "--json", "--seconds", "0.01", "--out", folder.path().string()});
  CHECK(ran.exit == 0);
  CHECK(Json::parse(ran.out).at("results").size() == 4 * family_jobs().size());
  CHECK(ran.err.find("measuring circles") != std::string::npos);
  for (const char* name : {"bench.pdf", "bench-speed-against-error.svg", "bench-worst-errors.svg", "bench-curves.svg",
                           "bench-whole-sheets.svg"}) {
    INFO(name);
    CHECK(std::filesystem::file_size(folder.path() / name) > 1000);
  }
}

TEST_CASE("a bench whose sheets cannot be written says so before it measures") {
  const Ran ran = run({"bench", "--seconds", "0.01", "--out", "/dev/null/bench"});
  CHECK(ran.exit == 3);
  CHECK(ran.err.find("cannot write") != std::string::npos);
  CHECK(ran.err.find("measuring") == std::string::npos);
}

}  // namespace epure::tests
