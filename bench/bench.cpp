#include "bench/bench.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include "bench/corpus_folder.h"
#include "bench/curves.h"
#include "bench/many_positions.h"
#include "bench/measured.h"
#include "bench/sheet_times.h"
#include "bench/sweep.h"

namespace epure::bench {
namespace {

// "model name : AMD EPYC ..." of the first processor.
std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != line.npos)
      return line.substr(colon + 2);
  return "unknown processor";
}

Machine machine() {
#if defined(__clang__)
  const std::string compiler = "Clang " __clang_version__;
#else
  const std::string compiler = "GCC " __VERSION__;
#endif
  return {processor(), compiler, std::max(std::thread::hardware_concurrency(), 1U)};
}

// In the family of the sweep, fast and bounded are timed as a sweep is run: the givens read once, ten thousand
// positions after each other.
void time_as_sweep(std::vector<FamilyResult>& rows, double budget) {
  const SweepTimes times = time_sweep(budget);
  constexpr double results = 10;  // of a position in this family; the sweep finds A, B and C besides
  for (FamilyResult& row : rows) {
    if (row.family != "four-bar-second-order") continue;
    if (row.number == "fast") row.ns_per_result = times.fast_ns / results;
    if (row.number == "bounded") row.ns_per_result = times.bounded_ns / results;
  }
}

}  // namespace

Report run_bench(const Catalogue& exercises, double seconds,
                 const std::function<void(const std::string&)>& progress) {
  Report report;
  report.machine = machine();
  const std::vector<FamilyJob> jobs = family_jobs();
  const double for_families = 0.5 * seconds, for_curves = 0.15 * seconds;
  for (const FamilyJob& job : jobs) {
    progress(job.name);
    const double each = for_families / (4 * static_cast<double>(jobs.size()));
    const std::vector<FamilyResult> rows = job.measure(corpus_folder().string(), each);
    report.families.insert(report.families.end(), rows.begin(), rows.end());
    if (const DecisionResult decisions = job.decide(corpus_folder().string()); decisions.asked > 0)
      report.decisions.push_back(decisions);
  }
  progress("sweep");
  time_as_sweep(report.families, 0.02 * seconds);
  progress("positions");
  report.positions = measure_positions(corpus_folder().string(), 0.05 * seconds);
  progress("curves");
  report.curves = measure_curves(seconds < 10 ? 2 : 5, for_curves);
  progress("sheets");
  constexpr double seconds_for_a_run = 1.5;  // epure twice and the floor, for each exercise
  const int runs = std::clamp(static_cast<int>(0.25 * seconds / seconds_for_a_run), seconds < 1 ? 1 : 3, 15);
  try {
    report.sheets = measure_sheets(exercises, runs);
    if (report.sheets.empty()) report.no_sheets = "epure and epure-floor are not beside this program";
  } catch (const std::exception& sick) {  // of another program; what is measured stays
    report.no_sheets = sick.what();
  }
  return report;
}

}  // namespace epure::bench
