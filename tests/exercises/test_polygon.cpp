// Vector polygons: what of them is drawn at each stage, what is measured, and how they are told.
#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/polygon_picture.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

// v = (3, 0) + (0, 4) + y (-1, -1) lies on the x axis: closed by (-4, -4), so v = (-1, 0).
VectorPolygon two_magnitudes() {
  return {
      .meaning = Meaning::velocity,
      .unit = "m/s",
      .origin = "$O$",
      .left = {{.quantity = "v", .label = "$\\vec{v}$", .direction = "∥ $x$", .magnitude = "?", .v = {-1, 0}}},
      .right = {
          {.quantity = "p", .label = "$\\vec{p}$", .direction = "∥ $x$", .magnitude = "3", .v = {3, 0}},
          {.quantity = "none", .label = "$\\vec{n}$", .direction = "–", .magnitude = "0", .v = {0, 0}, .tip = "$n$"},
          {.quantity = "q",
           .label = "$\\vec{q}$",
           .direction = "⊥ $x$",
           .magnitude = "4",
           .v = {0, 4},
           .tip = "$q$",
           .square = true},
          {.quantity = "r",
           .label = "$\\vec{r}$",
           .direction = "∥ $m$",
           .magnitude = "?",
           .v = {-4, -4},
           .tip = "$r$",
           .along = {-1, -1}}}};
}

// One vector unknown: v = (3, 0) + (0, 4).
VectorPolygon one_vector() {
  VectorPolygon polygon = two_magnitudes();
  polygon.right.pop_back();
  polygon.left = {{.quantity = "v", .label = "$\\vec{v}$", .direction = "?", .magnitude = "?", .v = {3, 4}}};
  return polygon;
}

DrawnSheet drawn(const VectorPolygon& polygon, const PolygonStage& stage) {
  DrawnSheet sheet;
  const Scale scale{.mm_per_unit = 10, .caption = "", .unit = "m/s"};
  Plot plot(sheet, {90, 90}, scale);
  draw_polygon(plot, polygon, stage);
  return sheet;
}

template <class Mark>
int count(const DrawnSheet& sheet) {
  int all = 0;
  for (const drawings::Mark& mark : sheet.sheet.figure.marks) all += std::holds_alternative<Mark>(mark) ? 1 : 0;
  return all;
}

std::vector<int> numbers(const DrawnSheet& sheet) {
  std::vector<int> all;
  for (const drawings::StepNumber& step : sheet.sheet.figure.steps) all.push_back(step.number);
  return all;
}

}  // namespace

TEST_CASE("a polygon grows by its steps; the unknown vectors appear when it closes", "[polygon]") {
  const VectorPolygon polygon = two_magnitudes();
  REQUIRE(steps_of_sides(polygon) == 4);  // what is zero is no step
  struct Stage {
    PolygonStage stage;
    int arrows, lines;
    std::vector<int> numbers;
  };
  for (const auto& [stage, arrows, lines, shown] :
       {Stage{{.steps = 0}, 0, 0, {}},
        {{.steps = 1}, 1, 0, {1}},
        {{.steps = 2}, 2, 0, {1, 2}},
        {{.steps = 3}, 2, 1, {1, 2, 3}},
        {{.steps = 4, .closed = false}, 2, 2, {1, 2, 3, 4}},
        {{.steps = 4, .first_numbered = 3, .closed = false}, 2, 2, {3, 4}},
        {{.steps = 4}, 4, 2, {1, 2, 3, 4}},
        {{.steps = 4, .numbered = false}, 4, 2, {}}}) {
    const DrawnSheet sheet = drawn(polygon, stage);
    CAPTURE(stage.steps, stage.closed);
    CHECK(count<drawings::Arrow>(sheet) == arrows);
    CHECK(count<drawings::Line>(sheet) == lines);
    CHECK(numbers(sheet) == shown);
  }
}

TEST_CASE("only the whole polygon is measured", "[polygon]") {
  CHECK(drawn(two_magnitudes(), {.steps = 3}).measurements.empty());
  CHECK(drawn(two_magnitudes(), {.steps = 4, .closed = false}).measurements.empty());
  const DrawnSheet whole = drawn(two_magnitudes(), {});
  REQUIRE(whole.measurements.size() == 4);
  for (const Measurement& m : whole.measurements) {
    const double length = std::hypot(m.to.x - m.from.x, m.to.y - m.from.y) * m.per_mm;
    CAPTURE(m.quantity);
    CHECK(length == Approx(m.quantity == "p" ? 3 : m.quantity == "q" ? 4 : m.quantity == "r" ? std::sqrt(32) : 1));
  }
}

TEST_CASE("a vector of unknown direction closes the polygon alone", "[polygon]") {
  REQUIRE(steps_of_sides(one_vector()) == 3);
  const DrawnSheet before = drawn(one_vector(), {.closed = false}), after = drawn(one_vector(), {});
  CHECK(count<drawings::Arrow>(before) == 2);
  CHECK(count<drawings::Line>(before) == 1);  // its direction, without a word for it
  CHECK(count<drawings::Arrow>(after) == 3);
  CHECK(count<drawings::Line>(after) == 0);
  CHECK(before.sheet.figure.labels.size() + 1 == after.sheet.figure.labels.size());
}

TEST_CASE("a side that is square to the one before it is marked so", "[polygon]") {
  CHECK(count<drawings::RightAngle>(drawn(two_magnitudes(), {.steps = 2})) == 0);  // when the polygon is closed
  CHECK(count<drawings::RightAngle>(drawn(two_magnitudes(), {})) == 1);
}

// Between the side before, which comes along x, and the square one, which goes up.
TEST_CASE("the mark of a right angle gives way to an image's vector that comes between its legs", "[polygon]") {
  const auto mark_with = [](const Arrow2& image) {
    VectorPolygon polygon = two_magnitudes();
    polygon.images = {{.absolute = {.label = "$\\vec{c}$", .v = image, .tip = "$c$"}}};
    const DrawnSheet sheet = drawn(polygon, {});
    for (const drawings::Mark& mark : sheet.sheet.figure.marks)
      if (const auto* corner = std::get_if<drawings::RightAngle>(&mark)) return std::sin(corner->second);
    return 0.0;
  };
  CHECK(mark_with({3.2, 0.2}) == Approx(1));  // it comes from below
  CHECK(mark_with({3.2, -0.2}) == Approx(-1));
  CHECK(mark_with({4.2, -0.2}) == Approx(1));  // far from it
}

TEST_CASE("a vector shorter than its head is told with its value, where it has one", "[polygon]") {
  VectorPolygon polygon = two_magnitudes();
  polygon.right[0].v = {0.2, 0};  // 2 mm
  const auto labels = [](const VectorPolygon& of) {
    std::vector<std::string> texts;
    for (const drawings::Label& label : drawn(of, {}).sheet.figure.labels) texts.push_back(label.text);
    return texts;
  };
  const auto has = [](const std::vector<std::string>& texts, const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
  };
  CHECK(has(labels(polygon), "$\\vec{p}$"));
  polygon.right[0].length = 0.2;
  CHECK(has(labels(polygon), "$p$ = 0.200 m/s"));
  polygon.right[2].length = 4;  // long enough
  CHECK(has(labels(polygon), "$\\vec{q}$"));
}

TEST_CASE("the steps of a polygon in words", "[polygon]") {
  CHECK(steps_of(two_magnitudes(), Language::english) ==
        std::vector<std::string>{
            "From $O$ the known $\\vec{p}$, ∥ $x$.", "At its tip the known $\\vec{q}$, ⊥ $x$.",
            "Through $q$ the line ∥ $m$: the direction of $\\vec{r}$.",
            "Through $O$ the line ∥ $x$: the direction of $\\vec{v}$. The two lines meet at $r$."});
  CHECK(steps_of(two_magnitudes(), Language::italian)[1] == "Di seguito la $\\vec{q}$ nota, ⊥ $x$.");
  CHECK(steps_of(one_vector(), Language::english)[2] == "$\\vec{v}$, from $O$ to $q$, closes the polygon.");
  CHECK(steps_of(one_vector(), Language::italian)[2] == "La $\\vec{v}$, da $O$ a $q$, chiude il poligono.");
}

TEST_CASE("a term that is zero stands in the equation", "[polygon]") {
  const drawings::VectorEquation written = equation(two_magnitudes());
  REQUIRE(written.terms.size() == 5);
  CHECK(written.terms[0].before.empty());
  CHECK(written.terms[1].before == "=");
  CHECK(written.terms[2].magnitude == "0");
}

// v = (3, 0) - (0, -4) - (4, 4) = (-1, 0): the same corners.
TEST_CASE("what is subtracted is drawn towards the corner before it", "[polygon]") {
  VectorPolygon polygon = two_magnitudes();
  for (std::size_t i : {2U, 3U}) {
    polygon.right[i].is_subtracted = true;
    polygon.right[i].v = -polygon.right[i].v;
  }
  polygon.right[2].square = false;
  polygon.right[2].tip.clear();
  const drawings::VectorEquation written = equation(polygon);
  CHECK(written.terms[3].before == "−");
  CHECK(written.terms[4].before == "−");
  CHECK(steps_of(polygon, Language::english) ==
        std::vector<std::string>{
            "From $O$ the known $\\vec{p}$, ∥ $x$.",
            "The known $\\vec{q}$, ⊥ $x$, is subtracted: its tip lies there.",
            "Through its start the line ∥ $m$: the direction of $\\vec{r}$.",
            "Through $O$ the line ∥ $x$: the direction of $\\vec{v}$. The two lines meet at $r$."});
  const DrawnSheet sheet = drawn(polygon, {});
  const auto arrow = [&](const std::string& name) {
    for (const drawings::Mark& mark : sheet.sheet.figure.marks)
      if (const auto* found = std::get_if<drawings::Arrow>(&mark); found && found->name == name) return *found;
    return drawings::Arrow{};
  };
  CHECK(arrow("q").to.x == 120);  // where p ends
  CHECK(arrow("q").to.y == 90);
  CHECK(arrow("q").from.y == 130);
  CHECK(arrow("r").to.y == 130);  // where q begins
  CHECK(arrow("r").from.x == 80);
  CHECK(arrow("r").from.y == 90);
}

TEST_CASE("a polygon lies within its extent, lines and all", "[polygon]") {
  const Scale scale{.mm_per_unit = 10, .caption = "", .unit = "m/s"};
  for (const VectorPolygon& polygon : {two_magnitudes(), one_vector()}) {
    const drawings::Box box = extent_of(polygon, scale);
    for (const bool closed : {true, false}) {
      const DrawnSheet sheet = drawn(polygon, {.closed = closed});
      for (const drawings::Mark& mark : sheet.sheet.figure.marks) {
        const auto* line = std::get_if<drawings::Line>(&mark);
        if (!line) continue;
        for (const drawings::Point p : {line->path.start, line->path.pieces.back().end}) {
          CHECK(p.x - 90 >= box.low.x);
          CHECK(p.x - 90 <= box.high.x);
          CHECK(p.y - 90 >= box.low.y);
          CHECK(p.y - 90 <= box.high.y);
        }
      }
    }
  }
}

// All in one line there is no outside: the sum stands on a track of its own to the left, its letters beyond it, those
// of its parts on the right.
TEST_CASE("letters of a flat polygon stand on different sides", "[polygon]") {
  VectorPolygon flat = one_vector();
  flat.right[2].v = {2, 0};
  flat.left[0].v = {5, 0};
  const DrawnSheet sheet = drawn(flat, {});
  double p = 0, v = 0;  // which way the letters are pushed: the sign of y from the point they avoid
  for (const drawings::Label& label : sheet.sheet.figure.labels) {
    if (!label.to || !label.away_from) continue;
    if (label.text == "$\\vec{p}$") p = label.at.y - label.away_from->y;
    if (label.text == "$\\vec{v}$") v = label.at.y - label.away_from->y;
  }
  CHECK(p < 0);
  CHECK(v > 0);
}

TEST_CASE("a sheet tells of a polygon what it shows", "[polygon]") {
  const drawings::Table table = measured_table(drawn(two_magnitudes(), {}), two_magnitudes(), Language::english);
  REQUIRE(table.rows.size() == 4);
  CHECK(table.rows[0][0] == "$p$ (m/s)");
  CHECK(table.rows[0][1] == "3.00");
  CHECK(std::stod(table.rows[0][2]) == Approx(3).margin(1e-3));
}

TEST_CASE("lines lie below the vectors", "[polygon]") {
  bool has_vector = false;
  for (const drawings::Mark& mark : drawn(two_magnitudes(), {}).sheet.figure.marks) {
    has_vector = has_vector || std::holds_alternative<drawings::Arrow>(mark);
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->meaning == Meaning::construction)
      CHECK(!has_vector);
  }
}

TEST_CASE("a corner that is the origin has its letters together with it", "[polygon]") {
  VectorPolygon zero = two_magnitudes();
  zero.right = {zero.right[0], zero.right[3]};
  zero.right[1].v = {-3, 0};
  zero.left[0].v = {0, 0};
  zero.left[0].along = {0, 1};
  const auto has = [](const DrawnSheet& sheet, const std::string& text) {
    const auto& labels = sheet.sheet.figure.labels;
    return std::any_of(labels.begin(), labels.end(), [&](const drawings::Label& each) { return each.text == text; });
  };
  CHECK(has(drawn(zero, {}), "$O$ ≡ $r$"));
  CHECK(!has(drawn(zero, {}), "$r$"));
  CHECK(has(drawn(two_magnitudes(), {}), "$r$"));
}

// 8 mm past where the line has been drawn for 6 mm.
TEST_CASE("the step of a short vector stands at the end of its line", "[polygon]") {
  VectorPolygon polygon = two_magnitudes();
  polygon.left[0].v = {-0.1, 0};
  polygon.left[0].along = {-1, 0};
  const Scale scale{.mm_per_unit = 10, .caption = "", .unit = "m/s"};
  CHECK(places_of_steps(polygon, scale)[3].x == Approx(-1.4));
  CHECK(places_of_steps(two_magnitudes(), scale)[3].x == Approx(-0.3));
}
