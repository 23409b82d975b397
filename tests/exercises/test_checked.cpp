// A whole exercise checked: what must fail fails, and for the reason given.
#include <cmath>
#include <limits>

#include "exercises/kit/proof/measured.h"
#include "tests/exercises/fake.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

CheckedExercise checked(const Triangle& triangle, Rung rung = Rung::climb) {
  return check(triangle, Givens(triangle.about().givens), rung);
}

// The failures of a triangle whose values are spoilt.
std::vector<std::string> failures(const std::function<void(std::vector<RouteValue>&)>& spoil,
                                  Rung rung = Rung::climb) {
  Triangle triangle;
  triangle.spoil_values = spoil;
  return complaints(checked(triangle, rung));
}

std::vector<std::string> failures_on_sheet(const std::function<void(DrawnSheet&)>& spoil) {
  Triangle triangle;
  triangle.spoil_sheet = spoil;
  return complaints(checked(triangle));
}

bool mentions(const std::vector<std::string>& failures, const std::string& text) {
  for (const std::string& failure : failures)
    if (failure.find(text) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("the triangle as it is passes on every rung") {
  const Triangle triangle;
  for (const Rung rung : {Rung::fast, Rung::bounded, Rung::climb}) {
    const CheckedExercise result = checked(triangle, rung);
    CAPTURE(complaints(result));
    CHECK(result.passed());
    REQUIRE(result.quantities.size() == 5);
    CHECK(result.quantities[0].settled.enclosure.value == 0.5);
    CHECK(result.quantities[0].on_sheets.size() == 2);
    CHECK(result.quantities[0].printed.size() == 2);
    CHECK(result.quantities[3].on_sheets.empty());
  }
}

TEST_CASE("routes whose enclosures do not meet fail; on doubles nothing is compared") {
  const auto off_by_an_ulp = [](auto& values) {
    value_of(values, "c", "analytic") = certain(std::nextafter(0.5, 1));
  };
  CHECK(mentions(failures(off_by_an_ulp), "c: in [0.5, 0.5] by ruler, but"));
  const auto meets_at_an_end = [](auto& values) { value_of(values, "c", "analytic") = enclosed(0.5, 0.6, 0.7); };
  CHECK(failures(meets_at_an_end).empty());
  const auto wide_apart = [](auto& values) { value_of(values, "c", "analytic") = enclosed(0.6, 0.6, 0.7); };
  CHECK_FALSE(failures(wide_apart).empty());
  const auto below = [](auto& values) { value_of(values, "c", "analytic") = enclosed(0.3, 0.4, 0.45); };
  CHECK_FALSE(failures(below).empty());
  CHECK_FALSE(failures(wide_apart, Rung::bounded).empty());
  const auto other_double = [](auto& values) {
    value_of(values, "c", "analytic").enclosure = {-infinity, 7, infinity};
  };
  CHECK(failures(other_double, Rung::fast).empty());
}

TEST_CASE("absent agrees with absent only") {
  const auto absent_by = [](std::vector<std::string> routes) {
    return [routes](std::vector<RouteValue>& values) {
      for (const std::string& route : routes) value_of(values, "omega", route) = absent("no turning");
    };
  };
  CHECK(failures(absent_by({"ruler", "analytic"})).empty());
  CHECK(mentions(failures(absent_by({"ruler"})), "omega: absent (no turning) by ruler, but in [-2.5, -2.5]"));
  CHECK(mentions(failures(absent_by({"analytic"})), "omega"));
  const auto absent_and_zero = [](auto& values) {
    value_of(values, "omega", "ruler") = certain(0);
    value_of(values, "omega", "analytic") = absent("no turning");
  };
  CHECK(mentions(failures(absent_and_zero), "omega: in [0, 0] by ruler, but absent"));
}

TEST_CASE("what is undecided, or only enclosed after the climb, fails") {
  const auto open = [](auto& values) { value_of(values, "omega", "analytic") = undecided("whether it turns"); };
  CHECK(failures(open) == std::vector<std::string>{"omega: undecided by analytic (whether it turns)"});
  CHECK(mentions(failures(open, Rung::bounded), "undecided"));
  const auto one_enclosed = [](auto& values) { value_of(values, "omega", "ruler") = enclosed(-3, -2.5, -2); };
  CHECK(failures(one_enclosed).empty());
  const auto both_enclosed = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) value_of(values, "omega", route) = enclosed(-3, -2.5, -2);
  };
  CHECK(mentions(failures(both_enclosed), "no more is known"));
  CHECK(failures(both_enclosed, Rung::bounded).empty());
}

TEST_CASE("between two neighbouring doubles no more need be known: a tie has no nearest") {
  const double least = std::nextafter(-2.5, -3), second = std::nextafter(least, -3);
  for (const double lower : {least, second}) {
    const auto spoil = [&](auto& values) {
      for (const std::string route : {"ruler", "analytic"})
        value_of(values, "omega", route) = enclosed(lower, lower, -2.5);
    };
    CHECK(mentions(failures(spoil), "no more is known") == (lower == second));
  }
}

TEST_CASE("the value is that of the route that knows most") {
  Triangle triangle;
  triangle.spoil_values = [](auto& values) { value_of(values, "omega", "ruler") = enclosed(-3, -2.6, -2); };
  CHECK(checked(triangle).quantities[3].settled.enclosure.value == -2.5);
}

TEST_CASE("a quantity by one route, by none, or not listed fails") {
  const auto without = [](const std::string& route) {
    return [route](std::vector<RouteValue>& values) {
      std::erase_if(values, [&](const RouteValue& value) {
        return value.quantity == "c_x" && (route.empty() || value.route == route);
      });
    };
  };
  CHECK(mentions(failures(without("ruler")), "c_x: only one route"));
  CHECK(failures(without("ruler"), Rung::bounded).empty());
  CHECK(mentions(failures(without("")), "c_x: no route gives it"));
  CHECK(mentions(failures([](auto& values) {
                   values.push_back({"d", "ruler", certain(1)});
                 }),
                 "d: found by ruler, but is not among the exercise's quantities"));
  CHECK(mentions(failures([](auto& values) { values[5].route = "ruler"; }), "c: only one route"));
}

TEST_CASE("a sheet must show the value as nearly as a file can hold it") {
  // Ends moved by a third of the file's resolution each stay within; by five times it, not. 1 / per_mm is 100 mm.
  const auto longer_by = [](double mm) {
    return [mm](DrawnSheet& drawn) {
      for (Measurement& measurement : drawn.measurements) measurement.to.x += mm;
    };
  };
  CHECK(failures_on_sheet([](auto&) {}).empty());
  const auto moved = failures_on_sheet(longer_by(5 * drawings::file_resolution));
  CHECK(mentions(moved, "c: sheet sides shows"));
  CHECK(mentions(moved, "c: sheet small shows"));
  CHECK(mentions(moved, "c_x: sheet sides shows"));
  CHECK_FALSE(mentions(moved, "c_y"));
  CHECK(mentions(failures_on_sheet([](DrawnSheet& drawn) {
                   std::swap(drawn.measurements.back().from, drawn.measurements.back().to);
                 }),
                 "c"));
  CHECK(mentions(failures_on_sheet([](DrawnSheet& drawn) {
                   drawn.measurements.push_back({"d", {}, {}, 1});
                 }),
                 "d: shown on sheet sides, but is not among"));
}

TEST_CASE("what does not exist cannot be drawn") {
  const auto gone = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) value_of(values, "c", route) = absent("flat");
  };
  CHECK(mentions(failures(gone), "c: sheet sides shows it, but it does not exist (flat)"));
}

TEST_CASE("the resolution of a sheet is what filing and placing cost, for lengths and components, times the scale") {
  const double step = drawings::file_resolution, placing = 0x1p-20;  // mm: 2^14 roundings of 2^20 mm
  const Measurement slant{"c", {10, 10}, {40, 50}, 0.01};
  CHECK(measure(slant, "s", drawings::Paper::a4).resolution ==
        Approx(0.01 * (std::sqrt(2.0) * step + placing)).epsilon(1e-5));
  Measurement level = slant;
  level.kind = Measurement::along_x;
  const OnSheet shown = measure(level, "s", drawings::Paper::a4);
  CHECK(shown.resolution == Approx(0.01 * (step + placing)).epsilon(1e-5));
  CHECK(shown.value == Approx(0.3).margin(0.01 * step));
  level.kind = Measurement::along_y;
  std::swap(level.from, level.to);
  CHECK(measure(level, "s", drawings::Paper::a4).value == Approx(-0.4).margin(0.01 * step));
}

TEST_CASE("ends anywhere on the paper are measured within the resolution that is claimed") {
  // A grid of odd steps visits all positions between two points of the file's grid.
  double worst = 0;
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    const drawings::Point from{20 + 0.000317 * i, 30 + 0.000211 * i}, to{137.0001 - 0.000173 * i, 91 + 0.000409 * i};
    const OnSheet shown = measure({"c", from, to, 1}, "s", drawings::Paper::a3);
    const double miss = std::abs(shown.value - std::hypot(to.x - from.x, to.y - from.y));
    worst = std::max(worst, miss / shown.resolution);
    ++seen;
  }
  INFO("worst: " << worst << " of the claim");
  CHECK(seen == 400);
  CHECK(worst <= 1);
  CHECK(worst > 0.3);  // the claim is no wild exaggeration
}

TEST_CASE("a length shows the magnitude of a signed quantity, a component its sign") {
  const OnSheet length{.sheet = "s", .value = 2.5, .resolution = 0.01};
  CHECK(is_within_resolution(length, -2.5));
  const OnSheet component{.sheet = "s", .value = 2.5, .resolution = 0.01, .signed_value = true};
  CHECK_FALSE(is_within_resolution(component, -2.5));
  CHECK(is_within_resolution(component, 2.505));
  CHECK_FALSE(is_within_resolution(component, 2.52));
}

TEST_CASE("of several sheets the one that misses most stands for the quantity") {
  CheckedQuantity quantity{.spec = {}, .settled = certain(1), .routes = {}};
  CHECK(farthest_on_sheet(quantity) == nullptr);
  quantity.on_sheets = {{"fine", 1.001, 0.0005}, {"coarse", 1.002, 0.01}};
  CHECK(farthest_on_sheet(quantity)->sheet == "fine");
}

TEST_CASE("printed numbers are judged for the source's givens only, and explanations must hold") {
  Triangle triangle;
  Givens changed(triangle.about().givens);
  changed.set("a=0.2");
  for (const CheckedQuantity& quantity : check(triangle, changed, Rung::climb).quantities)
    CHECK(quantity.printed.empty());
  std::vector<Printed> printed = triangle.description.printed();
  printed.back().explanation->evaluate = [] { return 0.8; };
  triangle.description.printed = [printed] { return printed; };
  CHECK(mentions(complaints(checked(triangle)),
                 "c_y: the mistake that is to explain the printed 0.7 does not give it"));
  printed.back().quantity = "q";
  triangle.description.printed = [printed] { return printed; };
  CHECK(mentions(complaints(checked(triangle)), "q: printed by the source, but is not among"));
}

TEST_CASE("a measured number is held against half a millimetre of its drawing") {
  const Triangle triangle;
  CheckedExercise result = checked(triangle);
  CheckedQuantity& c = result.quantities[0];
  // The smaller of the two sheets: 50 mm a metre, so half a millimetre is worth 0.01 m.
  add_measured(result, c, "0.51", {});
  CHECK(c.measured.back().within);
  CHECK(c.measured.back().allowed == Approx(0.01));
  CHECK(c.measured.back().difference.value() == Approx(0.01));
  CHECK(c.measured.back().difference_percent.value() == Approx(2));
  CHECK(c.measured.back().allowed_by.english == "0.5 mm on sheet small");
  CHECK(result.passed());
  add_measured(result, c, "48.9 cm", {});
  CHECK_FALSE(c.measured.back().within);
  CHECK(mentions(complaints(result), "c: measured 48.9 cm is beyond reading"));
  CHECK_FALSE(result.passed());
}

TEST_CASE("a measured number of what no sheet shows is held against two lines of 100 mm, or its own last digit") {
  const Triangle triangle;
  CheckedExercise result = checked(triangle);
  CheckedQuantity& omega = result.quantities[3];
  // 1 % of 2.5 for half a millimetre.
  add_measured(result, omega, "2.5", {});
  add_measured(result, omega, "-2.54rad/s", {});
  CHECK(omega.measured[0].within);
  CHECK(omega.measured[0].allowed == Approx(0.05));
  CHECK(omega.measured[0].allowed_by.english == "half a unit of its last digit");
  CHECK_FALSE(omega.measured[1].within);
  CHECK(omega.measured[1].allowed == Approx(0.025));
  CHECK(omega.measured[1].allowed_by.english == "0.5 mm in each of two lines of 100 mm");
  add_measured(result, omega, "5/2", {});
  CHECK(omega.measured[2].within);
  add_measured(result, omega, "\u22122.5\u00A0rad/s", {});
  CHECK(omega.measured[3].value == -2.5);
  add_measured(result, omega, "-3", {});
  CHECK(omega.measured[4].allowed == Approx(0.025));  // one digit is not rewarded
}

// What is calculated from two drawn quantities: their relative errors are added.
TEST_CASE("a number calculated from drawn ones may be off by what they may be") {
  Triangle triangle;
  triangle.change_quantities([](auto& all) {
    all.push_back({"area", "$A$", "m^2", {"area of the square", "area"}});
    all.push_back({"slope", "$s$", "1", {"slope", "pendenza"}});
    all.push_back({"odd", "$o$", "m", {"a length", "una lunghezza"}});
    all.push_back({"tall", "$t$", "m^2", {"a rectangle", "un rettangolo"}});
  });
  triangle.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) {
      values.push_back({"area", route, certain(0.15)});   // c · c_x
      values.push_back({"slope", route, certain(0.6)});   // c_x / c
      values.push_back({"odd", route, certain(0.15)});    // c · c_x in numbers, but no area
      values.push_back({"tall", route, certain(0.077)});  // of nothing
    }
  };
  CheckedExercise result = checked(triangle);
  const auto allowed = [&](std::size_t i, const Ruler& ruler) {
    return nearest(allowance(result, result.quantities[i], ruler).size);
  };
  REQUIRE(result.quantities.size() == 9);
  // On the smallest sheet: 0.5 ± 0.01, 0.3 ± 0.005. As a given, a = 0.3 has no error; of the ways c · c_x and c · a
  // the first is rougher.
  CHECK(allowed(5, {}) == Approx(0.15 * (0.01 / 0.5 + 0.005 / 0.3)));
  CHECK(allowance(result, result.quantities[5], {}).by.english == "c · c_x, 0.5 mm in each: 2 % + 1.7 %");
  CHECK(allowance(result, result.quantities[5], {}).by.italian == "c · c_x, 0,5 mm in ciascuna: 2 % + 1,7 %");
  CHECK(allowed(5, {.sheet = "sides"}) == Approx(0.15 * (0.005 / 0.5 + 0.005 / 0.3)));
  CHECK(allowed(5, {.reading_mm = 1}) == Approx(0.15 * 2 * (0.01 / 0.5 + 0.005 / 0.3)));
  CHECK(allowed(5, {.scales = {{{1, 0, 0}, Rational(1, 200)}}}) == Approx(0.15 * (0.0025 / 0.5 + 0.0025 / 0.3)));
  CHECK(allowed(6, {}) == Approx(0.6 * (0.01 / 0.5 + 0.005 / 0.3)));
  CHECK(allowance(result, result.quantities[6], {}).by.english == "c_x / c, 0.5 mm in each: 1.7 % + 2 %");
  CHECK(allowed(7, {}) == Approx(0.0015));
  CHECK(allowed(8, {}) == Approx(0.00077));
  // On paper of a student's own at 1:50 all lines are below 20 mm: then the way with the smallest error counts, c ·
  // a.
  CHECK(allowed(5, {.scales = {{{1, 0, 0}, Rational(1, 20)}}}) == Approx(0.15 * (0.025 / 0.5)));
}

TEST_CASE("a measured number of what does not exist fails") {
  Triangle triangle;
  triangle.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) value_of(values, "omega", route) = absent("no turning");
  };
  CheckedExercise result = checked(triangle);
  add_measured(result, result.quantities[3], "2.5", {});
  CHECK(mentions(complaints(result), "no value to compare with (no turning)"));
}
