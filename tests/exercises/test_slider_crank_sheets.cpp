// The slider-crank's sheets: all of them are drawn whatever is given, and the files measured back give the
// quantities.
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "drawings/output.h"
#include "tests/exercises/arc_arrow.h"
#include "tests/exercises/slider_crank_cases.h"
#include "tests/support/catch.h"
#include "tests/support/read_svg.h"

using namespace epure;
using namespace epure::tests;
using drawings::Language;
using drawings::Paper;

namespace {

DrawnSheet draw(const std::string& id, const std::string& sheet, const std::vector<std::string>& assignments,
                const SheetRequest& request = {}) {
  return exercise(id).draw(sheet, givens_of(id, assignments), request);
}

std::vector<std::pair<std::string, std::string>> all_sheets() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const std::string& id : {of_velocity, of_acceleration})
    for (const SheetSpec& sheet : exercise(id).about().sheets) all.emplace_back(id, sheet.name);
  return all;
}

// An arrow in a file: from the tail of its shaft to the tip of its head, in mm of paper, y downwards.
struct Drawn {
  double length;
  drawings::Point from, tip;
};
Drawn arrow(const drawings::SvgFile& svg, const std::string& id) {
  const drawings::Point from = svg.points(id).front(), tip = svg.points(id + "_head").front();
  return {std::hypot(tip.x - from.x, tip.y - from.y), from, tip};
}

// What an arrow says and what its scale, as printed in the title block, makes of a millimetre.
double per_mm(const std::string& caption) {  // "1 cm ≙ 2.5 m/s"
  const auto equals = caption.find("≙");
  REQUIRE(equals != std::string::npos);
  return std::stod(caption.substr(equals + std::string("≙").size())) / 10;
}

struct DiagramOf {
  std::string id, sheet;
  std::vector<std::string> vectors;
};
const std::vector<DiagramOf> diagrams{
    {of_velocity, "poles", {"v_A", "v_B", "v_C", "v_M"}},
    {of_velocity, "polar-diagram", {"v_A", "v_B", "v_BA", "v_C", "v_CA", "v_M"}},
    {of_acceleration, "poles", {"a_A", "a_B", "a_C", "a_M"}},
    {of_acceleration, "polar-diagram", {"a_A_n", "a_B", "a_C", "a_M", "a_BA", "a_BA_n", "a_BA_t", "a_CA"}}};

double value(const CheckedExercise& in, const std::string& name) { return find(in, name)->settled.enclosure.value; }

// Measurements of a sheet under their names.
std::map<std::string, Measurement> measurements(const DrawnSheet& drawn) {
  std::map<std::string, Measurement> all;
  for (const Measurement& m : drawn.measurements) all.emplace(m.quantity, m);
  return all;
}

}  // namespace

TEST_CASE("every sheet is drawn, whatever is given, on both papers and in both languages", "[slider-crank][sheets]") {
  int drawn = 0;
  for (const Try& with : tries())
    for (const auto& [id, sheet] : all_sheets())
      for (const Paper paper : {Paper::a4, Paper::a3})
        for (const Language language : {Language::english, Language::italian})
          for (const bool bare : {false, true}) {
            CAPTURE(with.why, id, sheet, paper == Paper::a4, language == Language::english, bare);
            std::string bytes;
            CHECK_NOTHROW(
                bytes = drawings::svg(
                    draw(id, sheet, with.assignments, {.paper = paper, .language = language, .bare = bare}).sheet));
            CHECK(bytes.find("<svg") != std::string::npos);
            for (const std::string word : {"-nan", "=\"nan", "=\"inf", " nan ", " inf "})
              CHECK(bytes.find(word) == std::string::npos);
            ++drawn;
          }
  CHECK(drawn == static_cast<int>(tries().size()) * 8 * 8);
}

TEST_CASE("labels find room", "[slider-crank][sheets]") {
  for (const std::vector<std::string>& assignments :
       std::vector<std::vector<std::string>>{{},
                                             {"e=0.05"},
                                             {"e=-0.1"},
                                             {"delta=30", "t1=1/54"},
                                             {"e=0.08", "delta=90", "t1=1/54"},
                                             {"e=-0.1", "delta=200"}})
    for (const auto& [id, sheet] : all_sheets())
      for (const Paper paper : {Paper::a4, Paper::a3})
        for (const Language language : {Language::english, Language::italian}) {
          const SheetRequest request{.paper = paper, .language = language};
          const auto crowded = drawings::overlaps(draw(id, sheet, assignments, request).sheet);
          CAPTURE(id, sheet, assignments, paper == Paper::a4, crowded);
          CHECK(crowded.empty());
        }
}

TEST_CASE("a ruler on the file reads the analytic value of every vector", "[slider-crank][sheets]") {
  int measured = 0;
  for (const std::vector<std::string>& assignments : {std::vector<std::string>{},
                                                      {"r=0.25", "n=400", "t1=1/60"},
                                                      {"n=-360"},
                                                      {"t1=1/108"},
                                                      {"e=0.08", "delta=20", "t1=1/54"},
                                                      {"e=-0.1", "delta=200"}})
    for (const auto& [id, sheet, vectors] : diagrams)
      for (const Paper paper : {Paper::a4, Paper::a3}) {
        const CheckedExercise numbers = checked(id, assignments);
        const DrawnSheet drawn = draw(id, sheet, assignments, {.paper = paper});
        const drawings::SvgFile svg(drawings::svg(drawn.sheet));
        REQUIRE(drawn.sheet.title_block.scales.size() == 2);
        const double unit = per_mm(drawn.sheet.title_block.scales[1]);
        for (const std::string& name : vectors) {
          CAPTURE(id, sheet, name, drawn.sheet.title_block.scales[1], paper == Paper::a4);
          const double length = arrow(svg, drawn.sheet.id + "-" + name).length;
          // Both ends are moved to the file's grid.
          CHECK(std::abs(length * unit - std::abs(value(numbers, name))) <=
                1.001 * std::numbers::sqrt2 * drawings::file_resolution * unit);
          CHECK(length > 1);
          ++measured;
        }
      }
  CHECK(measured == 6 * 22 * 2);
}

TEST_CASE("the bar on the sheet is as long as its scale says", "[slider-crank][sheets]") {
  for (const auto& [id, sheet] : all_sheets())
    for (const Paper paper : {Paper::a4, Paper::a3}) {
      const DrawnSheet drawn = draw(id, sheet, {}, {.paper = paper});
      std::size_t bars = 0;
      for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
        const auto* bar = std::get_if<drawings::ScaleBar>(&mark);
        if (!bar) continue;
        CAPTURE(id, sheet, bar->caption, bar->ticks.back());
        CHECK(bar->caption.starts_with(drawn.sheet.title_block.scales.at(bars)));  // "1 : 20 left"
        ++bars;
        const double shown = std::stod(bar->ticks.back());  // "0.2 m", "10 m/s"
        const double mm = bar->caption.starts_with("1 : ") ? 1000 * shown / std::stod(bar->caption.substr(4))
                                                           : shown / per_mm(bar->caption);
        CHECK(std::abs(bar->length - mm) <= 1e-9 * mm);
      }
      CHECK(bars >= 1);
      CHECK(bars == drawn.sheet.title_block.scales.size());
    }
}

// The sheet's scales are what its measurements are made with.
TEST_CASE("measurements are made at the printed scales", "[slider-crank][sheets]") {
  for (const auto& [id, sheet] : all_sheets()) {
    const DrawnSheet drawn = draw(id, sheet, {});
    std::vector<double> units;
    for (const std::string& caption : drawn.sheet.title_block.scales)
      units.push_back(caption.starts_with("1 : ") ? std::stod(caption.substr(4)) / 1000 : per_mm(caption));
    for (const Measurement& m : drawn.measurements) {
      CAPTURE(id, sheet, m.quantity, m.per_mm);
      CHECK(std::any_of(units.begin(), units.end(),
                        [&](double unit) { return std::abs(m.per_mm - unit) <= 1e-12 * unit; }));
    }
  }
}

TEST_CASE("ten times the lengths at a tenth of the scale is the same drawing", "[slider-crank][sheets]") {
  const std::vector<std::string> ten_times{"r=2", "l=5", "AC=3", "BC=4"};
  for (const auto& [id, sheet] : all_sheets()) {
    CAPTURE(id, sheet);
    const DrawnSheet small = draw(id, sheet, {}, {.scale = Rational(1, 50)});
    const DrawnSheet large = draw(id, sheet, ten_times, {.scale = Rational(1, 500)});
    const auto here = measurements(small), there = measurements(large);
    REQUIRE(here.size() == there.size());
    for (const auto& [name, m] : here) {
      CAPTURE(name);
      REQUIRE(there.contains(name));
      for (const auto& [p, q] : {std::pair{m.from, there.at(name).from}, std::pair{m.to, there.at(name).to}}) {
        CHECK(p.x == Approx(q.x).margin(1e-6));
        CHECK(p.y == Approx(q.y).margin(1e-6));
      }
      CHECK(there.at(name).per_mm == Approx(10 * m.per_mm));
    }
    CHECK(small.sheet.figure.marks.size() == large.sheet.figure.marks.size());
  }
}

TEST_CASE("the guide is drawn where it lies, and its offset dimensioned", "[slider-crank][sheets]") {
  for (const auto& [e, delta] : {std::pair{0.08, 20.0}, {-0.1, 200.0}, {0.05, -45.0}, {0.0, 30.0}}) {
    const DrawnSheet drawn = draw(of_velocity, "poles", {"e=" + std::to_string(e), "delta=" + std::to_string(delta)},
                                  {.scale = Rational(1, 10)});
    CAPTURE(e, delta);
    const double turn = delta * std::numbers::pi / 180, mm = 100;
    const drawings::Point along{std::cos(turn), std::sin(turn)};
    const auto left_of = [&](const drawings::Point& from, const drawings::Point& to) {
      return along.x * (to.y - from.y) - along.y * (to.x - from.x);
    };
    const drawings::Guide* guide = nullptr;
    const drawings::Slider* slider = nullptr;
    const drawings::FixedHinge* hinge = nullptr;
    const drawings::Dimension* dimension = nullptr;
    for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
      if (const auto* found = std::get_if<drawings::Guide>(&mark)) guide = found;
      if (const auto* found = std::get_if<drawings::Slider>(&mark)) slider = found;
      if (const auto* found = std::get_if<drawings::FixedHinge>(&mark)) hinge = found;
      if (const auto* found = std::get_if<drawings::Dimension>(&mark)) dimension = found;
    }
    REQUIRE((guide && slider && hinge));
    CHECK(left_of(guide->from, guide->to) == Approx(0).margin(1e-9));
    CHECK(std::remainder(slider->along - turn, 2 * std::numbers::pi) == Approx(0).margin(1e-9));
    CHECK(left_of(hinge->at, slider->at) == Approx(e * mm).margin(1e-9));
    CHECK(left_of(hinge->at, guide->from) == Approx(e * mm).margin(1e-9));
    CHECK((dimension != nullptr) == (e != 0));
    if (!dimension) continue;
    CHECK(left_of(hinge->at, dimension->from) == Approx(0).margin(1e-9));
    CHECK(left_of(dimension->from, dimension->to) == Approx(e * mm).margin(1e-9));
    CHECK(std::hypot(dimension->to.x - dimension->from.x, dimension->to.y - dimension->from.y) ==
          Approx(std::abs(e) * mm).margin(1e-9));
  }
}

TEST_CASE("the arrow of ω₂ keeps clear of crank and ground", "[slider-crank][sheets]") {
  for (int part = 0; part < 72; ++part)
    for (const int sense : {1, -1}) {
      CAPTURE(part, sense);
      const std::string t1 = "t1=" + std::to_string(part) + "/72", n = "n=" + std::to_string(sense * 60);
      arc_arrow_is_clear(draw(of_velocity, "poles", {t1, n}), sense * part * std::numbers::pi / 36);
    }
}

TEST_CASE("the pole stands on its sheet, or its rays say where it is", "[slider-crank][sheets]") {
  const auto rays_to_pole = [](const std::vector<std::string>& assignments, const SheetRequest& request = {}) {
    int rays = 0;
    for (const drawings::Label& label : draw(of_velocity, "poles", assignments, request).sheet.figure.labels)
      rays += label.text == "to $P_{0}$" ? 1 : 0;
    return rays;
  };
  CHECK(rays_to_pole({}) == 0);
  CHECK(rays_to_pole({"t1=0.03"}) == 0);  // 1.2 m above the guide: 1 : 10 instead of 1 : 5
  CHECK(rays_to_pole({"t1=0.03"}, {.scale = geometry::Rational(1, 5)}) == 2);
  CHECK(rays_to_pole({"t1=0.038"}) == 2);
  CHECK(rays_to_pole({"t1=1/24"}) == 2);  // at infinity
}

TEST_CASE("the sheets of the coupler's circles name what the border leaves out", "[slider-crank][sheets]") {
  const auto says = [](const std::string& sheet, const std::vector<std::string>& assignments,
                       const std::string& text) {
    for (const drawings::Block& block : draw(of_acceleration, sheet, assignments).sheet.column)
      if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block); paragraph && paragraph->text == text)
        return true;
    return false;
  };
  CHECK_FALSE(says("circles", {}, "Off the sheet: part of the inflection circle."));
  CHECK_FALSE(says("curvature", {}, "Off the sheet: part of the inflection circle."));  // small, beside a close-up
  // Nearly upright: all the poles but K are far off.
  CHECK(says("circles", {"t1=0.041665"},
             "Off the sheet: $A'$, $P_{0}$, $J$, $F$, $S$, part of the inflection circle, part of the stationarity "
             "circle."));
}

TEST_CASE("a mechanism small beside its inflection circle has only the letters the construction needs",
          "[slider-crank][sheets]") {
  std::map<std::string, int> count;
  for (const drawings::Label& each : draw(of_acceleration, "curvature", {}).sheet.figure.labels) ++count[each.text];
  for (const char* both : {"$C$", "$M$"}) CHECK(count[both] == 2);
  for (const char* once : {"$A_{0}$", "$A$", "$B$"}) CHECK(count[once] == 1);
}

// A crank turning clockwise from the same dead centre stands where the mirror shows it.
TEST_CASE("a crank that turns the other way has its vectors mirrored", "[slider-crank][sheets]") {
  for (const auto& [id, sheet, vectors] : diagrams) {
    if (sheet != "polar-diagram") continue;
    const DrawnSheet here = draw(id, sheet, {}), there = draw(id, sheet, {"n=-360"});
    const drawings::SvgFile svg(drawings::svg(here.sheet)), mirrored(drawings::svg(there.sheet));
    const double scale = per_mm(here.sheet.title_block.scales[1]) / per_mm(there.sheet.title_block.scales[1]);
    for (const std::string& name : vectors) {
      if (name.find('C') != std::string::npos) continue;  // C stays on the left of AB
      CAPTURE(id, name);
      const Drawn a = arrow(svg, here.sheet.id + "-" + name), b = arrow(mirrored, there.sheet.id + "-" + name);
      CHECK((b.tip.x - b.from.x) == Approx(scale * (a.tip.x - a.from.x)).margin(0.003));
      CHECK((b.tip.y - b.from.y) == Approx(-scale * (a.tip.y - a.from.y)).margin(0.003));
    }
  }
}

TEST_CASE("slider-crank polodes: numbers have the colour of their curve, each asymptote is named",
          "[slider-crank][sheets]") {
  const auto count = [](const drawings::Figure& figure, const auto& is_meant) {
    return std::count_if(figure.labels.begin(), figure.labels.end(), is_meant);
  };
  const drawings::Figure figure = draw(of_velocity, "polodes", {}).sheet.figure;
  for (const auto& [ink, least] : {std::pair{drawings::Meaning::locus, 7}, {drawings::Meaning::second_locus, 5}})
    CHECK(count(figure, [ink = ink](const drawings::Label& label) {
            return label.ink == ink && !label.text.starts_with("$");
          }) >= least);
  CHECK(count(figure, [](const drawings::Label& label) {
          return label.ink == drawings::Meaning::text &&
                 label.text.find_first_not_of("0123456789") == std::string::npos;
        }) == 3);  // of the links
  // Those of the moving polode are too flat to end below.
  const drawings::Figure flat =
      draw(of_velocity, "polodes", {"r=0.4", "l=0.45", "phi=200", "e=0.03", "delta=30", "n=-100"}).sheet.figure;
  CHECK(count(flat, [](const drawings::Label& label) { return label.text == "asymptote of $π$"; }) == 2);
}

TEST_CASE("slider-crank polodes: nothing covers the curves, each piece and each point has its letters once",
          "[slider-crank][sheets]") {
  const drawings::Figure figure = draw(of_velocity, "polodes", {}).sheet.figure;
  CHECK(std::none_of(figure.marks.begin(), figure.marks.end(), [](const drawings::Mark& mark) {
    const auto* block = std::get_if<drawings::Slider>(&mark);
    return block && !block->is_open;
  }));
  std::map<std::string, int> times;
  for (const drawings::Label& label : figure.labels) ++times[label.text];
  CHECK(times["$p$"] == 2);
  CHECK(times["$π$"] >= 2);
  CHECK(times["$M$"] == 0);
  // Of the joint B on its guide.
  for (const char* numbers : {"1, 11", "3, 9", "5, 7"}) CHECK(times[numbers] == 1);
  const auto pole = std::find_if(figure.labels.begin(), figure.labels.end(),
                                 [](const drawings::Label& label) { return label.text == "$P_{0}$"; });
  REQUIRE(pole != figure.labels.end());
  CHECK(std::count_if(figure.labels.begin(), figure.labels.end(), [&](const drawings::Label& label) {
          return label.text == "1" && std::hypot(label.at.x - pole->at.x, label.at.y - pole->at.y) < 0.5;
        }) == 1);
}

TEST_CASE("slider-crank: accelerations in one line stand in rows of their own, each joined to its point",
          "[slider-crank][sheets]") {
  const DrawnSheet drawn = draw(of_acceleration, "poles", {"phi=0"});
  std::vector<drawings::Arrow> in_line;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* arrow = std::get_if<drawings::Arrow>(&mark);
        arrow && (arrow->name == "a_A" || arrow->name == "a_B" || arrow->name == "a_M"))
      in_line.push_back(*arrow);
  REQUIRE(in_line.size() == 3);
  for (const drawings::Arrow& one : in_line)
    for (const drawings::Arrow& other : in_line)
      if (&one != &other) CHECK(std::abs(one.from.y - other.from.y) > 1.5);
}

TEST_CASE("slider-crank: vectors between points of a polygon that are one tell that they are zero",
          "[slider-crank][sheets]") {
  const std::vector<drawings::Label> labels = draw(of_velocity, "polar-diagram", {"phi=90"}).sheet.figure.labels;
  for (const char* letters : {"$v_{BA}$ = 0 m/s", "$v_{CA}$ = 0 m/s"})
    CHECK(std::any_of(labels.begin(), labels.end(),
                      [&](const drawings::Label& label) { return label.text == letters; }));
}
