// Charts: numbers along the axes, the map to the paper, curves that stay apart and inside, letters that touch
// nothing.
#include "drawings/charts/chart.h"

#include <random>
#include <set>

#include "drawings/charts/chart_curves.h"
#include "drawings/charts/ticks.h"
#include "drawings/output.h"
#include "tests/drawings/probe.h"
#include "tests/support/catch.h"
#include "tests/support/read_svg.h"

using namespace epure::drawings;

namespace {

using probe::infinite;
using probe::not_a_number;
constexpr double degree = std::numbers::pi / 180;
using probe::a4_area;
constexpr auto logarithmic = AxisScale::logarithmic;

std::vector<std::string> texts(const Ticks& ticks) {
  std::vector<std::string> all;
  for (const Tick& tick : ticks.numbered) all.push_back(tick.text);
  return all;
}

std::vector<double> values(const Ticks& ticks) {
  std::vector<double> all;
  for (const Tick& tick : ticks.numbered) all.push_back(tick.value);
  return all;
}

Ticks up(const Axis& axis, double length, Language language = Language::english) {
  return ticks(axis, length, Along::vertical, language);
}
Ticks across(const Axis& axis, double length) { return ticks(axis, length, Along::horizontal, Language::english); }

template <typename Function>
std::vector<Datum> run(double from, double to, int count, Function y) {
  std::vector<Datum> points;
  for (int i = 0; i <= count; ++i) {
    const double x = from + (to - from) * i / count;
    points.push_back({x, y(x)});
  }
  return points;
}

const Axis angle{"$φ_{2}$", "°", 0, 360, AxisScale::linear, degree_steps};

// A crank of 0.1 m turning 0.25 m from the pivot of a slotted lever, and a tangent with its poles.
Chart velocities() {
  const auto lever = [](double p) {
    const double x = 0.1 * std::cos(p * degree), y = 0.25 + 0.1 * std::sin(p * degree);
    return 3 * (0.01 + 0.025 * std::sin(p * degree)) / (x * x + y * y);
  };
  const auto tangent = [](double p) { return 0.3 * std::tan(p * degree) - 1; };
  Chart chart{angle, {"$ω$", "rad/s", -4, 2.2}};
  chart.curves = {
      {.name = "omega_4", .runs = {run(0, 360, 360, lever)}, .meaning = Meaning::velocity, .label = "$ω_{4}$"},
      {.name = "omega_5",
       .runs = {run(0, 89.9999999, 180, tangent), run(90.0000001, 269, 360, tangent), run(271, 360, 180, tangent)},
       .meaning = Meaning::velocity,
       .label = "$ω_{5}$"}};
  chart.horizontals = {{0, "", Meaning::construction}};
  chart.verticals = {{210, "dead centre"}};
  chart.markers = {{{90, lever(90)}, "max 0.857"}, {{270, lever(270)}, "min −2"}};
  return chart;
}

Chart convergence() {
  const std::vector<Datum> newton{{0, .3}, {1, .04}, {2, 9e-4}, {3, 4e-7}, {4, 1e-13}, {5, 1.1e-16}};
  std::vector<Datum> chord, halving;
  for (int i = 0; i < 8; ++i) {
    chord.push_back({static_cast<double>(i), 0.3 * std::pow(6.5, -i)});
    halving.push_back({static_cast<double>(i), 0.3 * std::pow(2, -i)});
  }
  Chart chart{{"iteration", "", 0, 7, AxisScale::linear, whole_steps}, {"residual", "rad", 3e-17, 0.4, logarithmic}};
  const auto curve = [&](const std::string& name, const std::vector<Datum>& points, PointShape shape) {
    chart.curves.push_back({name, {points}, Meaning::text, LineType::of_its_meaning, points, shape, name});
  };
  curve("Newton", newton, PointShape::dot);
  curve("chord", chord, PointShape::ring);
  curve("bisection", halving, PointShape::square);
  chart.horizontals = {{2.2e-16, "$ε$"}};
  return chart;
}

Chart speed_against_error() {
  Chart chart{{"time", "s", 2e-8, 2.5, logarithmic}, {"error", "", 1e-18, 1e-9, logarithmic}};
  chart.markers = {{{3.3e-8, 3e-14}, "Fast"},
                   {{4e-7, 2e-13}, "Bounded", PointShape::ring},
                   {{5.1e-6, 1e-16}, "Lazy exact", PointShape::square},
                   {{6.3e-6, 1e-16}, "MPFR", PointShape::diamond},
                   {{1.2e-4, 1.1e-16}, "Exact $Q(√a)$", PointShape::triangle},
                   {{1.6e-4, 1.1e-16}, "CORE", PointShape::cross},
                   {{1e-3, 1.1e-16}, "Calcium", PointShape::plus},
                   {{1.2, 2e-10}, "ruler and compass"}};
  return chart;
}

Chart crowd(int count) {
  Chart chart{angle, {"$M$", "N m", -1.1e-30, 1.1e-30}};
  chart.x.low = 17;
  chart.x.high = 343;
  chart.x.to_ticks = false;
  for (int i = 0; i < count; ++i)
    chart.curves.push_back(
        {.name = "M",
         .runs = {run(17, 343, 300, [&](double p) { return 1e-30 * std::sin(3 * p * degree + i / 20.); })},
         .meaning = i % 2 ? Meaning::force : Meaning::velocity,
         .label = "$M_{" + std::to_string(i) + "}$"});
  return chart;
}

Sheet sheet_of(const Chart& chart, ChartMap* map = nullptr, Box box = a4_area,
               Language language = Language::english) {
  Sheet sheet;
  sheet.id = "chart";
  sheet.bare = true;
  sheet.language = language;
  const ChartMap drawn = draw(chart, box, sheet.figure, language);
  if (map) *map = drawn;
  return sheet;
}

std::string complaint(const Chart& chart, Box box = a4_area) {
  try {
    sheet_of(chart, nullptr, box);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

bool has_line(const Page& page, Point from, Point to) {
  for (const Stroke& stroke : probe::all<Stroke>(page))
    if (stroke.path.pieces.size() == 1 && distance(stroke.path.start, from) < 1e-9 &&
        distance(stroke.path.pieces[0].end, to) < 1e-9)
      return true;
  return false;
}

std::vector<std::string> strings(std::initializer_list<const char*> all) { return {all.begin(), all.end()}; }

}  // namespace

TEST_CASE("numbers of a linear axis: hand-worked") {
  // Ten intervals of 8 mm; steps of a half would leave 4 mm.
  const Ticks plain = up({.low = -4, .high = 6}, 80);
  CHECK(texts(plain) == strings({"−4", "−3", "−2", "−1", "0", "1", "2", "3", "4", "5", "6"}));
  CHECK(values(plain) == std::vector<double>{-4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6});
  CHECK(plain.low == -4);
  CHECK(plain.high == 6);
  CHECK(plain.power == 0);
  // Ends are moved outwards: -4.1 to -6 and 6.2 to 8 in steps of two, as thirteen steps of one would not fit.
  const Ticks widened = up({.low = -4.1, .high = 6.2}, 80);
  CHECK(texts(widened) == strings({"−6", "−4", "−2", "0", "2", "4", "6", "8"}));
  CHECK(widened.low == -6);
  CHECK(widened.high == 8);
  // Short ticks every half: 80/28 = 2.9 mm; every fifth would be 1.1 mm.
  CHECK(widened.between.size() == 7 * 3);
  CHECK(std::count(widened.between.begin(), widened.between.end(), -0.5) == 1);
  // Steps of a twentieth, and an end that misses 0.3 by a rounding: the number is the double nearest to 0.3.
  const Ticks kept = up({.low = 0.1 + 0.2, .high = 0.7, .to_ticks = false}, 80);
  CHECK(texts(kept) == strings({"0.30", "0.35", "0.40", "0.45", "0.50", "0.55", "0.60", "0.65", "0.70"}));
  CHECK(values(kept) == std::vector<double>{0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7});
  CHECK(kept.low == 0.1 + 0.2);
}

TEST_CASE("numbers in Italian have a comma, and a true minus sign") {
  CHECK(texts(up({.low = -1, .high = 1}, 30, Language::italian)) == strings({"−1,0", "−0,5", "0", "0,5", "1,0"}));
}

TEST_CASE("angles and counts have their own steps") {
  // 150 mm: every 30° is 12.5 mm. 100 mm: every 45°, with short ticks every 15°. 65 mm: every 90° (60° would
  // be 10.8).
  const Axis axis{.low = 0, .high = 360, .steps = degree_steps};
  CHECK(values(across(axis, 150)).size() == 13);
  CHECK(values(across(axis, 100)) == std::vector<double>{0, 45, 90, 135, 180, 225, 270, 315, 360});
  CHECK(across(axis, 100).between.size() == 16);
  CHECK(texts(across(axis, 65)) == strings({"0", "90", "180", "270", "360"}));
  // Half a degree is less than the smallest step: decimals after all.
  CHECK(texts(across({.low = 0, .high = 0.5, .steps = degree_steps}, 65)) ==
        strings({"0", "0.1", "0.2", "0.3", "0.4", "0.5"}));
  // Iterations have no halves, however much room there is.
  const Ticks counts = across({.low = 0, .high = 3, .steps = whole_steps}, 200);
  CHECK(texts(counts) == strings({"0", "1", "2", "3"}));
  CHECK(counts.between.empty());
}

TEST_CASE("large and small numbers share a power of ten in the title") {
  const Axis a{.quantity = "$a$", .unit = "m/s²", .low = -250000, .high = 180000};
  const Ticks thousands = up(a, 80);
  CHECK(thousands.power == 3);
  CHECK(texts(thousands) == strings({"−250", "−200", "−150", "−100", "−50", "0", "50", "100", "150", "200"}));
  CHECK(thousands.numbered.front().value == -250000);
  CHECK(title(a, 3) == "$a$ ($10^{3}$ m/s²)");
  CHECK(title(a) == "$a$ (m/s²)");
  CHECK(title({.quantity = "$n$"}, 6) == "$n$ ($10^{6}$)");
  CHECK(title({.quantity = "$n$"}) == "$n$");
  const Ticks tiny = up({.low = -1e-30, .high = 1e-30}, 30);
  CHECK(tiny.power == -30);
  CHECK(texts(tiny) == strings({"−1.0", "−0.5", "0", "0.5", "1.0"}));
  CHECK(tiny.numbered.back().value == 1e-30);
  const Ticks huge = up({.low = 0, .high = 3e12}, 30);
  CHECK(huge.power == 12);
  CHECK(texts(huge) == strings({"0", "1", "2", "3"}));
  CHECK(huge.numbered.back().value == 3e12);
}

TEST_CASE("numbers of a logarithmic axis: hand-worked") {
  // Seventeen decades on 80 mm: every second is numbered, the others get short ticks; the end moves to 10^-18.
  const Ticks many = up({.low = 3e-17, .high = 0.4, .scale = logarithmic}, 80);
  CHECK(values(many) == std::vector<double>{1e-18, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 1});
  CHECK(texts(many).front() == "$10^{-18}$");
  CHECK(texts(many).back() == "$10^{0}$");
  CHECK(many.low == 1e-18);
  CHECK(many.high == 1);
  CHECK(many.between == std::vector<double>{1e-17, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3, 1e-1});
  // Three decades on 60 mm: short ticks at 2 to 9 of each.
  const Ticks few = across({.low = 1, .high = 1000, .scale = logarithmic}, 60);
  CHECK(texts(few) == strings({"$10^{0}$", "$10^{1}$", "$10^{2}$", "$10^{3}$"}));
  REQUIRE(few.between.size() == 24);
  CHECK(few.between.front() == 2);
  CHECK(few.between.back() == 900);
  // Ends that are to stay and hold no two powers of ten: 2, 5, 10, ...; and narrower still, as a linear axis.
  const Ticks narrow = across({.low = 2, .high = 30, .scale = logarithmic, .to_ticks = false}, 80);
  CHECK(texts(narrow) == strings({"2", "5", "10", "20"}));
  CHECK(narrow.between == std::vector<double>{3, 4, 6, 7, 8, 9, 30});
  CHECK(values(across({.low = 2.1, .high = 2.5, .scale = logarithmic, .to_ticks = false}, 80)) ==
        std::vector<double>{2.1, 2.2, 2.3, 2.4, 2.5});
  const Ticks all = up({.low = 1e-280, .high = 1e280, .scale = logarithmic}, 100);
  CHECK(values(all) == std::vector<double>{1e-300, 1e-250, 1e-200, 1e-150, 1e-100, 1e-50, 1, 1e50, 1e100, 1e150,
                                           1e200, 1e250, 1e300});
}

TEST_CASE("random axes: numbers say their value, keep their distance and reach the ends") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-40, 40), length(25, 250);
  for (int round = 0; round < 600; ++round) {
    Axis axis;
    const double size = std::pow(10, exponent(random));
    const double first = mantissa(random) * size, second = mantissa(random) * size;
    axis.low = std::min(first, second);
    axis.high = std::max(first, second);
    if (round % 3 == 0) {
      axis.scale = logarithmic;
      axis.low = std::pow(10, exponent(random));
      axis.high = axis.low * std::pow(10, 0.01 + std::abs(exponent(random)));
    }
    axis.to_ticks = round % 2 == 0;
    const double mm = length(random);
    const Along along = round % 4 < 2 ? Along::horizontal : Along::vertical;
    const Ticks found = ticks(axis, mm, along, Language::english);
    CAPTURE(axis.low, axis.high, mm, axis.to_ticks);
    const AxisMap map = axis_map(axis, found.low, found.high, 0, mm);
    REQUIRE(found.numbered.size() >= 2);
    CHECK(found.low <= axis.low + 1e-6 * (axis.high - axis.low));
    CHECK(found.high >= axis.high - 1e-6 * (axis.high - axis.low));
    double before = -infinite;
    for (const Tick& tick : found.numbered) {
      std::string text = tick.text;
      if (text.starts_with("$10^{")) text = "1e" + text.substr(5, text.size() - 7);
      if (text.starts_with("−")) text.replace(0, std::string("−").size(), "-");
      if (found.power != 0) text += "e" + std::to_string(found.power);
      CHECK(std::stod(text) == tick.value);
      const double at = map.at(tick.value);
      CHECK((at > -1e-3 && at < mm + 1e-3));
      CHECK(at - before >= (along == Along::horizontal ? 12 : 7) * (found.numbered.size() > 2 ? 1 : 0.1));
      before = at;
    }
    for (const double value : found.between) CHECK((map.at(value) > -1e-3 && map.at(value) < mm + 1e-3));
  }
}

TEST_CASE("the map leads from numbers to the paper and back") {
  ChartMap map;
  const Sheet sheet = sheet_of(velocities(), &map);
  const Box frame = map.frame;
  CHECK(contains(a4_area, frame));
  // -4 to 2.2 in steps of a half: up to 2.5.
  CHECK(distance(map.at({0, -4}), frame.low) < 1e-9);
  CHECK(distance(map.at({360, 2.5}), frame.high) < 1e-9);
  CHECK(distance(map.at({90, -0.75}), frame.low + Point{frame.width() / 4, frame.height() / 2}) < 1e-9);
  CHECK(map.x.per_mm() == Approx(360 / frame.width()));
  CHECK(map.y.per_mm() == Approx(6.5 / frame.height()));
  CHECK(map.y.value(map.y.at(1.234)) == Approx(1.234));

  // The axes are drawn where the map says: a long tick at 90°, from the frame inwards, on both sides.
  const Page page = compose(sheet);
  const double x = frame.low.x + frame.width() / 4;
  CHECK(has_line(page, {x, frame.low.y}, {x, frame.low.y + 2}));
  CHECK(has_line(page, {x, frame.high.y}, {x, frame.high.y - 2}));
  const double y = frame.low.y + frame.height() * 4 / 6.5;
  CHECK(has_line(page, {frame.low.x, y}, {frame.low.x + 2, y}));
  CHECK(has_line(page, {frame.low.x, y}, {frame.high.x, y}));  // the zero line
  // ... and its number stands below it.
  bool below = false;
  for (const PlacedText& text : probe::all<PlacedText>(page)) {
    const Box box = probe::text_box(text);
    below = below || (text.text == "90" && std::abs(middle(box).x - x) < 1e-9 && box.high.y < frame.low.y);
  }
  CHECK(below);
}

TEST_CASE("the map of logarithmic axes") {
  ChartMap map;
  sheet_of(speed_against_error(), &map);
  // 10^-8 to 10^1, and 10^-18 to 10^-9: nine decades each.
  CHECK(distance(map.at({1e-8, 1e-18}), map.frame.low) < 1e-9);
  CHECK(distance(map.at({1e1, 1e-9}), map.frame.high) < 1e-9);
  CHECK(map.x.at(1e-5) == Approx(map.frame.low.x + map.frame.width() / 3));
  CHECK(map.y.per_mm() == Approx(9 / map.frame.height()));
  CHECK(map.y.value(map.y.at(3e-12)) == Approx(3e-12));
}

TEST_CASE("a value read off the file is the value drawn") {
  Chart chart{angle, {"$ω$", "rad/s", -4, 6}};
  chart.curves = {{.name = "omega", .runs = {{{30, -3.21}, {210, 5.43}}}}};
  ChartMap map;
  Sheet sheet = sheet_of(chart, &map);
  const double mm_apart = SvgFile(svg(sheet)).length("chart-omega");
  const double dx = 180 / map.x.per_mm(), dy = (5.43 + 3.21) / map.y.per_mm();
  CHECK(mm_apart == Approx(std::hypot(dx, dy)).margin(file_resolution * std::sqrt(2) + 2e-6));
}

TEST_CASE("runs are not joined") {
  ChartMap map;
  Chart chart = velocities();
  chart.curves[1].runs = {{{0, -1}, {60, 0.5}, {90, 2}}, {{90, -3}, {180, -2}}, {{270, 0}}};
  const SvgFile file(svg(sheet_of(chart, &map)));
  const auto first = file.points("chart-omega_5"), second = file.points("chart-omega_5-2");
  REQUIRE(first.size() == 3);
  REQUIRE(second.size() == 2);
  const auto apart = [&](Point p, Point q, Datum a, Datum b) {
    const Point on_file = q - p, expected = map.at(b) - map.at(a);
    CHECK(on_file.x == Approx(expected.x).margin(0.002));
    CHECK(-on_file.y == Approx(expected.y).margin(0.002));  // downwards in the file
  };
  apart(first[0], first[2], {0, -1}, {90, 2});
  apart(first[2], second[0], {90, 2}, {90, -3});
  apart(second[0], second[1], {90, -3}, {180, -2});
  // A run of one point is a point.
  CHECK(std::string(file.element("chart-omega_5_point").name()) == "path");
  for (const std::string& id : file.ids()) CHECK(id != "chart-omega_5-3");
}

TEST_CASE("curves never leave the frame") {
  Chart chart = velocities();
  chart.curves.push_back({.name = "wild", .runs = {{{-1e300, -1e300}, {90, 0}, {180, 1e300}, {1e300, -1}}}});
  chart.curves.push_back({.name = "outside", .runs = {{{400, 0}, {500, 1}}}, .points = {{400, 0}}, .label = "out"});
  chart.markers.push_back({{90, 100}, "far"});
  ChartMap map;
  const Page page = compose(sheet_of(chart, &map));
  for (const std::string name : {"omega_4", "omega_5", "wild"}) CHECK_FALSE(probe::named<Stroke>(page, name).empty());
  int curves = 0;
  for (const Stroke& stroke : probe::all<Stroke>(page)) {
    const bool black_or_grey = stroke.colour.red == stroke.colour.blue;
    if (black_or_grey) continue;
    ++curves;
    for (const Point p : probe::samples(stroke.path, 0.3)) CHECK(contains(grown(map.frame, 1e-9), p));
  }
  CHECK(curves == 5);  // one, three and one
  CHECK(probe::named<Stroke>(page, "outside").empty());
  CHECK(overlaps(sheet_of(chart)) == std::vector<std::string>{});  // what is off the chart asks for no place
  for (const PlacedText& text : probe::all<PlacedText>(page)) CHECK((text.text != "far" && text.text != "out"));
  // Towards a pole the curve reaches the frame itself: the runs end at 89.9999999° and begin again after 90°.
  double top = 0;
  for (const Stroke& stroke : probe::named<Stroke>(page, "omega_5"))
    for (const Point p : probe::samples(stroke.path, 0.3)) top = std::max(top, p.y);
  CHECK(top == Approx(map.frame.high.y).margin(1e-6));
}

TEST_CASE("letters of charts touch nothing, and stay in their box") {
  Chart single{{"$t$", "s", 0, 3e12}, {"$n$", "", 2, 7, logarithmic, {}, false}};
  single.curves = {{.name = "p", .runs = {{{1e12, 3}}}, .label = "A"}};
  Chart told = velocities();
  told.legend = true;
  const std::vector<Box> boxes{a4_area,
                               {a4_area.low, a4_area.low + Point{120, 90}},
                               {a4_area.low + Point{60, 80}, a4_area.low + Point{150, 140}},
                               {a4_area.low, {a4_area.high.x, a4_area.low.y + 60}}};
  const std::vector<Chart> charts{velocities(), convergence(), speed_against_error(), crowd(3), crowd(7),
                                  single,       told};
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (std::size_t j = 0; j < boxes.size(); ++j)
      for (const Language language : {Language::english, Language::italian}) {
        CAPTURE(i, j);
        ChartMap map;
        std::vector<std::string> conflicts;
        const Sheet sheet = sheet_of(charts[i], &map, boxes[j], language);
        const Page page = compose(sheet, &conflicts);
        CHECK(conflicts == std::vector<std::string>{});
        CHECK(probe::disturbed(page, a4_area) == std::vector<std::string>{});
        for (const PlacedText& text : probe::all<PlacedText>(page)) {
          INFO(text.text);
          CHECK(contains(grown(boxes[j], 1.2), probe::text_box(text)));
        }
      }
}

TEST_CASE("a curve's label is nearer to its curve than to any other") {
  Chart chart{angle, {"$s$", "m", -0.3, 0.3}};
  for (int i = 1; i <= 4; ++i)
    chart.curves.push_back({.name = "s" + std::to_string(i),
                            .runs = {run(0, 360, 180,
                                         [&](double p) {
                                           return 0.07 * i * std::sin(p * degree) /
                                                  (1.2 + 0.2 * i * std::cos(p * degree));
                                         })},
                            .label = "$e$ = 0." + std::to_string(i) + " m"});
  ChartMap map;
  const Page page = compose(sheet_of(chart, &map, {a4_area.low, a4_area.low + Point{180, 90}}));
  const auto to_curve = [&](const Box& box, int i) {
    double least = infinite;
    for (const Datum& datum : chart.curves[static_cast<std::size_t>(i - 1)].runs[0])
      if (const Point p = map.at(datum); contains(map.frame, p))
        least = std::min(least, distance(p, nearest_in(box, p)));
    return least;
  };
  int labels = 0;
  for (const PlacedText& text : probe::all<PlacedText>(page)) {
    if (!text.text.starts_with("$e$")) continue;
    ++labels;
    const int own = text.text[8] - '0';
    const Box box = probe::text_box(text);
    CHECK(to_curve(box, own) < 4);
    for (int i = 1; i <= 4; ++i)
      if (i != own) CHECK(to_curve(box, i) > to_curve(box, own));
  }
  CHECK(labels == 4);
}

TEST_CASE("labels of neighbouring curves stand outside, not between them") {
  Chart chart{{"$x$", "m", 0, 10}, {"$y$", "m", -10, 10}};
  chart.curves = {{.name = "upper", .runs = {{{0, 0.2}, {10, 0.2}}}, .label = "upper"},
                  {.name = "lower", .runs = {{{0, -0.4}, {10, -0.4}}}, .label = "lower"}};
  ChartMap map;
  const Sheet sheet = sheet_of(chart, &map);
  for (const PlacedText& text : probe::all<PlacedText>(compose(sheet))) {
    if (text.text == "upper") CHECK(probe::text_box(text).low.y > map.y.at(0.2));
    if (text.text == "lower") CHECK(probe::text_box(text).high.y < map.y.at(-0.4));
  }
}

TEST_CASE("random charts: names stand free in the frame, and beside their own curve") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  int names = 0, legends = 0;
  for (int round = 0; round < 50; ++round) {
    Chart chart{angle, {"$M$", "N m", -1.1, 1.1}};
    for (int i = 0; i <= round % 4; ++i) {
      const double a = share(random), f = 1 + 3 * share(random), shift = 6 * share(random);
      const auto points = run(0, 360, 180, [&](double p) { return a * std::sin(f * p * degree + shift); });
      chart.curves.push_back({.name = "M", .runs = {points}, .label = "curve " + std::to_string(i)});
      for (int k = static_cast<int>(6 * share(random)); k > 0; --k)
        chart.markers.push_back(
            {points[static_cast<std::size_t>(180 * share(random))], "value " + std::to_string(k)});
    }
    const Point size{60 + 110 * share(random), 45 + 90 * share(random)};
    CAPTURE(round);
    ChartMap map;
    std::vector<std::string> conflicts;
    const Page page = compose(sheet_of(chart, &map, {a4_area.low, a4_area.low + size}), &conflicts);
    for (const std::string& conflict : conflicts) CHECK_THAT(conflict, !Contains("'curve"));
    bool legend = false;
    for (const PlacedText& text : probe::all<PlacedText>(page)) {
      if (!text.text.starts_with("curve")) continue;
      const Box box = probe::text_box(text);
      if (box.low.y > map.frame.high.y) {
        legend = true;
        continue;
      }
      ++names;
      CHECK(contains(map.frame, box));
      const auto own = static_cast<std::size_t>(text.text.back() - '0');
      std::vector<double> away;
      for (const Curve& curve : chart.curves) {
        away.push_back(infinite);
        for (std::size_t k = 1; k < curve.runs[0].size(); ++k)
          for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            const Point p = between(map.at(curve.runs[0][k - 1]), map.at(curve.runs[0][k]), t);
            away.back() = std::min(away.back(), distance(p, nearest_in(box, p)));
          }
      }
      CHECK(away[own] < 5.2);
      for (std::size_t i = 0; i < away.size(); ++i)
        if (i != own) CHECK(away[i] > away[own] - 0.3);  // half the distance of the points sampled here
    }
    legends += legend ? 1 : 0;
  }
  CHECK(names > 50);
  CHECK(legends > 2);
}

TEST_CASE("the value of a special point has the first choice of place, the name of its curve the second") {
  Chart chart{angle, {"$ω$", "rad/s", -1, 1}};
  chart.curves = {{.name = "omega", .runs = {{{0, 0}, {360, 0}}}, .label_near_x = 182}};
  chart.markers = {{{180, 0}, "0.000"}};
  const auto value_at = [&] {
    for (const PlacedText& text : probe::all<PlacedText>(compose(sheet_of(chart))))
      if (text.text == "0.000") return text.baseline;
    return Point{};
  };
  const Point alone = value_at();
  chart.curves[0].label = "$ω_{4}$";
  const Point beside_name = value_at();
  CHECK(distance(alone, beside_name) < 1e-9);
}

TEST_CASE("letters of a point on an axis stand within the frame, where no numbers are") {
  for (const Datum at : {Datum{100, -1}, Datum{0, 0.3}}) {
    Chart chart{angle, {"$ω$", "rad/s", -1, 1}};
    chart.markers = {{at, "$A$"}};
    ChartMap map;
    const Page page = compose(sheet_of(chart, &map));
    for (const PlacedText& text : probe::all<PlacedText>(page))
      if (text.text == "$A$") CHECK(contains(map.frame, probe::text_box(text)));
  }
}

TEST_CASE("a label stands where it is wished") {
  for (const double wish : {40.0, 140.0, 330.0}) {
    Chart chart = velocities();
    chart.curves[0].label_near_x = wish;
    ChartMap map;
    const Page page = compose(sheet_of(chart, &map));
    int found = 0;
    for (const PlacedText& text : probe::all<PlacedText>(page))
      if (text.text == "$ω_{4}$") {
        ++found;
        CHECK(std::abs(middle(probe::text_box(text)).x - map.x.at(wish)) < 15);
      }
    CHECK(found == 1);
  }
}

TEST_CASE("where there is no room beside curves, a legend shows each with its line") {
  ChartMap map;
  const Sheet sheet = sheet_of(crowd(7), &map, {a4_area.low, a4_area.low + Point{140, 80}});
  const Page page = compose(sheet);
  std::vector<Stroke> above;
  for (const Stroke& stroke : probe::all<Stroke>(page))
    if (stroke.path.start.y > map.frame.high.y + 0.5 && stroke.path.pieces.size() == 1) above.push_back(stroke);
  REQUIRE(above.size() == 7);
  const auto curves = probe::named<Stroke>(page, "M");
  REQUIRE(curves.size() == 7);
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK(above[i].dashes.size() == curves[i].dashes.size());
    CHECK(above[i].colour.red == curves[i].colour.red);
  }
  // Three curves are labelled directly where they are apart, and get a legend when it is asked for.
  Chart apart = velocities();
  const auto inside = [&](const Chart& chart) {
    int count = 0;
    for (const PlacedText& text : probe::all<PlacedText>(compose(sheet_of(chart, &map))))
      if (text.text.starts_with("$ω_") && contains(map.frame, probe::text_box(text))) ++count;
    return count;
  };
  CHECK(inside(apart) == 2);
  apart.legend = true;
  CHECK(inside(apart) == 0);
}

TEST_CASE("curves are told apart in black and white") {
  const auto key = [](const Look& look) {
    return std::pair{look.line, look.marks ? static_cast<int>(*look.marks) : -1};
  };
  std::set<std::pair<LineType, int>> seen;
  for (const Look& look : looks(crowd(20).curves, true)) seen.insert(key(look));
  CHECK(seen.size() == 20);
  // Beside labels four line types must do.
  const auto plain = looks(crowd(5).curves, false);
  for (const Look& look : plain) CHECK_FALSE(look.marks);
  CHECK(plain[4].line == LineType::continuous);
  // What is told is kept, and what differs by its points needs no dashes.
  Chart told = crowd(3);
  for (Curve& curve : told.curves) curve.line = LineType::dotted;
  for (const Look& look : looks(told.curves, true)) CHECK(look.line == LineType::dotted);
  for (const Look& look : looks(convergence().curves, true)) CHECK(look.line == LineType::continuous);
  // Points get shapes of their own, those told excepted.
  Chart scatter = crowd(4);
  for (Curve& curve : scatter.curves) {
    curve.points = curve.runs[0];
    curve.runs.clear();
  }
  scatter.curves[2].shape = PointShape::plus;
  std::vector<PointShape> given;
  for (const Look& look : looks(scatter.curves, true)) given.push_back(look.shape);
  CHECK(given == std::vector{PointShape::dot, PointShape::ring, PointShape::plus, PointShape::square});
  // A meaning that is drawn dashed stays dashed; the next of its kind does not.
  const auto loci = looks({{.runs = {{{0, 0}, {1, 1}}}, .meaning = Meaning::second_locus},
                           {.runs = {{{0, 0}, {1, 1}}}, .meaning = Meaning::second_locus}},
                          true);
  CHECK(loci[0].line == LineType::dashed);
  CHECK(loci[1].line == LineType::continuous);
}

TEST_CASE("the line type of a mark prevails over its meaning's") {
  Sheet sheet;
  sheet.bare = true;
  const Path path = segment(middle(a4_area), middle(a4_area) + Point{60, 0});
  sheet.figure.marks = {Line{path, Meaning::axis, "a", LineType::continuous},
                        Line{path, Meaning::velocity, "b", LineType::dash_dotted},
                        Line{path, Meaning::velocity, "c", LineType::dotted}, Line{path, Meaning::second_locus, "d"}};
  const Page page = compose(sheet);
  CHECK(probe::named<Stroke>(page, "a")[0].dashes.empty());
  CHECK(probe::named<Stroke>(page, "b")[0].dashes.size() == 4);
  REQUIRE(probe::named<Stroke>(page, "c")[0].dashes.size() == 2);
  REQUIRE(probe::named<Stroke>(page, "d")[0].dashes.size() == 2);
  CHECK(probe::named<Stroke>(page, "c")[0].dashes[0] < probe::named<Stroke>(page, "d")[0].dashes[0]);
}

TEST_CASE("what gives no scale is refused, by the name of the axis") {
  const auto with = [](double low, double high, AxisScale scale = AxisScale::linear) {
    Chart chart = velocities();
    chart.y.low = low;
    chart.y.high = high;
    chart.y.scale = scale;
    return complaint(chart);
  };
  for (const auto& [low, high] :
       {std::pair{5.0, 5.0}, std::pair{0.0, 0.0}, std::pair{6.0, -4.0}, std::pair{not_a_number, 1.0},
        std::pair{0.0, not_a_number}, std::pair{-infinite, 1.0}, std::pair{0.0, infinite}, std::pair{-1e301, 1e301},
        std::pair{1.0, 1.0 + 1e-12}, std::pair{0.0, 1e-300}}) {
    CAPTURE(low, high);
    CHECK_THAT(with(low, high), StartsWith("axis ω (rad/s): "));
  }
  CHECK(with(5, 5) == "axis ω (rad/s): both ends are 5");
  CHECK_THAT(with(0, 1, logarithmic), StartsWith("axis ω (rad/s): a logarithmic axis has no place for 0"));
  CHECK_THAT(with(-1, 1, logarithmic), StartsWith("axis ω (rad/s): "));
  Chart across_refused = velocities();
  across_refused.x.high = 0;
  CHECK(complaint(across_refused) == "axis φ_2 (°): both ends are 0");
  across_refused.x.high = 360;
  across_refused.x.steps = {0, 30};
  CHECK_THAT(complaint(across_refused), Contains("a step of 0"));
}

TEST_CASE("what has no place on a chart is refused, by its name") {
  Chart chart = velocities();
  chart.curves[1].runs[0][3].y = not_a_number;
  CHECK_THAT(complaint(chart), StartsWith("curve 'omega_5': nan"));
  chart = velocities();
  chart.curves[0].points = {{infinite, 0}};
  CHECK_THAT(complaint(chart), StartsWith("curve 'omega_4': inf"));
  chart = convergence();
  chart.curves[0].runs[0].push_back({6, 0});
  CHECK(complaint(chart) == "curve 'Newton': 0 has no place on a logarithmic axis");
  chart = velocities();
  chart.markers[0].at.y = not_a_number;
  CHECK_THAT(complaint(chart), StartsWith("marker 'max 0.857': nan"));
  chart = velocities();
  chart.horizontals[0].at = infinite;
  CHECK_THAT(complaint(chart), StartsWith("horizontal line: inf"));
  for (const Box box : {Box{{0, 0}, {25, 100}}, Box{{0, 0}, {100, 25}}, Box{{0, 0}, {not_a_number, 100}},
                        Box{{0, 0}, {100, -100}}, Box{{0, 0}, {infinite, 100}}, Box{{0, 0}, {1e9, 1e9}}})
    CHECK_THAT(complaint(velocities(), box), StartsWith("chart: its box"));
}

TEST_CASE("huge and tiny ranges are drawn like any other") {
  for (const double size : {1e-280, 1e-30, 1e-3, 1.0, 1e5, 1e12, 1e290}) {
    Chart chart{{"$x$", "m", -size, size}, {"$y$", "m", 0, size}};
    chart.curves = {{.name = "y", .runs = {{{-size, 0}, {0, size}, {size, 0}}}, .label = "$y$"}};
    ChartMap map;
    const Sheet sheet = sheet_of(chart, &map);
    CAPTURE(size);
    CHECK(overlaps(sheet) == std::vector<std::string>{});
    const auto points = SvgFile(svg(sheet)).points("chart-y");
    REQUIRE(points.size() == 3);
    CHECK(points[1].x - points[0].x == Approx(map.frame.width() / 2).margin(0.002));
    CHECK(points[0].y - points[1].y == Approx(map.frame.height()).margin(0.002));
  }
}

TEST_CASE("a curve of many points is drawn by fewer, within half a step of the file") {
  Chart chart{{"$x$", "m", 0, 10}, {"$y$", "m", -1, 1}};
  chart.curves = {{.name = "y", .runs = {run(0, 10, 4000, [](double x) { return std::sin(x); })}, .label = "$y$"}};
  ChartMap map;
  const Page page = compose(sheet_of(chart, &map));
  const auto drawn = probe::named<Stroke>(page, "y");
  REQUIRE(drawn.size() == 1);
  CHECK(drawn[0].path.pieces.size() < 1000);
  for (const Datum& datum : chart.curves[0].runs[0]) {
    const Point p = map.at(datum);
    double nearest = INFINITY;
    Point from = drawn[0].path.start;
    for (const Piece& piece : drawn[0].path.pieces) {
      const Point way = piece.end - from;
      const double t = std::clamp(dot(p - from, way) / dot(way, way), 0.0, 1.0);
      nearest = std::min(nearest, distance(p, from + t * way));
      from = piece.end;
    }
    if (!(nearest <= file_resolution / 2 * (1 + 1e-6))) CHECK(nearest <= file_resolution / 2);
  }
}

TEST_CASE("frames of charts above each other line up when they are given the same room for letters") {
  Chart above = velocities(), below = velocities();
  above.letters_left = below.letters_left = 16;
  below.y = {"$a$", "m/s²", -9000, 20000};
  ChartMap first, second;
  Figure figure;
  figure.marks = {Dot{middle(a4_area)}};
  first = draw(above, {a4_area.low + Point{0, 90}, a4_area.high}, figure, Language::english);
  const std::size_t windows = figure.windows.size();
  second = draw(below, {a4_area.low, {a4_area.high.x, a4_area.low.y + 85}}, figure, Language::english);
  CHECK(first.frame.low.x == a4_area.low.x + 16);
  CHECK(first.frame.low.x == second.frame.low.x);
  CHECK(first.frame.high.x == second.frame.high.x);
  // Marks drawn earlier keep their window, the next chart's get windows of their own.
  CHECK(figure.window_of[0] == -1);
  CHECK(figure.windows.size() == 2 * windows);
  CHECK(figure.window_of.size() == figure.marks.size());
  std::vector<double> lows;
  for (std::size_t i = 0; i < figure.marks.size(); ++i)
    if (const auto* line = std::get_if<Line>(&figure.marks[i]); line && line->name == "omega_4")
      lows.push_back(figure.windows[static_cast<std::size_t>(figure.window_of[i])].low.y);
  CHECK(lows == std::vector<double>{first.frame.low.y, second.frame.low.y});
}

TEST_CASE("charts are the same bytes every time") {
  const std::vector<Sheet> sheets{sheet_of(velocities()), sheet_of(convergence()), sheet_of(crowd(7))};
  const std::string first = pdf(sheets, "charts"), first_svg = svg(sheets[0]);
  CHECK(pdf({sheet_of(velocities()), sheet_of(convergence()), sheet_of(crowd(7))}, "charts") == first);
  CHECK(svg(sheet_of(velocities())) == first_svg);
}
