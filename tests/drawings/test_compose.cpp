// A composed sheet: everything in its place, on both papers and in both languages.
#include <set>

#include "drawings/output.h"
#include "drawings/page.h"
#include "drawings/paths/clip.h"
#include "drawings/paths/flatten.h"
#include "drawings/sheet/column.h"
#include "drawings/sheet/ink.h"
#include "drawings/sheet/layout.h"
#include "drawings/text/sheet_words.h"
#include "tests/drawings/probe.h"
#include "tests/support/catch.h"

using namespace epure::drawings;

namespace {

using probe::infinite;
using probe::not_a_number;

Sheet example(Paper paper, Language language) {
  Sheet sheet;
  sheet.id = "example";
  sheet.title = "Example";
  sheet.paper = paper;
  sheet.language = language;
  const Box area = drawing_area(paper);
  const Point a0 = area.low + Point{40, 50}, a = a0 + Point{30, 17}, b = a0 + Point{120, 0};
  sheet.figure.marks = {Area{polyline({a0, a, b}, true)},
                        Guide{b - Point{15, 0}, b + Point{15, 0}},
                        FixedHinge{a0},
                        Slider{b},
                        Line{polyline({a0, a, b}, false), Meaning::link, "links"},
                        Hinge{a},
                        Hinge{b},
                        Arrow{a, a + Point{-10, 17}, Meaning::velocity, "v_A"},
                        ScaleBar{area.low + Point{3, 6}, 40, 4, "1 : 5", {"0", "", "0.1", "", "0.2 m"}}};
  sheet.figure.labels = {{"$A_{0}$", a0}, {"A", a}, {"B", b}, {"$\\vec{v}_{A}$", a, a + Point{-10, 17}}};
  sheet.figure.steps = {{1, a}, {2, b}};
  sheet.column = {Heading{"Construction"},
                  Steps{{"Draw the crank.", "Draw the coupler, long enough to need two lines here."}},
                  VectorEquation{{{"$\\vec{v}_{B}$", "∥ $A_{0}B$", "?", ""},
                                  {"$\\vec{v}_{A}$", "⊥ $A_{0}A$", "$ω_{2}·A_{0}A$", "="},
                                  {"$\\vec{v}_{BA}$", "⊥ BA", "?", "+"}}},
                  Table{{"quantity", "value", "printed"},
                        {{"$v_{B}$ (m/s)", "5.103", "5.33"}, {"$ω_{3}$ (rad/s)", "13.33", "13"}}},
                  Paragraph{"A remark."}};
  sheet.title_block = {"Slider-crank", "Velocities", "A source", {"1 : 5", "1 cm ≙ 2.5 m/s"}, 1, 2};
  return sheet;
}

bool has_text(const Page& page, const std::string& part) {
  for (const PlacedText& text : probe::all<PlacedText>(page))
    if (text.text.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("everything stands inside the frame, and nothing in the column or title block touches anything") {
  for (const Paper paper : {Paper::a4, Paper::a3})
    for (const Language language : {Language::english, Language::italian}) {
      std::vector<std::string> conflicts;
      const Page page = compose(example(paper, language), &conflicts);
      CHECK(conflicts == std::vector<std::string>{});
      const Box frame = grown(paper_box(paper), -10);
      for (const Primitive& primitive : page.primitives)
        CHECK(contains(grown(frame, 0.25 + 1e-9), ink_box(primitive)));
      CHECK(page.extent.width() == (paper == Paper::a4 ? 297 : 420));
      CHECK(page.extent.height() == (paper == Paper::a4 ? 210 : 297));
      CHECK(probe::disturbed(page, frame) == std::vector<std::string>{});
    }
}

TEST_CASE("a vector equation has one line, with smaller letters below before it is parted") {
  Sheet sheet = example(Paper::a4, Language::english);
  const auto baselines = [&](const std::vector<VectorEquation::Term>& terms) {
    sheet.column = {VectorEquation{terms}};
    std::set<double> all;
    for (const PlacedText& text : probe::all<PlacedText>(compose(sheet)))
      if (text.text.find("vec{a}") != std::string::npos) all.insert(text.baseline.y);
    return all.size();
  };
  std::vector<VectorEquation::Term> terms{{"$\\vec{a}^{n}_{B}$", "∥ $BB_{0}$", "$ω_{4}^{2}·B_{0}B$", ""},
                                          {"$\\vec{a}^{t}_{B}$", "⊥ $B_{0}B$", "?", "+"},
                                          {"$\\vec{a}_{A}$", "∥ $AA_{0}$", "$ω_{2}^{2}·A_{0}A$", "="},
                                          {"$\\vec{a}^{n}_{BA}$", "∥ $BA$", "$ω_{3}^{2}·AB$", "+"},
                                          {"$\\vec{a}^{t}_{BA}$", "⊥ $AB$", "?", "+"}};
  CHECK(baselines(terms) == 1);
  const auto last = terms.back();
  for (int i = 0; i < 4; ++i) terms.push_back(last);
  CHECK(baselines(terms) > 1);
}

TEST_CASE("figure, column and title block do not share paper") {
  for (const Paper paper : {Paper::a4, Paper::a3}) {
    const Layout parts = layout(paper, 40);
    CHECK(apart(parts.drawing, parts.column));
    CHECK(apart(parts.drawing, parts.title_block));
    CHECK(apart(parts.column, parts.title_block));
    CHECK(parts.drawing.width() > 0.62 * parts.frame.width());
  }
}

TEST_CASE("the title block says what the sheet is, in its language") {
  Sheet sheet = example(Paper::a3, Language::italian);
  const Page page = compose(sheet);
  for (const std::string part : {"Slider-crank", "Velocities", "A source", "1 : 5", "2.5 m/s", "A3", "1/2", "formato",
                                 "tavola", "fonte", "epure ", "100 %", "direzione", "modulo"}) {
    INFO(part);
    CHECK(has_text(page, part));
  }
  sheet.language = Language::english;
  for (const std::string part : {"paper", "sheet", "source", "direction", "magnitude"})
    CHECK(has_text(compose(sheet), part));
}

TEST_CASE("the check bar is 50 mm long") {
  int found = 0;
  for (const Stroke& stroke : probe::all<Stroke>(compose(example(Paper::a4, Language::english)))) {
    const Point d = stroke.path.pieces.back().end - stroke.path.start;
    if (d.y == 0 && std::abs(d.x - 50) < 1e-9) ++found;
  }
  CHECK(found == 1);
}

TEST_CASE("a bare sheet is cropped to its ink and 2 mm") {
  Sheet sheet = example(Paper::a4, Language::english);
  sheet.bare = true;
  const Page page = compose(sheet);
  CHECK_FALSE(has_text(page, "Velocities"));
  CHECK_FALSE(has_text(page, "Draw the crank"));
  const Box ink = ink_box(page.primitives);
  CHECK(page.extent.low.x == Approx(ink.low.x - 2));
  CHECK(page.extent.high.y == Approx(ink.high.y + 2));
  double top = -INFINITY;
  for (const Stroke& stroke : probe::all<Stroke>(page))
    for (const Point p : probe::samples(stroke.path, 0.1)) {
      CHECK(probe::strictly_inside(page.extent, p));
      top = std::max(top, p.y);
    }
  CHECK(page.extent.high.y < top + 8);
}

TEST_CASE("the crop counts the width of lines") {
  const Point p = middle(drawing_area(Paper::a4));
  Sheet sheet;
  sheet.id = "crop";
  sheet.bare = true;
  sheet.figure.marks = {Line{circle(p, 20), Meaning::link}};
  const Page page = compose(sheet);
  CHECK(page.extent.low.x == Approx(p.x - 20 - 0.25 - 2).margin(0.01));
  CHECK(page.extent.high.y == Approx(p.y + 20 + 0.25 + 2).margin(0.01));
}

TEST_CASE("composing twice gives the same page") {
  const Sheet sheet = example(Paper::a4, Language::english);
  CHECK(svg(sheet) == svg(sheet));
  CHECK(pdf({sheet}, "twice") == pdf({sheet}, "twice"));
}

TEST_CASE("bad numbers are refused by name") {
  const Point good{100, 100};
  for (const double bad : {not_a_number, infinite, -infinite, 1e11}) {
    const bool is_far = bad == 1e11;
    const std::vector<Mark> marks{Line{segment(good, {bad, 0}), Meaning::link, "bad"},
                                  Area{polyline({good, {0, bad}, {3, 3}}, true), Meaning::plate, "bad"},
                                  Arrow{good, {bad, 1}, Meaning::velocity, "bad"},
                                  Dot{{bad, bad}, Meaning::locus, "bad"},
                                  Cross{{bad, 0}, Meaning::locus, "bad"},
                                  Hinge{{bad, 0}},
                                  FixedHinge{{0, bad}},
                                  FixedHinge{good, bad},
                                  Slider{{bad, 0}},
                                  Guide{good, {bad, 0}},
                                  Rotation{{bad, 0}},
                                  RightAngle{{bad, 0}},
                                  ParallelMark{{bad, 0}},
                                  AngleMark{{bad, 0}},
                                  Dimension{good, {bad, 0}, 8, "bad"},
                                  Dimension{good, {0, 0}, bad, "bad"},
                                  ScaleBar{{bad, 0}, 40, 4, "", {}},
                                  ScaleBar{good, bad, 4, "", {}}};
    for (const Mark& mark : marks) {
      Sheet sheet = example(Paper::a4, Language::english);
      sheet.figure.marks.push_back(mark);
      INFO("mark kind " << mark.index() << " with " << bad);
      if (is_far) {
        CHECK_THROWS_AS(compose(sheet), TooFar);
        const bool is_named = mark.index() < 5;
        CHECK_THROWS_WITH(compose(sheet), Contains("e+11 mm is too far off the paper") &&
                                              Contains(is_named ? " bad: " : "") && !Contains("(mark"));
        continue;
      }
      CHECK_THROWS_WITH(compose(sheet), Contains("(mark 9): "));
      CHECK_THROWS_AS(compose(sheet), std::invalid_argument);
    }
    if (is_far) {
      Sheet sheet = example(Paper::a4, Language::english);
      sheet.figure.labels.push_back({"$Q_{1}$", {bad, 0}});
      CHECK_THROWS_WITH(compose(sheet), StartsWith("Q_1: 1e+11 mm is too far off the paper"));
      continue;
    }
    Sheet sheet = example(Paper::a4, Language::english);
    sheet.figure.labels.push_back({"Q", {bad, 0}});
    CHECK_THROWS_WITH(compose(sheet), Contains("label 'Q'"));
    sheet.figure.labels.back() = {"Q", good, Point{0, bad}};
    CHECK_THROWS_WITH(compose(sheet), Contains("label 'Q'"));
    sheet.figure.labels.pop_back();
    sheet.figure.steps.push_back({9, {bad, 0}});
    CHECK_THROWS_WITH(compose(sheet), Contains("step 9"));
  }
}

TEST_CASE("far geometry is cut to the drawing area") {
  const double far = GENERATE(1e6, 1e9);  // mm
  const Box area = drawing_area(Paper::a4);
  const Point centre = middle(area);
  Sheet sheet;
  sheet.id = "far";
  sheet.bare = true;
  for (int i = 0; i < 20; ++i) {
    sheet.figure.marks.push_back(Line{circle(centre + Point{far, 3.0 * i}, far), Meaning::axis, "arc"});
    sheet.figure.marks.push_back(
        Line{segment(centre - Point{far, 0.1 * far * i}, centre + Point{far, 0.1 * far * i}), Meaning::axis});
    sheet.figure.marks.push_back(Guide{centre - Point{far, 0}, centre + Point{far, 0}});
  }
  sheet.figure.marks.push_back(Area{circle(centre - Point{far, 0}, far)});
  const Page page = compose(sheet);
  const std::string bytes = pdf({sheet}, "far");
  CHECK(bytes.size() < 2'000'000);
  CHECK(probe::named<Stroke>(page, "arc").size() == 20);
  for (const Stroke& stroke : probe::all<Stroke>(page)) {
    if (stroke.clip) CHECK(contains(area, *stroke.clip));
    for (const Point p : probe::samples(stroke.path, 10)) {
      CHECK(contains(grown(area, stroke.clip ? 500 : 1e-9), p));
    }
  }
  // A large circle on the left, to its right end at the centre, covers the left half of the area.
  const auto fills = probe::all<Fill>(page);
  REQUIRE(fills.size() == 1);
  const Box covered = ink_box(fills[0]);
  CHECK(covered.low.x == Approx(area.low.x));
  CHECK(covered.high.x == Approx(centre.x).margin(0.1));
  CHECK(covered.height() == Approx(area.height()));
}

TEST_CASE("a curve is cut where it crosses the border, to a quarter of a step of the file") {
  const Box area = drawing_area(Paper::a4);
  const Point corner = area.low;
  for (const double radius : {0.7, 20.0, 90.0, 3000.0}) {
    CAPTURE(radius);
    // A quarter of it shows, or all that the area holds of it.
    const Path whole = circle(corner + Point{0.1, 0.1} - Point{radius, 0}, radius);
    const std::vector<Path> shown = clip_path(whole, area);
    REQUIRE(!shown.empty());
    for (const Path& run : shown) {
      CHECK(contains(area, bounds(run)));
      for (const Point end : {run.start, run.pieces.back().end}) {
        const double from_border =
            std::min({end.x - area.low.x, area.high.x - end.x, end.y - area.low.y, area.high.y - end.y});
        // Or where the circle begins, inside.
        CHECK((from_border <= file_resolution / 4 || distance(end, whole.start) == 0));
      }
    }
  }
}

TEST_CASE("marks keep to their window") {
  Sheet sheet;
  sheet.id = "windows";
  sheet.bare = true;
  const Point p = middle(drawing_area(Paper::a4));
  sheet.figure.windows = {{p, p + Point{30, 20}}};
  sheet.figure.marks = {Line{segment(p - Point{50, -5}, p + Point{50, 5}), Meaning::axis, "in"},
                        Line{circle(p, 15), Meaning::locus, "curve"},
                        Line{segment(p - Point{50, 0}, p + Point{50, 0}), Meaning::axis, "free"}};
  sheet.figure.window_of = {0, 0, -1};
  const Page page = compose(sheet);
  CHECK(contains(grown(sheet.figure.windows[0], 0.25), ink_box(probe::named<Stroke>(page, "in").at(0))));
  CHECK(contains(grown(sheet.figure.windows[0], 0.25), ink_box(probe::named<Stroke>(page, "curve").at(0))));
  CHECK(ink_box(probe::named<Stroke>(page, "free").at(0)).width() == Approx(100).epsilon(0.01));
}

TEST_CASE("an uncut line keeps its end points bit by bit") {
  Sheet sheet;
  sheet.id = "exact";
  const Point a{50.1, 60.7}, b{123.4567, 99.001};
  sheet.figure.marks = {Line{segment(a, b), Meaning::construction, "ab"}};
  const auto lines = probe::named<Stroke>(compose(sheet), "ab");
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].path.start.x == a.x);
  CHECK(lines[0].path.pieces[0].end.y == b.y);
}

TEST_CASE("a line cut at one end keeps the other bit by bit") {
  const Box box{{0, 0}, {1, 1}};
  for (int i = 1; i < 200; ++i) {
    const Point inside{i / 201.0, 0.1 + i / 301.0}, outside{1.7 + i * 0.013, 3.1 - i * 0.031};
    const auto leaving = clip_segment(inside, outside, box), entering = clip_segment(outside, inside, box);
    REQUIRE(leaving);
    REQUIRE(entering);
    CHECK(leaving->first.x == inside.x);
    CHECK(leaving->first.y == inside.y);
    CHECK(entering->second.x == inside.x);
    CHECK(entering->second.y == inside.y);
    CHECK(contains(box, leaving->second));
    CHECK(contains(box, entering->first));
  }
}

TEST_CASE("a long column is set smaller, and one too long is reported") {
  const auto column_of = [](int steps) {
    Sheet sheet = example(Paper::a4, Language::english);
    Steps many;
    for (int i = 0; i < steps; ++i)
      many.lines.push_back("One more step of the construction, in a line of usual length.");
    sheet.column = {many};
    return sheet;
  };
  const auto smallest = [](const Page& page) {
    double size = INFINITY;
    for (const PlacedText& text : probe::all<PlacedText>(page))
      if (text.text.starts_with("One more")) size = std::min(size, text.size);
    return size;
  };
  CHECK(overlaps(column_of(8)).empty());
  CHECK(smallest(compose(column_of(8))) == column_size);
  CHECK(overlaps(column_of(40)).empty());
  CHECK(smallest(compose(column_of(40))) < column_size);
  CHECK(smallest(compose(column_of(90))) == smallest_size);
  const auto conflicts = overlaps(column_of(90));
  REQUIRE(conflicts.size() == 1);
  CHECK(conflicts[0] == "the column does not fit beside the figure");
}

TEST_CASE("what does not fit is set with the least air") {
  const auto step_in_letters = [](std::size_t steps, double size) {
    Sheet sheet = example(Paper::a4, Language::english);
    sheet.column = {Steps{std::vector<std::string>(steps, "Draw a line.")}};
    std::vector<double> baselines;
    for (const PlacedText& text : probe::all<PlacedText>(compose(sheet)))
      if (text.text == "Draw a line.") baselines.push_back(text.baseline.y);
    REQUIRE(baselines.size() == steps);
    return (baselines[0] - baselines[1]) / size;
  };
  CHECK(step_in_letters(150, smallest_size) < 0.95 * step_in_letters(8, column_size));
}

TEST_CASE("tables put decimal signs in line") {
  const Table table{{"", "x"}, {{"a", "5.33"}, {"b", "13"}, {"c", "−0.125"}}};
  const auto ink = set_column({table}, {{0, 0}, {80, 100}}, Language::english, nullptr);
  std::vector<double> signs;
  for (const Primitive& primitive : ink)
    if (const auto* text = std::get_if<PlacedText>(&primitive))
      for (const std::string whole : {"5", "13", "−0"})
        if (text->text.starts_with(whole)) signs.push_back(text->baseline.x + measure(whole, text->size).width);
  REQUIRE(signs.size() == 3);
  CHECK(signs[0] == Approx(signs[1]));
  CHECK(signs[0] == Approx(signs[2]));
}

TEST_CASE("scale bars under other marks are reported") {
  Sheet sheet = example(Paper::a4, Language::english);
  const Point low = drawing_area(Paper::a4).low;
  sheet.figure.marks.push_back(Line{segment(low + Point{0, 9.2}, low + Point{100, 9.2}), Meaning::construction});
  const auto conflicts = overlaps(sheet);
  REQUIRE(conflicts.size() == 1);
  CHECK(conflicts[0].find("'1 : 5'") != std::string::npos);
}

TEST_CASE("numbers are written with the figures that mean something") {
  const auto en = [](double v, int n) { return number(v, n, Language::english); };
  CHECK(en(5.3, 3) == "5.30");
  CHECK(en(9.996, 3) == "10.0");
  CHECK(en(13.33, 2) == "13");
  CHECK(en(284.26, 4) == "284.3");
  CHECK(en(-0.5, 2) == "−0.50");
  CHECK(en(0.0012345, 3) == "0.00123");
  CHECK(en(0, 3) == "0.00");
  CHECK(en(12345, 3) == "12345");
  CHECK(en(1.5e-5, 3) == "$1.50·10^{−5}$");
  CHECK(en(-2.5e7, 2) == "$−2.5·10^{7}$");
  CHECK(number(5.3, 3, Language::italian) == "5,30");
  CHECK_THROWS_AS(en(not_a_number, 3), std::invalid_argument);
  CHECK_THROWS_AS(en(1, 0), std::invalid_argument);
}
