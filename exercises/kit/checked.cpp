#include "exercises/kit/checked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace epure {
namespace {

using geometry::Settled;

// Which of two routes knows more of a quantity: the smaller number.
int rank(const Settled& settled) {
  switch (settled.kind) {
    case Settled::Kind::certain:
      return 0;
    case Settled::Kind::absent:
      return 1;
    case Settled::Kind::enclosed:
      return 2;
    case Settled::Kind::unbounded:
      return 3;
    case Settled::Kind::undecided:
      break;
  }
  return 4;
}

// Of two routes that know as much, the one with the narrower enclosure: a proved zero before a tiny interval around
// it.
bool knows_more(const Settled& a, const Settled& b) {
  if (rank(a) != rank(b)) return rank(a) < rank(b);
  return a.enclosure.upper - a.enclosure.lower < b.enclosure.upper - b.enclosure.lower;
}

// Undecided and unbounded contradict nothing.
bool contradict(const Settled& a, const Settled& b) {
  if (rank(a) > 2 || rank(b) > 2) return false;
  const bool a_absent = a.kind == Settled::Kind::absent, b_absent = b.kind == Settled::Kind::absent;
  if (a_absent || b_absent) return a_absent != b_absent;
  return a.enclosure.upper < b.enclosure.lower || b.enclosure.upper < a.enclosure.lower;
}

std::string in_words(const Settled& settled) {
  if (settled.kind == Settled::Kind::absent) return "absent (" + settled.reason + ")";
  return fmt::format("in [{}, {}]", settled.enclosure.lower, settled.enclosure.upper);
}

void compare_routes(CheckedExercise& checked, const CheckedQuantity& quantity) {
  for (auto a = quantity.routes.begin(); a != quantity.routes.end(); ++a)
    for (auto b = a + 1; b != quantity.routes.end(); ++b)
      if (contradict(a->settled, b->settled))
        checked.failures.push_back(fmt::format("{}: {} by {}, but {} by {}", quantity.spec.name, in_words(a->settled),
                                               a->route, in_words(b->settled), b->route));
}

void demand_settled(CheckedExercise& checked, const CheckedQuantity& quantity) {
  for (const RouteValue& route : quantity.routes)
    if (route.settled.kind == Settled::Kind::undecided)
      checked.failures.push_back(
          fmt::format("{}: undecided by {} ({})", quantity.spec.name, route.route, route.settled.reason));
}

// A true value midway between two doubles has no nearest one: no ball around it tells more than these two.
bool is_between_neighbours(const geometry::Enclosure& enclosure) {
  return std::nextafter(enclosure.lower, enclosure.upper) == enclosure.upper;
}

void demand_certainty(CheckedExercise& checked, const CheckedQuantity& quantity) {
  if (quantity.settled.kind == Settled::Kind::enclosed && !is_between_neighbours(quantity.settled.enclosure))
    checked.failures.push_back(fmt::format("{}: no more is known than that it lies {} ({})", quantity.spec.name,
                                           in_words(quantity.settled), quantity.settled.reason));
  std::set<std::string> routes;
  for (const RouteValue& route : quantity.routes) routes.insert(route.route);
  if (routes.size() < 2)
    checked.failures.push_back(fmt::format("{}: only one route, so nothing confirms it", quantity.spec.name));
}

// Quantities in the order of the description, each with its routes.
void group(CheckedExercise& checked, const std::vector<RouteValue>& values) {
  for (const QuantitySpec& spec : checked.about.quantities) {
    CheckedQuantity quantity{.spec = spec, .settled = {}, .routes = {}};
    std::copy_if(values.begin(), values.end(), std::back_inserter(quantity.routes),
                 [&](const RouteValue& value) { return value.quantity == spec.name; });
    if (quantity.routes.empty()) {
      checked.failures.push_back(fmt::format("{}: no route gives it", spec.name));
      continue;
    }
    quantity.settled =
        std::min_element(quantity.routes.begin(), quantity.routes.end(),
                         [](const RouteValue& a, const RouteValue& b) { return knows_more(a.settled, b.settled); })
            ->settled;
    checked.quantities.push_back(std::move(quantity));
  }
}

CheckedQuantity* find(CheckedExercise& checked, const std::string& name) {
  const auto found = std::find_if(checked.quantities.begin(), checked.quantities.end(),
                                  [&](const CheckedQuantity& quantity) { return quantity.spec.name == name; });
  return found == checked.quantities.end() ? nullptr : &*found;
}

// What an exercise says of a quantity it does not list would be lost in silence.
void demand_listed(CheckedExercise& checked, const std::string& name, const std::string& where) {
  const auto& listed = checked.about.quantities;
  if (std::none_of(listed.begin(), listed.end(), [&](const QuantitySpec& spec) { return spec.name == name; }))
    checked.failures.push_back(fmt::format("{}: {}, but is not among the exercise's quantities", name, where));
}

void compare_sheet(CheckedExercise& checked, CheckedQuantity& quantity, const OnSheet& shown) {
  quantity.on_sheets.push_back(shown);
  if (quantity.settled.kind == Settled::Kind::absent)
    checked.failures.push_back(fmt::format("{}: sheet {} shows it, but it does not exist ({})", quantity.spec.name,
                                           shown.sheet, quantity.settled.reason));
  if (has_value(quantity.settled) && !is_within_resolution(shown, quantity.settled.enclosure.value))
    checked.failures.push_back(fmt::format("{}: sheet {} shows {}, which is not {} within {}", quantity.spec.name,
                                           shown.sheet, shown.value, quantity.settled.enclosure.value,
                                           shown.resolution));
}

void compare_sheets(CheckedExercise& checked, const Exercise& exercise) {
  for (const SheetSpec& spec : checked.about.sheets) {
    const DrawnSheet drawn = exercise.draw(spec.name, checked.givens, {});
    for (const Measurement& measurement : drawn.measurements) {
      demand_listed(checked, measurement.quantity, "shown on sheet " + spec.name);
      if (CheckedQuantity* quantity = find(checked, measurement.quantity))
        compare_sheet(checked, *quantity, measure(measurement, spec.name, drawn.sheet.paper));
    }
  }
}

void compare_printed(CheckedExercise& checked) {
  for (const Printed& printed : checked.about.printed) {
    demand_listed(checked, printed.quantity, "printed by the source");
    CheckedQuantity* quantity = find(checked, printed.quantity);
    if (!quantity) continue;
    quantity->printed.push_back(judge(printed, quantity->settled));
    if (!quantity->printed.back().explanation_holds)
      checked.failures.push_back(fmt::format("{}: the mistake that is to explain the printed {} does not give it",
                                             printed.quantity, printed.text));
  }
}

}  // namespace

CheckedExercise check(const Exercise& exercise, const Givens& givens, Rung rung) {
  CheckedExercise checked{.about = exercise.about(), .givens = givens, .quantities = {}};
  const std::vector<RouteValue> values = exercise.solve(givens, rung);
  group(checked, values);
  for (const RouteValue& value : values) demand_listed(checked, value.quantity, "found by " + value.route);
  for (const CheckedQuantity& quantity : checked.quantities) {
    compare_routes(checked, quantity);
    demand_settled(checked, quantity);
    if (rung == Rung::climb) demand_certainty(checked, quantity);
  }
  compare_sheets(checked, exercise);
  if (givens.as_stated()) compare_printed(checked);
  return checked;
}

}  // namespace epure
