// N.10's sheets: drawn whatever is given, letters apart, and the files measured back.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/exercises/arc_arrow.h"
#include "tests/exercises/four-bar-analytic/cases.h"
#include "tests/support/read_svg.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments>& tries() {
  static const std::vector<Assignments> all{
      {},
      {"branch=right"},
      {"n=-400", "alpha_2=300"},
      {"theta_2=200"},
      {"theta_2=0"},
      {"theta_2=180", "branch=right"},
      {"theta_2=240"},                                              // dead centre: the pole is B
      {"A0B0=0.2", "A0A=0.6"},                                      // drag link
      {"A0B0=0.5", "A0A=0.4", "AB=0.2", "B0B=0.45", "theta_2=60"},  // double rocker
      {"A0B0=0.8", "A0A=0.5", "AB=0.4", "B0B=0.6", "theta_2=40"},   // triple rocker
      {"A0B0=0.4", "theta_2=50"},                                   // change point
      {"A0B0=0.4", "A0A=0.2", "AB=0.4", "B0B=0.2", "theta_2=50"},   // parallelogram: the pole at infinity
      {"A0B0=0.4", "A0A=0.2", "AB=0.4", "B0B=0.2", "theta_2=50", "branch=right"},
      {"AP_along=0.7", "AP_across=-0.3"},
      {"AP_along=0", "AP_across=0.2"},
      {"A0B0=800", "A0A=200", "AB=500", "B0B=700"},
      {"A0B0=8e-6", "A0A=2e-6", "AB=5e-6", "B0B=7e-6", "n=1/100"}};
  return all;
}

int written(const DrawnSheet& drawn, const std::string& text) {
  int times = 0;
  for (const drawings::Label& label : drawn.sheet.figure.labels) times += label.text == text ? 1 : 0;
  return times;
}

// Alone, or in one label with others: "5, 11".
int numbered(const DrawnSheet& drawn, int number) {
  int times = 0;
  for (const drawings::Label& label : drawn.sheet.figure.labels)
    times += (", " + label.text + ",").find(", " + std::to_string(number) + ",") != std::string::npos ? 1 : 0;
  return times;
}

bool tells(const DrawnSheet& drawn, const std::string& words) {
  return std::any_of(drawn.sheet.column.begin(), drawn.sheet.column.end(), [&](const drawings::Block& block) {
    const auto* paragraph = std::get_if<drawings::Paragraph>(&block);
    return paragraph && paragraph->text.find(words) != std::string::npos;
  });
}

// The paragraph of the column that names what the border leaves out.
std::string off_sheet(const DrawnSheet& drawn) {
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block))
      if (paragraph->text.starts_with("Off the sheet") || paragraph->text.starts_with("Fuori del foglio"))
        return paragraph->text;
  return "";
}

}  // namespace

TEST_CASE("four-bar-analytic: every sheet is drawn, whatever is given", "[four-bar-analytic][sheets]") {
  draws_every_sheet(id, tries());
}

TEST_CASE("four-bar-analytic: letters find room", "[four-bar-analytic][sheets]") {
  letters_find_room(id, {{}, {"branch=right"}, {"A0B0=0.2", "A0A=0.6"}, {"A0A=0.6"}, {"theta_2=120"}});
}

TEST_CASE("four-bar-analytic: a ruler on the file reads the vectors", "[four-bar-analytic][sheets]") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> diagrams{
      {"velocities", {"v_A", "v_B", "v_BA", "v_G3"}},
      {"accelerations", {"a_A", "a_BA_n", "a_BA_t", "a_B_n", "a_B_t", "a_G3"}}};
  for (const Assignments& assignments : {Assignments{}, {"branch=right", "n=-250"}, {"A0B0=0.2", "A0A=0.6"}}) {
    const CheckedExercise numbers = checked(id, assignments);
    for (const auto& [sheet, vectors] : diagrams) {
      const DrawnSheet drawn = draw(id, sheet, assignments);
      const drawings::SvgFile svg(drawings::svg(drawn.sheet));
      const std::string caption = drawn.sheet.title_block.scales.back();  // "1 cm ≙ 2 m/s"
      const double unit = std::stod(caption.substr(caption.find("≙") + std::string("≙").size())) / 10;
      for (const std::string& name : vectors) {
        CAPTURE(sheet, name, assignments);
        const drawings::Point from = svg.points(drawn.sheet.id + "-" + name).front(),
                              to = svg.points(drawn.sheet.id + "-" + name + "_head").front();
        CHECK(std::abs(std::hypot(to.x - from.x, to.y - from.y) * unit - std::abs(value(numbers, name))) <=
              1.001 * std::numbers::sqrt2 * drawings::file_resolution * unit);
      }
    }
  }
}

// Where the linkage does not close, and where it folds flat, the chart shows nothing: its runs end there.
TEST_CASE("four-bar-analytic: discontinuities of omega_4 are not joined", "[four-bar-analytic][sheets]") {
  const auto runs = [](const Assignments& assignments) {
    const DrawnSheet drawn = draw(id, "omega-4", assignments);
    int count = 0;
    for (const drawings::Mark& mark : drawn.sheet.figure.marks)
      if (const auto* line = std::get_if<drawings::Line>(&mark))
        if (line->name.starts_with("omega_4")) ++count;
    return count;
  };
  CHECK(runs({}) == 2);                                                          // one a branch
  CHECK(runs({"A0B0=0.4", "theta_2=50"}) == 2);                                  // flat at 0 = 360 only
  CHECK(runs({"A0B0=0.4", "A0A=0.2", "AB=0.4", "B0B=0.2", "theta_2=50"}) == 4);  // flat at 180 too
  // Flat at 180°, where doubles, left alone, find some value.
  CHECK(runs({"A0A=0.11", "AB=0.41", "B0B=0.53", "A0B0=0.83", "theta_2=50"}) == 4);
  CHECK(runs({"A0B0=0.5", "A0A=0.4", "AB=0.2", "B0B=0.45", "theta_2=60"}) == 4);  // two arcs of the crank
}

// The parallelogram's other form: ω₄ falls to −168 rad/s, four times ω₂, where it folds flat.
TEST_CASE("four-bar-analytic: what does not grow beyond all bounds is on the chart", "[four-bar-analytic][sheets]") {
  const DrawnSheet drawn = draw(id, "omega-4", {"A0B0=0.5", "A0A=0.3", "AB=0.5", "B0B=0.3", "theta_2=60"});
  std::size_t told = 0;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* writing = std::get_if<drawings::Writing>(&mark)) told += writing->text == "−150";
  CHECK(told == 1);
}

// One is 8e10 rad/s high and 1e-10 of a turn wide: A passes B0 at 1e-10 m.
TEST_CASE("four-bar-analytic: the curves of omega_4 pass through their extremes, however steep",
          "[four-bar-analytic][sheets]") {
  const auto curve = [](const DrawnSheet& drawn, const std::string& name) {
    std::vector<drawings::Point> points;
    for (const drawings::Mark& mark : drawn.sheet.figure.marks)
      if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->name == name) {
        points.push_back(line->path.start);
        for (const drawings::Piece& piece : line->path.pieces) points.push_back(piece.end);
      }
    return points;
  };
  const auto misses = [](const std::vector<drawings::Point>& chain, drawings::Point p) {
    double least = 1e9;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const double x = chain[i].x - chain[i - 1].x, y = chain[i].y - chain[i - 1].y, square = x * x + y * y;
      const double along = (p.x - chain[i - 1].x) * x + (p.y - chain[i - 1].y) * y;
      const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
      least = std::min(least, std::hypot(chain[i - 1].x + t * x - p.x, chain[i - 1].y + t * y - p.y));
    }
    return least;
  };
  for (const std::string frame : {"0.190199", "0.1901999999", "0.190199999999999999"}) {
    CAPTURE(frame);
    const DrawnSheet drawn =
        draw(id, "omega-4", {"A0A=0.1902", "AB=0.1902", "B0B=0.1902", "A0B0=" + frame, "theta_2=100"});
    const drawings::Box chart = *(drawn.sheet.figure.windows.rbegin() + 1);  // the last is the sheet's
    const auto one = curve(drawn, "omega_4"), other = curve(drawn, "omega_4_other_branch");
    CHECK(misses(one, {chart.low.x, chart.high.y}) < 0.1);  // up and out, beside 0, 180 and 360 degrees
    CHECK(misses(other, {chart.high.x, chart.high.y}) < 0.1);
    CHECK(misses(one, {chart.high.x, chart.high.y}) < 0.1);
    CHECK(misses(other, {chart.low.x, chart.high.y}) < 0.1);
    CHECK(chart.high.y - chart.low.y < 1000);
    int told = 0;
    for (const drawings::Block& block : drawn.sheet.column)
      if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block))
        told += paragraph->text.starts_with("Off the chart: ") ? 1 : 0;
    CHECK(told == 1);
    for (const Measurement& measured : drawn.measurements)
      CHECK(std::max(std::abs(measured.to.x), std::abs(measured.to.y)) < 300);  // on the paper
  }
  // The dots and rings stand on the curves, also where ω₄ turns about within a tenth of a degree.
  for (const Assignments& assignments :
       {Assignments{}, {"A0A=0.11", "AB=0.41", "B0B=0.53", "A0B0=0.829999999999", "theta_2=50"}}) {
    const DrawnSheet drawn = draw(id, "omega-4", assignments);
    const auto one = curve(drawn, "omega_4"), other = curve(drawn, "omega_4_other_branch");
    for (const drawings::Mark& mark : drawn.sheet.figure.marks)
      if (const auto* point = std::get_if<drawings::DataPoint>(&mark)) {
        CAPTURE(assignments, point->at.x, point->at.y);
        CHECK(misses(point->shape == drawings::PointShape::ring ? other : one, point->at) < 0.02);
      }
  }
}

// A quarter of the curve's points against B found from two circles in doubles, P from A and B.
TEST_CASE("four-bar-analytic: the coupler curve passes where the linkage carries P", "[four-bar-analytic][sheets]") {
  const double a = 0.2, b = 0.5, c = 0.7, f = 0.8, along = 0.7, across = -0.3;
  const DrawnSheet drawn = draw(id, "coupler-curve", {"AP_along=0.7", "AP_across=-0.3"});
  const drawings::Path* path = nullptr;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark))
      if (!path && line->name == "path_of_P") path = &line->path;  // on the whole, where A₀ is
  REQUIRE(path);
  CHECK(path->closed);
  const auto P_now = std::find_if(drawn.measurements.begin(), drawn.measurements.end(),
                                  [](const Measurement& m) { return m.quantity == "P_x"; });
  REQUIRE(P_now != drawn.measurements.end());
  const drawings::Point origin = P_now->from;
  // Every knot of the curve: |P - A| and the closure hold for some crank, found by scanning.
  double worst = 0;
  for (const drawings::Piece& piece : path->pieces) {
    const double x = (piece.end.x - origin.x) * P_now->per_mm, y = (piece.end.y - origin.y) * P_now->per_mm;
    double best = 1;
    for (int i = 0; i < 7200; ++i) {
      const double t = i * std::numbers::pi / 3600, Ax = a * std::cos(t), Ay = a * std::sin(t);
      const double dx = f - Ax, dy = -Ay, d = std::hypot(dx, dy), m = (d * d + b * b - c * c) / (2 * d);
      const double h = std::sqrt(b * b - m * m), Bx = Ax + (m * dx - h * dy) / d, By = Ay + (m * dy + h * dx) / d;
      const double ux = (Bx - Ax) / b, uy = (By - Ay) / b;
      best = std::min(best, std::hypot(Ax + along * ux - across * uy - x, Ay + along * uy + across * ux - y));
    }
    worst = std::max(worst, best);
  }
  // Neighbouring cranks of the scan are π/3600 apart, and P moves by less than 2 m a radian.
  CHECK(worst < 2 * std::numbers::pi / 3600);
}

TEST_CASE("four-bar-analytic: positions of A, B and P bear their numbers", "[four-bar-analytic][sheets]") {
  const DrawnSheet drawn = draw(id, "coupler-curve", {});
  for (int k = 0; k < 12; ++k) CHECK(numbered(drawn, k) == 2);  // of A, and of P in the close-up
  CHECK(written(drawn, "6', 10'") == 1);                        // the rocker comes by twice
  // The triple rocker misses some divisions of the crank's circle.
  const DrawnSheet some = draw(id, "coupler-curve", {"A0A=0.6"});
  CHECK(numbered(some, 1) >= 2);
  CHECK(numbered(some, 6) == 0);
}

TEST_CASE("four-bar-analytic: the path stands in a close-up, larger than the whole linkage that leads to it",
          "[four-bar-analytic][sheets]") {
  CHECK(draw(id, "coupler-curve", {}).sheet.title_block.scales == std::vector<std::string>{"1 : 10", "1 : 5"});
}

TEST_CASE("four-bar-analytic: the way of B reaches each of its positions", "[four-bar-analytic][sheets]") {
  const DrawnSheet drawn = draw(id, "coupler-curve", {"A0A=0.6"});
  // Of long-dash-dot arcs the crank's circle is closed, the rocker's is not.
  std::vector<drawings::Path> arcs;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark);
        line && line->meaning == drawings::Meaning::axis && !line->path.closed && line->path.pieces.size() > 1)
      arcs.push_back(line->path);
  REQUIRE(arcs.size() == 1);
  // It ends in B's position that is farthest round from B now.
  const drawings::Point low = std::min(arcs.front().start, arcs.front().pieces.back().end,
                                       [](drawings::Point p, drawings::Point q) { return p.y < q.y; });
  int dots_on_the_end = 0;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* dot = std::get_if<drawings::Dot>(&mark))
      dots_on_the_end += std::hypot(dot->at.x - low.x, dot->at.y - low.y) < 1e-6 ? 1 : 0;
  CHECK(dots_on_the_end == 1);
}

TEST_CASE("four-bar-analytic: what the border leaves out is named", "[four-bar-analytic][sheets]") {
  CHECK(off_sheet(draw(id, "curvature", {})).empty());
  CHECK(off_sheet(draw(id, "curvature", {"A0A=0.6"})).empty());  // the osculating circle is whole on it
  CHECK(off_sheet(draw(id, "curvature", {"theta_2=120"})) ==
        "Off the sheet: $A'$, $B'$, $F$, $J$, $G'_{3}$, part of the inflection circle.");
  CHECK(off_sheet(draw(id, "coupler-curve", {})).empty());
  const DrawnSheet far = draw(id, "coupler-curve", {"A0A=0.6"}, {.language = Language::italian});
  CHECK(off_sheet(far) == "Fuori del foglio: $Ω_{P}$.");
  CHECK(written(far, "verso $Ω_{P}$") == 1);
}

TEST_CASE("four-bar-analytic: the arrow of ω₂ keeps clear of crank and ground", "[four-bar-analytic][sheets]") {
  for (int degrees = 0; degrees < 360; degrees += 5)
    for (const char* n : {"n=400", "n=-400"}) {
      CAPTURE(degrees, n);
      arc_arrow_is_clear(draw(id, "configurations", {"theta_2=" + std::to_string(degrees), n}),
                         degrees * std::numbers::pi / 180);
    }
}

TEST_CASE("four-bar-analytic: the coefficients of the closure equation are no points",
          "[four-bar-analytic][sheets]") {
  bool found = false;
  for (const drawings::Block& block : draw(id, "configurations", {}, {.language = Language::italian}).sheet.column) {
    const auto* paragraph = std::get_if<drawings::Paragraph>(&block);
    if (!paragraph || paragraph->text.find(" sen $θ_{4}$") == std::string::npos) continue;
    found = true;
    for (const char* point : {"$A$", "$B$", "$C$"}) CHECK(paragraph->text.find(point) == std::string::npos);
  }
  CHECK(found);
}

TEST_CASE("four-bar-analytic: the arc of a given angle goes counter-clockwise, as it is given",
          "[four-bar-analytic][sheets]") {
  const DrawnSheet drawn = draw(id, "configurations", {"theta_2=235"});
  constexpr double given = 235 * std::numbers::pi / 180;
  const auto is_given = [](const drawings::Mark& mark) {
    const auto* arc = std::get_if<drawings::Rotation>(&mark);
    return arc && arc->from == 0 && std::abs(arc->to - given) < 1e-9;
  };
  const auto& marks = drawn.sheet.figure.marks;
  CHECK(std::count_if(marks.begin(), marks.end(), is_given) == 1);
}

TEST_CASE("four-bar-analytic: the parts of a_A that are told are drawn", "[four-bar-analytic][sheets]") {
  const DrawnSheet steady = draw(id, "accelerations", {}), faster = draw(id, "accelerations", {"alpha_2=800"});
  for (const char* part : {"$\\vec{a}^{n}_{A}$", "$\\vec{a}^{t}_{A}$"}) {
    CHECK(written(steady, part) == 0);
    CHECK(written(faster, part) == 1);
  }
}

TEST_CASE("four-bar-analytic: positions of B are primed, those of P numbered on the larger picture",
          "[four-bar-analytic][sheets]") {
  const DrawnSheet drawn = draw(id, "coupler-curve", {});
  for (const char* number : {"0'", "3'", "8'"}) CHECK(written(drawn, number) == 1);
  CHECK(written(drawn, "8") == 2);  // of A, and of P
  const Assignments change_point{"A0B0=0.4", "A0A=0.6", "AB=0.7", "B0B=0.5", "AP_across=0.4", "phi=80"};
  CHECK(tells(draw(id, "coupler-curve", change_point), "the path has a corner"));
  CHECK_FALSE(tells(drawn, "the path has a corner"));
  CHECK(tells(drawn, "at $P_{∥}$ from $A$"));
}
