#include "tests/exercises/fake.h"

#include <cmath>
#include <stdexcept>

#include "exercises/kit/proof/solution.h"
#include "exercises/kit/statement/decimal.h"

namespace epure {
namespace {

using geometry::Settled;

Settled on_rung(double value, Rung rung) {
  if (rung == Rung::climb) return certain(value);
  if (rung == Rung::bounded)
    return enclosed(std::nextafter(value, -infinity), value, std::nextafter(value, infinity));
  return {.kind = Settled::Kind::unbounded, .enclosure = {-infinity, value, infinity}, .rung = "Fast"};
}

double number(const Givens& givens, const std::string& symbol) { return nearest(givens[symbol]); }

}  // namespace

Settled certain(double value) { return enclosed(value, value, value); }

Settled absent(const std::string& reason) { return {.kind = Settled::Kind::absent, .reason = {reason, reason}}; }

Settled undecided(const std::string& reason) {
  return {.kind = Settled::Kind::undecided, .reason = {reason, reason}};
}

Settled enclosed(double lower, double value, double upper) {
  return {.kind = lower == upper ? Settled::Kind::certain : Settled::Kind::enclosed,
          .enclosure = {lower, value, upper},
          .reason = lower == upper ? Words{} : Words{"one rung alone", "un solo gradino"}};
}

Settled& value_of(std::vector<RouteValue>& values, const std::string& quantity, const std::string& route) {
  for (RouteValue& value : values)
    if (value.quantity == quantity && value.route == route) return value.settled;
  throw std::logic_error("no " + quantity + " by " + route);
}

Triangle::Triangle() {
  description = {
      .id = "triangle",
      .title = {"A right triangle", "Un triangolo rettangolo"},
      .document = "euclid",
      .item = "I.47",
      .source = {"Euclid, I.47", "Euclide, I.47"},
      .question = {"Find the hypotenuse.", "Trovare l'ipotenusa."},
      .givens =
          {{.symbol = "a", .meaning = {"base", "base"}, .unit = "m", .stated = "0.30"},
           {.symbol = "b", .meaning = {"height", "altezza"}, .unit = "m", .stated = "0.40"},
           {.symbol = "load",
            .meaning = {"load", "carico"},
            .unit = "N",
            .stated = "0",
            .range = Range::not_negative},
           {.symbol = "shift", .meaning = {"shift", "spostamento"}, .unit = "m", .stated = "0", .range = Range::any}},
      .sheets = {{"sides", {"The sides", "I lati"}}, {"small", {"The same, smaller", "Lo stesso, più piccolo"}}},
      .quantities =
          [] {
            return std::vector<Quantity>{{"c", "$c_{0}$", "m", {"hypotenuse", "ipotenusa"}},
                                         {"c_x", "$\\vec{c}_{AB}$", "m", {"its abscissa", "la sua ascissa"}},
                                         {"c_y", "$c_{31}$", "m", {"its ordinate", "la sua ordinata"}},
                                         {"omega", "$ω$", "rad/s", {"turning", "rotazione"}},
                                         {"angle", "$φ$", "rad", {"angle", "angolo"}}};
          },
      .printed =
          [] {
            return std::vector<Printed>{
                {"c", "0.5", "ruler"},
                {"c", "0.51", "ruler", 0.01},
                {"c_y", "0.7", "adding", 0.01,
                 Explanation{{"the catheti were added", "i cateti sono stati sommati"}, [] { return 0.7; }}}};
          }};
}

void Triangle::change_quantities(const std::function<void(std::vector<Quantity>&)>& change) {
  std::vector<Quantity> quantities = description.quantities();
  change(quantities);
  description.quantities = [quantities] { return quantities; };
}

std::vector<RouteValue> Triangle::solve(const Givens& givens, Rung rung) const {
  const double a = number(givens, "a"), b = number(givens, "b");
  std::vector<RouteValue> values;
  for (const std::string route : {"ruler", "analytic"}) {
    values.push_back({"c", route, on_rung(std::hypot(a, b), rung)});
    values.push_back({"c_x", route, on_rung(a, rung)});
    values.push_back({"c_y", route, on_rung(-b, rung)});
    values.push_back({"omega", route, on_rung(-2.5, rung)});
    values.push_back({"angle", route, on_rung(0.75, rung)});
  }
  spoil_values(values);
  return values;
}

std::optional<LongTable> Triangle::long_table(const std::string& sheet, const Solution&) const {
  return sheet == "sides" ? table_of_it : std::nullopt;
}

DrawnSheet Triangle::draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const {
  const Givens& givens = solution.givens();
  const double a = number(givens, "a"), b = number(givens, "b");
  const double mm_per_m = request.scale ? 1000 * nearest(*request.scale) : sheet == "small" ? 50 : 100;
  if (mm_per_m * std::max(a, b) > 150) throw BadGivens("the triangle does not fit the paper at this scale");
  const drawings::Point top{40, 40 + b * mm_per_m}, end{40 + a * mm_per_m, 40};
  DrawnSheet drawn;
  drawn.sheet.id = "triangle-" + sheet;
  drawn.sheet.title = description.title.in(request.language);
  drawn.sheet.paper = request.paper;
  drawn.sheet.language = request.language;
  drawn.sheet.bare = request.bare;
  drawn.sheet.figure.marks = {drawings::Line{drawings::segment(top, end), drawings::Meaning::link, "c"}};
  drawn.measurements = {{"c", top, end, 1 / mm_per_m}};
  if (sheet == "sides") {
    drawn.measurements.push_back({"c_x", top, end, 1 / mm_per_m, Measurement::along_x});
    drawn.measurements.push_back({"c_y", top, end, 1 / mm_per_m, Measurement::along_y});
  }
  spoil_sheet(drawn);
  return drawn;
}

}  // namespace epure
