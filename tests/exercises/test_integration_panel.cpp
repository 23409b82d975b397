// Graphical integration on a sheet: that the polygons' sides are parallel to their rays on the paper, the pole
// distance is the one the scales make, and what a ruler reads is what was given.
#include "exercises/kit/panels/integration_panel.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/layout_search.h"
#include "geometry/constructions/graphical_integral.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

constexpr drawings::Box a4_room{{11, 28}, {200, 199}};

struct Drawn {
  DrawnSheet sheet;
  std::vector<Scale> scales;
  std::vector<std::string> steps;
};

// y = `size` · (1 - x/`run`) over ten strips, integrated twice.
Drawn drawn_integral(double run, double size, const drawings::Box& within = a4_room) {
  std::vector<double> ends, means;
  const auto curve = [=](double x) { return size * (1 - x / run); };
  for (int i = 0; i <= 10; ++i) ends.push_back(run * i / 10);
  for (int i = 0; i < 10; ++i) means.push_back(curve((ends[i] + ends[i + 1]) / 2));
  const auto first = geometry::graphical_integral<double>(ends, means, 1);
  const auto second = geometry::graphical_integral<double>(ends, first.middles(), 1);
  const auto heights = [](const auto& polygon) {
    std::vector<double> all;
    for (const auto& corner : polygon.corners) all.push_back(corner.y);
    return all;
  };
  Panels one = panels(IntegrationPanel(
      {.letters = "$t$", .unit = "s", .ends = ends},
      {{.letters = "$a$", .unit = "m/s²", .meaning = Meaning::acceleration, .curve = curve, .carried = means},
       {.letters = "$v$",
        .unit = "m/s",
        .id = "v-polygon",
        .corners = heights(first),
        .carried = first.middles(),
        .read = {{.quantity = "v", .label = "$v_{1}$", .at = ends[6], .value = first.corners[6].y}}},
       {.letters = "$s$",
        .unit = "m",
        .meaning = Meaning::locus,
        .corners = heights(second),
        .read = {
            {.quantity = "s", .label = "$s_{1}$", .at = ends[10], .value = second.corners[10].y, .si = 1000}}}}));
  one.front()->choose_view(within, {});
  const PlacedPanel placed = laid_out(one, within, {}).front();
  Drawn result;
  Plot plot(result.sheet, placed.origin, placed.vectors);
  one.front()->draw(plot, placed.room, Language::english);
  result.scales = one.front()->own_scales();
  for (const PanelStep& step : one.front()->steps(plot, placed.room)) result.steps.push_back(step.text.english);
  return result;
}

double measured(const Drawn& from, const std::string& quantity) {
  for (const Measurement& each : from.sheet.measurements)
    if (each.quantity == quantity) return (each.to.y - each.from.y) * each.per_mm;
  FAIL("not measured: " << quantity);
  return 0;
}

// The rays are the lines from the pole, which is a dot; the first polygon is the line of this name.
const drawings::Line& line_named(const Drawn& from, const std::string& name) {
  for (const drawings::Mark& mark : from.sheet.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->name == name) return *line;
  throw std::logic_error(name);
}

}  // namespace

TEST_CASE("integration: ordinates of the polygons are measured back, at any size", "[integration]") {
  for (const double run : {1e-3, 1.0, 7.3, 4e6})
    for (const double size : {1e-200, 3.7e-4, 1.0, 250.0, 9e200}) {
      CAPTURE(run, size);
      const Drawn sheet = drawn_integral(run, size);
      // Halfway through the sixth and at the end: size·run·(x - x²/2) at x = 0.6 of a line is exact.
      CHECK(measured(sheet, "v") == Approx(size * run * 0.42));
      // Trapezoids of v: size·run²·(1/3 - 1/1200).
      CHECK(measured(sheet, "s") == Approx(1000 * size * run * run * (1.0 / 3 - 1.0 / 1200)));
    }
}

TEST_CASE("integration: each side of the polygon is parallel to its ray", "[integration]") {
  const Drawn sheet = drawn_integral(10, 4);
  const drawings::Line& polygon = line_named(sheet, "v-polygon");
  REQUIRE(polygon.path.pieces.size() == 10);
  const double distance = sheet.scales[1].mm_per_unit * sheet.scales[0].mm_per_unit / sheet.scales[2].mm_per_unit;
  const drawings::Point from = polygon.path.pieces[1].end, to = polygon.path.pieces[2].end;
  CHECK((to.y - from.y) / (to.x - from.x) == Approx(4 * 0.75 * sheet.scales[1].mm_per_unit / distance));
  CHECK(distance >= 14);
  CHECK(distance <= 80);
}

TEST_CASE("integration: nothing leaves the room, and steps are told in order", "[integration]") {
  for (const auto& within : {a4_room, drawings::Box{{11, 28}, {310, 286}}}) {
    const Drawn sheet = drawn_integral(20, -3, within);
    for (const drawings::Mark& mark : sheet.sheet.sheet.figure.marks)
      if (const auto* line = std::get_if<drawings::Line>(&mark))
        for (const auto& piece : line->path.pieces) {
          CHECK(piece.end.x >= within.low.x);
          CHECK(piece.end.x <= within.high.x);
          CHECK(piece.end.y >= within.low.y);
          CHECK(piece.end.y <= within.high.y);
        }
    CHECK(sheet.steps.size() == 6);
    CHECK(sheet.scales.size() == 4);
  }
}

TEST_CASE("integration: a curve that is zero has a polygon that is", "[integration]") {
  const Drawn sheet = drawn_integral(20, 0);
  CHECK(measured(sheet, "v") == 0);
  CHECK(measured(sheet, "s") == 0);
}

TEST_CASE("integration: a room that is too small is told", "[integration]") {
  CHECK_THROWS_AS(drawn_integral(10, 1, {{0, 0}, {30, 30}}), DoesNotFit);
}

TEST_CASE("integration: letters at the right edge stand at the tip, out of the axis' numbers", "[integration]") {
  for (const drawings::Label& label : drawn_integral(10, 4).sheet.sheet.figure.labels) {
    if (label.text == "$v_{1}$") CHECK(label.to);
    if (label.text == "$s_{1}$") CHECK(!label.to);
  }
}

TEST_CASE("integration: the axis of ordinates is one continuous line", "[integration]") {
  const Drawn drawn = drawn_integral(10, 4);
  int axes = 0;
  for (const drawings::Mark& mark : drawn.sheet.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark);
        line && line->meaning == Meaning::axis && line->path.start.x == line->path.pieces.front().end.x)
      ++axes;
  CHECK(axes == 0);
}

// Below it stand the numbers of the axis.
TEST_CASE("integration: the letters of a short ordinate stand at its upper end", "[integration]") {
  for (const double short_one : {0.02, -0.02}) {
    const std::vector<double> ends{0, 1, 2}, corners{0, short_one, 1};
    Panels one =
        panels(IntegrationPanel({.letters = "$t$", .unit = "s", .ends = ends},
                                {{.letters = "$v$", .unit = "m/s", .carried = {short_one, 1 - short_one}},
                                 {.letters = "$s$",
                                  .unit = "m",
                                  .corners = corners,
                                  .read = {{.quantity = {}, .label = "$s_{1}$", .at = 1, .value = short_one}}}}));
    one.front()->choose_view(a4_room, {});
    const PlacedPanel placed = laid_out(one, a4_room, {}).front();
    DrawnSheet drawn;
    Plot plot(drawn, placed.origin, placed.vectors);
    one.front()->draw(plot, placed.room, Language::english);
    const auto& labels = drawn.sheet.figure.labels;
    const auto found =
        std::find_if(labels.begin(), labels.end(), [](const auto& each) { return each.text == "$s_{1}$"; });
    REQUIRE(found != labels.end());
    REQUIRE(found->away_from);
    CHECK(found->at.y > found->away_from->y);
  }
}
