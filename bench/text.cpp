#include <fmt/format.h>

#include <cmath>

#include "bench/bench.h"
#include "exercises/cli/columns.h"

namespace epure::bench {

std::string short_time(double ns) {
  if (ns < 999.5) return fmt::format("{:.3g} ns", ns);
  if (ns < 1e6) return fmt::format("{:.3g} µs", ns / 1e3);
  if (ns < 1e9) return fmt::format("{:.3g} ms", ns / 1e6);
  return fmt::format("{:.3g} s", ns / 1e9);
}

std::string short_error(double error) {
  if (error == 0) return "0";
  return std::isfinite(error) ? fmt::format("{:.1e}", error) : "∞";
}

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows families(const Report& report) {
  Rows rows{{"FAMILY", "NUMBER", "TIME PER RESULT", "LARGEST ERROR", "LARGEST BOUND", "HANDED OVER", "WRONG"}};
  for (const FamilyResult& each : report.families) {
    const bool repeated = rows.size() > 1 && each.number != "fast";
    rows.push_back({repeated ? "" : each.family, each.number, short_time(each.ns_per_result),
                    each.settled_any() ? short_error(each.max_relative_error) : "–",
                    each.max_relative_bound ? short_error(*each.max_relative_bound) : "none",
                    fmt::format("{:.0f} % of {}", 100 * each.handed_over, each.results), std::to_string(each.wrong)});
  }
  return rows;
}

Rows decisions(const Report& report) {
  Rows rows{{"DECISIONS", "ASKED", "BOUNDED", "DEEP", "OTHERWISE", "UNDECIDED", "SLOWEST", "WHICH"}};
  for (const DecisionResult& each : report.decisions)
    rows.push_back({each.family, std::to_string(each.asked), std::to_string(each.by_bounded),
                    std::to_string(each.by_deep), std::to_string(each.otherwise), std::to_string(each.undecided),
                    short_time(1e6 * each.slowest_ms), each.slowest});
  return rows;
}

Rows positions(const Report& report) {
  Rows rows{{"MECHANISM", "NUMBER", "TIME PER POSITION", "LARGEST ERROR", "LARGEST BOUND"}};
  for (const PositionResult& each : report.positions)
    rows.push_back({each.mechanism, each.number, short_time(each.ns), short_error(each.max_relative_error),
                    each.max_relative_bound ? short_error(*each.max_relative_bound) : "none"});
  return rows;
}

Rows curves(const Report& report) {
  Rows rows{{"CURVE", "TOLERANCE", "PROVED", "VERIFIED", "ARCS", "TIME", "BYTES", "UNIFORM LINES", "TIME", "BYTES"}};
  for (const CurveResult& each : report.curves)
    rows.push_back({each.curve, short_error(each.tolerance), short_error(each.proved), short_error(each.verified),
                    std::to_string(each.arcs), short_time(1e6 * each.ms), std::to_string(each.bytes),
                    each.uniform_lines > 0 ? std::to_string(each.uniform_lines) : ">1e5",
                    each.uniform_lines > 0 ? short_time(1e6 * each.uniform_ms) : "–",
                    each.uniform_lines > 0 ? std::to_string(each.uniform_bytes) : "–"});
  return rows;
}

Rows sheets(const Report& report) {
  Rows rows{{"SHEET", "EPURE", "FLOOR", "RATIO", "start", "other", "construction", "layout", "fonts", "text", "pdf",
             "svg", "files"}};
  for (const SheetResult& each : report.sheets) {
    std::vector<std::string> row{each.sheet, fmt::format("{:.1f} ms", each.epure_ms),
                                 fmt::format("{:.1f} ms", each.floor_ms),
                                 fmt::format("{:.2f}", each.epure_ms / each.floor_ms)};
    for (const double part : each.parts_ms) row.push_back(fmt::format("{:.1f}", part));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::string text_of(const Report& report) {
  const Machine& on = report.machine;
  std::string text = fmt::format("{}, {} cores, {}\n\n", on.processor, on.cores, on.compiler) +
                     columns(families(report)) + "\n" + columns(decisions(report)) + "\n" +
                     columns(positions(report)) + "\n" + columns(curves(report));
  text += "\n" + (report.sheets.empty() ? "whole sheets: not measured, " + report.no_sheets + "\n"
                                        : columns(sheets(report)));
  return text;
}

}  // namespace epure::bench
