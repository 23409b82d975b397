#include "exercises/cli/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "drawings/text.h"
#include "exercises/cli/symbol.h"
#include "exercises/kit/columns.h"

namespace epure {
namespace {

using geometry::Settled;
using Rows = std::vector<std::vector<std::string>>;

// Enough to be held against any printed number; --json has all digits.
std::string digits(double value) { return fmt::format("{:.6g}", value); }

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit == "1" ? number : number + " " + unit;
}

std::string percent(const std::optional<double>& value) { return value ? fmt::format("{:+.2g} %", *value) : "-"; }

std::string value(const CheckedQuantity& quantity) {
  const Settled& settled = quantity.settled;
  if (settled.kind == Settled::Kind::absent) return "absent";
  if (settled.kind == Settled::Kind::undecided) return "undecided";
  const auto [lower, middle, upper] = settled.enclosure;
  const bool shown_by_one_number = settled.kind == Settled::Kind::unbounded ||
                                   (digits(lower) == digits(middle) && digits(upper) == digits(middle));
  return with_unit(shown_by_one_number ? digits(middle) : fmt::format("[{}, {}]", digits(lower), digits(upper)),
                   quantity.spec.unit);
}

std::vector<std::string> distinct_routes(const std::vector<RouteValue>& values) {
  std::vector<std::string> routes;
  for (const RouteValue& each : values)
    if (std::find(routes.begin(), routes.end(), each.route) == routes.end()) routes.push_back(each.route);
  return routes;
}

// What lies within the resolution of zero is zero as far as a sheet can tell.
std::string digits(const OnSheet& shown) {
  return std::abs(shown.value) <= shown.resolution ? "0" : digits(shown.value);
}

std::string on_sheet(const CheckedQuantity& quantity) {
  const OnSheet* shown = farthest_on_sheet(quantity);
  return shown ? fmt::format("{} ± {:.1g}", digits(*shown), shown->resolution) : "-";
}

std::string printed_cell(const PrintedVerdict& each) {
  return fmt::format("{} by {}: {} ({})", each.text, each.route, name(each.verdict),
                     percent(each.difference_percent));
}

void add_rows(Rows& rows, const CheckedQuantity& quantity) {
  std::vector<std::string> row = {quantity.spec.name, unicode_symbol(quantity.spec.symbol), value(quantity),
                                  fmt::format("{}", fmt::join(distinct_routes(quantity.routes), ", ")),
                                  on_sheet(quantity)};
  if (quantity.printed.empty()) row.emplace_back("-");
  for (const PrintedVerdict& each : quantity.printed) {
    row.push_back(printed_cell(each));
    rows.push_back(row);
    row.assign(5, "");  // a second printed number stands below the first
  }
  if (quantity.printed.empty()) rows.push_back(row);
}

std::string quantities(const CheckedExercise& checked) {
  Rows rows = {{"quantity", "", "value", "routes", "on sheet", "printed"}};
  for (const CheckedQuantity& quantity : checked.quantities) add_rows(rows, quantity);
  return columns(rows, 2);
}

std::vector<std::string> measuring_sheets(const CheckedExercise& checked) {
  std::vector<std::string> names;
  for (const SheetSpec& sheet : checked.about.sheets) {
    const bool shows_some =
        std::any_of(checked.quantities.begin(), checked.quantities.end(), [&](const CheckedQuantity& quantity) {
          return std::any_of(quantity.on_sheets.begin(), quantity.on_sheets.end(),
                             [&](const OnSheet& shown) { return shown.sheet == sheet.name; });
        });
    if (shows_some) names.push_back(sheet.name);
  }
  return names;
}

// The first measurement on that sheet, and by how much it misses the value.
std::string on(const std::string& sheet, const CheckedQuantity& quantity) {
  for (const OnSheet& shown : quantity.on_sheets) {
    if (shown.sheet != sheet) continue;
    if (!has_value(quantity.settled) || std::abs(quantity.settled.enclosure.value) <= shown.resolution)
      return digits(shown);
    const double size = std::abs(quantity.settled.enclosure.value);
    const double exact = shown.signed_value ? quantity.settled.enclosure.value : size;
    const double off = shown.value - exact;
    return fmt::format("{} ({})", digits(shown),
                       std::abs(off) <= shown.resolution ? "0 %" : percent(off / size * 100));
  }
  return "-";
}

// How far the sheets' readings of one quantity lie from each other.
std::string apart(const CheckedQuantity& quantity) {
  if (quantity.on_sheets.size() < 2 || !has_value(quantity.settled)) return "-";
  const auto [least, most] =
      std::minmax_element(quantity.on_sheets.begin(), quantity.on_sheets.end(),
                          [](const OnSheet& a, const OnSheet& b) { return std::abs(a.value) < std::abs(b.value); });
  const double range = std::abs(most->value) - std::abs(least->value);
  const double resolution = least->resolution + most->resolution;
  if (range <= resolution) return "0";
  if (std::abs(quantity.settled.enclosure.value) <= resolution) return digits(range);
  return fmt::format("{:.2g} %", range / std::abs(quantity.settled.enclosure.value) * 100);
}

// The source's comparison of its graphical methods, each measured as its file holds it.
std::string methods(const CheckedExercise& checked) {
  const std::vector<std::string> sheets = measuring_sheets(checked);
  if (sheets.empty()) return "";
  Rows rows = {{"quantity", "value"}};
  rows[0].insert(rows[0].end(), sheets.begin(), sheets.end());
  if (sheets.size() > 1) rows[0].emplace_back("apart");
  for (const CheckedQuantity& quantity : checked.quantities) {
    if (quantity.on_sheets.empty()) continue;
    std::vector<std::string>& row = rows.emplace_back(std::vector{quantity.spec.name, value(quantity)});
    for (const std::string& sheet : sheets) row.push_back(on(sheet, quantity));
    if (sheets.size() > 1) row.push_back(apart(quantity));
  }
  return "\n  Measured on the sheets, as the files hold them (difference from the value):\n\n" + columns(rows, 2);
}

// Remarks in the order they were first made, each with all it applies to: one slip often explains several numbers.
class Remarks {
 public:
  void add(const std::string& subject, const std::string& remark) {
    const auto known =
        std::find_if(all_.begin(), all_.end(), [&](const auto& entry) { return entry.remark == remark; });
    if (known == all_.end())
      all_.push_back({subject, remark});
    else
      known->subjects += ", " + subject;
  }
  std::string text() const {
    std::string text = all_.empty() ? "" : "\n";
    for (const auto& [subjects, remark] : all_) text += fmt::format("  {}: {}\n", subjects, remark);
    return text;
  }

 private:
  struct Entry {
    std::string subjects, remark;
  };
  std::vector<Entry> all_;
};

std::string absences(const CheckedExercise& checked) {
  Remarks remarks;
  for (const CheckedQuantity& quantity : checked.quantities)
    if (quantity.settled.kind == Settled::Kind::absent) remarks.add(quantity.spec.name, quantity.settled.reason);
  return remarks.text();
}

std::string explanations(const CheckedExercise& checked) {
  Remarks remarks;
  for (const CheckedQuantity& quantity : checked.quantities)
    for (const PrintedVerdict& each : quantity.printed)
      if (each.explanation)
        remarks.add(quantity.spec.name + " printed " + each.text,
                    drawings::plain(each.explanation->in(Language::english)));
  return remarks.text();
}

std::string measured(const CheckedExercise& checked) {
  std::string text;
  for (const CheckedQuantity& quantity : checked.quantities)
    for (const Measured& each : quantity.measured)
      text += fmt::format("  {} measured {}: computed {}, difference {} ({}), allowed {:.3g} ({}): {}\n",
                          quantity.spec.name, each.text, value(quantity),
                          each.difference ? fmt::format("{:+.3g}", *each.difference) : "-",
                          percent(each.difference_percent), each.allowed, each.allowed_by, verdict(each));
  return text.empty() ? "" : "\n" + text;
}

std::string givens(const Givens& givens) {
  std::vector<std::string> all;
  for (const GivenSpec& given : givens.specs())
    if (const auto read = givens.reading(given.symbol))
      all.push_back(given.symbol + " = " + with_unit(givens.text(given.symbol), read->unit.symbol));
  return fmt::format("{}", fmt::join(all, ", "));
}

std::string summary(const CheckedExercise& checked) {
  std::set<std::string> routes;
  for (const CheckedQuantity& quantity : checked.quantities)
    for (const RouteValue& each : quantity.routes) routes.insert(each.route);
  std::string text;
  for (const std::string& failure : checked.failures) text += "  FAILED " + failure + "\n";
  if (!text.empty()) text = "\n" + text;
  return text + fmt::format("\n{}: {} quantities, {} routes, {}\n", checked.about.id, checked.quantities.size(),
                            routes.size(), checked.passed() ? "passed" : "FAILED");
}

}  // namespace

std::string text_report(const CheckedExercise& checked) {
  return fmt::format("{}: {} ({}, {})\n  {}\n\n", checked.about.id,
                     drawings::plain(checked.about.title.in(Language::english)), checked.about.document,
                     checked.about.item, givens(checked.givens)) +
         quantities(checked) + absences(checked) + methods(checked) + explanations(checked) + measured(checked) +
         summary(checked);
}

std::string verdict(const Measured& measured) { return measured.within ? "within reading" : "beyond reading"; }

}  // namespace epure
