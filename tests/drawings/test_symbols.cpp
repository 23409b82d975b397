// Arrows and kinematic symbols have the sizes and places they promise.
#include "drawings/marks/symbols.h"
#include "drawings/output.h"
#include "drawings/page.h"
#include "tests/drawings/probe.h"
#include "tests/support/catch.h"

using namespace epure::drawings;

namespace {

const Point centre = middle(drawing_area(Paper::a4));

Page page_of(std::vector<Mark> marks) {
  Sheet sheet;
  sheet.id = "symbols";
  sheet.bare = true;
  sheet.figure.marks = std::move(marks);
  return compose(sheet);
}

bool same(Point a, Point b) { return a.x == b.x && a.y == b.y; }

}  // namespace

TEST_CASE("an arrow ends exactly at its tip, with a head of at most a third") {
  for (const double size : {3.001, 3.5, 6.0, 8.9, 9.0, 30.0})
    for (const double angle : {0.0, 0.3, 1.5707963267948966, 2.5, -1.1}) {
      const Point to = centre + size * direction(angle);
      const Page page = page_of({Arrow{centre, to, Meaning::velocity, "v"}});
      const auto heads = probe::named<Fill>(page, "v_head");
      const auto shafts = probe::named<Stroke>(page, "v");
      REQUIRE(heads.size() == 1);
      REQUIRE(shafts.size() == 1);
      const double length_drawn = distance(centre, to);
      const Path& head = heads[0].path;
      CHECK(same(head.start, to));
      CHECK(same(shafts[0].path.start, centre));
      REQUIRE(head.pieces.size() == 2);
      const Point back = between(head.pieces[0].end, head.pieces[1].end, 0.5);
      const double head_drawn = distance(to, back);
      CHECK(head_drawn == Approx(std::min(3.0, length_drawn / 3)));
      const double half_angle =
          std::atan2(distance(head.pieces[0].end, head.pieces[1].end) / 2, head_drawn) * 180 / std::numbers::pi;
      CHECK(half_angle == Approx(10));
      // The shaft ends inside the head.
      CHECK(distance(shafts[0].path.pieces[0].end, to) < head_drawn);
    }
}

TEST_CASE("the number of a step stands in the middle of its circle") {
  for (const int number : {1, 7, 12}) {
    const std::vector<Primitive> drawn = circled_number(centre, number, 4.4, black);
    REQUIRE(drawn.size() == 2);
    CHECK(distance(middle(probe::text_box(std::get<PlacedText>(drawn[1]))), centre) < 1e-9);
  }
}

TEST_CASE("a vector shorter than its head is a dot at its tip, with a line to where it starts") {
  for (const double size : {0.0, 0.01, 1.0, 2.999}) {
    const Point to = centre + Point{size, 0};
    const Page page = page_of({Arrow{centre, to, Meaning::velocity, "v"}});
    const auto lines = probe::all<Stroke>(page);
    REQUIRE(lines.size() == (size > dot_radius ? 1 : 0));
    if (!lines.empty()) {
      CHECK(distance(lines[0].path.start, centre) < file_resolution);
      CHECK(distance(lines[0].path.pieces.front().end, to) < file_resolution);
    }
    const auto dots = probe::named<Fill>(page, "v");
    REQUIRE(dots.size() == 1);
    for (const Point p : probe::samples(dots[0].path, 0.05))
      CHECK(std::abs(distance(p, to) - dot_radius) < file_resolution / 2);
  }
}

TEST_CASE("a rotation's head is at its end, in its sense") {
  for (const double to : {2.0, -2.0}) {
    const Page page = page_of({Rotation{centre, 10, 0, to}});
    const auto heads = probe::all<Fill>(page);
    REQUIRE(heads.size() == 1);
    const Point tip = heads[0].path.start;
    CHECK(distance(tip, centre + 10 * direction(to)) < 1e-9);
    const Point back = between(heads[0].path.pieces[0].end, heads[0].path.pieces[1].end, 0.5);
    const Point ahead = (to > 0 ? 1.0 : -1.0) * left_of(direction(to));
    CHECK(dot(unit(back, tip), ahead) > 0.98);
  }
}

TEST_CASE("hinges and points lie above everything else") {
  const Page page = page_of({Hinge{centre}, Line{segment(centre, centre + Point{20, 0}), Meaning::link, "link"}});
  const auto* first = std::get_if<Stroke>(&page.primitives.front());
  REQUIRE(first);
  CHECK(first->name == "link");
}

TEST_CASE("a guide is hatched on the right of its direction, half a block away") {
  const Point from = centre, to = centre + Point{30, 0};
  for (const Stroke& stroke : probe::all<Stroke>(page_of({Guide{from, to}})))
    for (const Point p : probe::samples(stroke.path, 0.5)) CHECK(p.y <= centre.y - block_height / 2 + 1e-9);
  for (const Stroke& stroke : probe::all<Stroke>(page_of({Guide{to, from}})))
    for (const Point p : probe::samples(stroke.path, 0.5)) CHECK(p.y >= centre.y + block_height / 2 - 1e-9);
}

TEST_CASE("a block lies on its guide in every direction") {
  for (const double angle : {0.0, 0.4, 1.2, 2.0, -0.7, 3.0}) {
    const Point along = direction(angle), right = -1 * left_of(along);
    const Page page = page_of({Guide{centre - 20 * along, centre + 20 * along}, Slider{centre, angle}});
    const auto strokes = probe::all<Stroke>(page);
    // The guide is the first stroke; the block's outline the last.
    const Path& guide = strokes.front().path;
    const Point foot = centre + block_height / 2 * right;
    CHECK(distance(guide.start, foot - 20 * along) < 1e-9);
    double deepest = -INFINITY;
    for (const Point p : probe::samples(strokes.back().path, 0.5)) deepest = std::max(deepest, dot(p - foot, right));
    CHECK(deepest == Approx(0).margin(1e-9));
  }
}

TEST_CASE("ground lies exactly on its line, hatched on the right") {
  for (const double angle : {0.0, 0.8, 3.1415926535897932, -2.0}) {
    const Point from = centre, to = centre + 30 * direction(angle), right = -1 * left_of(direction(angle));
    const auto strokes = probe::all<Stroke>(page_of({Ground{from, to}}));
    REQUIRE(strokes.size() > 10);
    CHECK(same(strokes[0].path.start, from));
    CHECK(same(strokes[0].path.pieces[0].end, to));
    double deepest = 0;
    for (const Stroke& stroke : strokes)
      for (const Point p : probe::samples(stroke.path, 0.5)) {
        CHECK(dot(p - from, right) > -1e-9);
        deepest = std::max(deepest, dot(p - from, right));
      }
    CHECK(deepest > 1);
  }
  CHECK(probe::all<Stroke>(page_of({Ground{centre - Point{1e6, 0}, centre + Point{1e6, 0}}})).size() < 1000);
}

TEST_CASE("a slot is everywhere half its width from the segment it is given") {
  for (const double angle : {0.0, 0.6, 2.5, -1.5707963267948966})
    for (const double length : {0.0, 0.5, 25.0})
      for (const double width : {3.5, 6.0}) {
        const Point from = centre, to = centre + length * direction(angle);
        const Page page = page_of({Slot{from, to, width}});
        const auto outlines = probe::all<Stroke>(page);
        REQUIRE(outlines.size() == 1);
        CHECK(outlines[0].path.closed);
        double lowest = INFINITY, highest = -INFINITY;
        for (const Point p : probe::samples(outlines[0].path, 0.2)) {
          const double t = std::clamp(dot(p - from, direction(angle)), 0.0, length);
          CHECK(std::abs(distance(p, from + t * direction(angle)) - width / 2) < file_resolution / 2);
          lowest = std::min(lowest, dot(p - from, direction(angle)));
          highest = std::max(highest, dot(p - from, direction(angle)));
        }
        CHECK(highest - lowest == Approx(length + width).epsilon(1e-3));
        // White inside: the link it is cut from does not show through.
        const auto fills = probe::all<Fill>(page);
        REQUIRE(fills.size() == 1);
        CHECK(fills[0].colour.red == 1);
      }
  for (const double width : {0.0, -1.0, static_cast<double>(NAN)})
    CHECK_THROWS_AS(page_of({Slot{centre, centre + Point{9, 0}, width}}), std::invalid_argument);
}

TEST_CASE("data points are centred where they are, and differ") {
  for (const PointShape shape : {PointShape::dot, PointShape::ring, PointShape::square, PointShape::diamond,
                                 PointShape::triangle, PointShape::cross, PointShape::plus}) {
    const Page page = page_of({DataPoint{centre, shape, Meaning::velocity, "p"}});
    Point sum{};
    int count = 0;
    for (const Primitive& primitive : page.primitives) {
      const Path path =
          std::holds_alternative<Fill>(primitive) ? std::get<Fill>(primitive).path : std::get<Stroke>(primitive).path;
      for (const Piece& piece : path.pieces) sum = sum + piece.end, ++count;
      sum = sum + path.start, ++count;
      if (path.closed && path.pieces.back().end.x == path.start.x && path.pieces.back().end.y == path.start.y)
        sum = sum - path.start, --count;
      for (const Point p : probe::samples(path, 0.1)) CHECK(distance(p, centre) < 1.4);
    }
    CHECK(distance((1.0 / count) * sum, centre) < 1e-9);
    CHECK(probe::named<Stroke>(page, "p").size() + probe::named<Fill>(page, "p").size() == 1);
  }
}

TEST_CASE("writing stands where it is put, and labels keep clear of it") {
  const Point at = centre;
  std::vector<Mark> marks{Writing{"360", at}, Dot{at + Point{2, 4}}};
  Sheet sheet;
  sheet.bare = true;
  sheet.figure.marks = marks;
  sheet.figure.labels = {{"A", at + Point{2, 4}, {}, Meaning::text, at + Point{2, 14}}};  // wishes to stand below
  std::vector<std::string> conflicts;
  const auto texts = probe::all<PlacedText>(compose(sheet, &conflicts));
  REQUIRE(texts.size() == 2);
  CHECK(same(texts[0].baseline, at));
  CHECK(conflicts.empty());
  CHECK(apart(probe::text_box(texts[0]), probe::text_box(texts[1])));
  sheet.figure.marks.push_back(Line{segment(at + Point{-5, 1}, at + Point{9, 1})});
  conflicts.clear();
  compose(sheet, &conflicts);
  CHECK(conflicts == std::vector<std::string>{"'360' touches a line, a symbol or other letters"});
}

TEST_CASE("a fixed hinge stands on the side it is told") {
  const Page page = page_of({FixedHinge{centre, 0}});
  double furthest = 0;
  for (const Stroke& stroke : probe::all<Stroke>(page))
    for (const Point p : probe::samples(stroke.path, 0.5)) {
      CHECK(p.x >= centre.x - hinge_radius - 1e-9);
      furthest = std::max(furthest, p.x - centre.x);
    }
  CHECK(furthest > 6);
}

TEST_CASE("a dimension line is parallel to what it measures, on the left for a positive offset") {
  const Dimension dimension{centre, centre + Point{0, 20}, 8, "20"};
  const auto [from, to] = dimension_line(dimension);
  CHECK(distance(from, centre + Point{-8, 0}) < 1e-12);
  CHECK(distance(to, centre + Point{-8, 20}) < 1e-12);
  const auto texts = probe::all<PlacedText>(page_of({dimension}));
  REQUIRE(texts.size() == 1);
  CHECK(texts[0].text == "20");
}

TEST_CASE("a scale bar is as long as it says") {
  const Page page = page_of({ScaleBar{centre, 40, 4, "1 : 5", {"0", "", "0.1", "", "0.2 m"}}});
  double low = INFINITY, high = -INFINITY;
  for (const Stroke& stroke : probe::all<Stroke>(page))
    for (const Point p : probe::samples(stroke.path, 1)) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
  CHECK(high - low == Approx(40).epsilon(1e-12));
  CHECK(probe::all<PlacedText>(page).size() == 4);  // a tick without a number has no letters
}

TEST_CASE("arcs keep to their circle and close after a full turn") {
  for (const double sweep : {0.01, 1.0, 3.0, 6.0}) {
    const Path path = arc(centre, 30, 0.4, 0.4 + sweep);
    CHECK_FALSE(path.closed);
    CHECK(distance(path.pieces.back().end, centre + 30 * direction(0.4 + sweep)) < 1e-9);
    for (const Point p : probe::samples(path, 0.1)) CHECK(distance(p, centre) == Approx(30).epsilon(5e-6));
  }
  CHECK(circle(centre, 30).closed);
  CHECK_THROWS_AS(arc(centre, 30, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(arc(centre, -1, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(arc(centre, 30, 0, NAN), std::invalid_argument);
}
