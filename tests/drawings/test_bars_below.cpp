#include "drawings/sheet/bars_below.h"

#include "drawings/output.h"
#include "drawings/sheet/ink.h"
#include "probe.h"
#include "tests/support/catch.h"

using namespace epure::drawings;

namespace {

const Point mid_paper = middle(drawing_area(Paper::a4));
constexpr double under = 3, crop_margin = 2;  // mm

ScaleBar bar_at_foot(double x, const std::string& caption) {
  return {drawing_area(Paper::a4).low + Point{x, 8}, 40, 4, caption, {"0", "", "0.1", "", "0.2 m"}};
}

Sheet bare_with(std::vector<Mark> marks) {
  Sheet sheet;
  sheet.id = "bare";
  sheet.bare = true;
  sheet.figure.marks = std::move(marks);
  return sheet;
}

Box of_text(const Page& page, const std::string& text) {
  for (const PlacedText& each : probe::all<PlacedText>(page))
    if (each.text == text) return probe::text_box(each);
  FAIL("no text " << text);
  return {};
}

}  // namespace

TEST_CASE("the scale bars of a bare figure stand right under it, as long as they are") {
  const Line circle_{circle(mid_paper, 60), Meaning::link};
  const Page without = compose(bare_with({circle_})),
             with = compose(bare_with({circle_, bar_at_foot(6, "1 : 5"), bar_at_foot(84, "1 cm ≙ 2 m/s")}));
  const Box figure = grown(without.extent, -crop_margin), first = of_text(with, "1 : 5"),
            second = of_text(with, "1 cm ≙ 2 m/s");
  CHECK(std::max(first.high.y, second.high.y) == Approx(figure.low.y - under).margin(1e-9));
  CHECK(second.low.x > first.high.x + 8);
  CHECK(with.extent.high.y == without.extent.high.y);
  CHECK(with.extent.low.x == Approx(without.extent.low.x).margin(1e-9));
  CHECK(with.extent.high.x == without.extent.high.x);
  CHECK(without.extent.low.y - with.extent.low.y < 13);
  // Each bar is a box of 40 mm beside the pieces it is made of.
  std::vector<double> feet;
  for (const Stroke& stroke : probe::all<Stroke>(with)) {
    const Box box = ink_box(stroke);
    if (stroke.path.closed && std::abs(box.width() - stroke.width - 40) < 1e-6) feet.push_back(box.low.y);
  }
  REQUIRE(feet.size() == 2);
  CHECK(feet[0] == feet[1]);
}

TEST_CASE("scale bars of a narrow figure stand one below the other") {
  const Line small{circle(mid_paper, 10), Meaning::link};
  const Page page = compose(bare_with({small, bar_at_foot(6, "1 : 5"), bar_at_foot(84, "1 cm ≙ 2 m/s")}));
  const Box first = of_text(page, "1 : 5"), second = of_text(page, "1 cm ≙ 2 m/s");
  CHECK(second.high.y < first.low.y - 5);
  CHECK(std::abs(first.low.x - second.low.x) < 1e-9);
  CHECK(page.extent.width() < 40 + 15);
  CHECK(contains(page.extent, grown(ink_box(page.primitives), crop_margin - 1e-9)));
  CHECK(overlaps(bare_with({small, bar_at_foot(6, "1 : 5"), bar_at_foot(84, "1 cm ≙ 2 m/s")})).empty());
}

TEST_CASE("bars alone are a figure too") {
  const Page page = compose(bare_with({bar_at_foot(6, "1 : 5")}));
  CHECK(page.extent.width() < 40 + 15);
  CHECK(page.extent.height() < 15);
}

TEST_CASE("marks keep their windows when bars are taken out from among them") {
  const Box window{mid_paper - Point{5, 5}, mid_paper + Point{5, 5}};
  Figure figure;
  figure.marks = {Line{segment(mid_paper, mid_paper + Point{50, 0}), Meaning::link, "whole"}, bar_at_foot(6, "1 : 5"),
                  Line{segment(mid_paper, mid_paper + Point{0, 50}), Meaning::link, "cut"}};
  figure.windows = {window};
  figure.window_of = {-1, -1, 0};
  const std::vector<ScaleBar> bars = taken_out(figure);
  REQUIRE(bars.size() == 1);
  CHECK(bars[0].caption == "1 : 5");
  CHECK(figure.marks.size() == 2);
  CHECK(figure.window_of == std::vector<int>{-1, 0});
}

TEST_CASE("a whole sheet has its bars at its foot") {
  Sheet sheet = bare_with({Line{circle(mid_paper, 20), Meaning::link}, bar_at_foot(6, "1 : 5")});
  sheet.bare = false;
  const Box area = drawing_area(Paper::a4);
  CHECK(of_text(compose(sheet), "1 : 5").low.x == Approx(area.low.x + 6).margin(0.5));
  CHECK(of_text(compose(sheet), "1 : 5").low.y < area.low.y + 12);
}
