// The sheets of the mechanisms in equilibrium, whatever is given.
#include <map>
#include <set>

#include "tests/exercises/arrows_of.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/ideal-statics/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments> usual{{},
                                     {"wedge_collar.theta=20", "double_slider.theta=30"},
                                     {"sliding_levers.direction_P=73", "fairbairn.theta=10"},
                                     {"sliding_levers.y_C=0", "fairbairn.AB=0.5"}};

bool meet(const drawings::Point& p, const drawings::Point& q) { return std::hypot(p.x - q.x, p.y - q.y) < 1e-9; }

// How often three arrows follow each other round a triangle: forces in equilibrium.
int closed_triangles(const std::vector<drawings::Arrow>& all) {
  int closed = 0;
  for (const auto& a : all)
    for (const auto& b : all)
      for (const auto& c : all) closed += meet(a.to, b.from) && meet(b.to, c.from) && meet(c.to, a.from) ? 1 : 0;
  return closed / 3;
}
// ... and how often one of them leads from the tip of another to that of a third with the same tail: v_B = v_A +
// v_BA.
int sums(const std::vector<drawings::Arrow>& all) {
  int found = 0;
  for (const auto& a : all)
    for (const auto& relative : all)
      for (const auto& b : all)
        found += meet(a.from, b.from) && meet(a.to, relative.from) && meet(relative.to, b.to) ? 1 : 0;
  return found;
}

std::string told_by(const DrawnSheet& drawn) {
  std::string all;
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) all += line + "\n";
  return all;
}

}  // namespace

TEST_CASE("ideal statics: every sheet is drawn, whatever is given", "[ideal-statics][sheets]") {
  draws_every_sheet(statics(), read_corpus(EPURE_CORPUS "/ideal_statics.txt"));
}

TEST_CASE("ideal statics: parallel forces do not meet: the funicular polygon shares them out",
          "[ideal-statics][sheets]") {
  const auto shared = [](const char* sheet, const Assignments& assignments, bool is_shared,
                         const std::vector<std::string>& found) {
    CAPTURE(sheet, assignments);
    const DrawnSheet drawn = statics().draw(sheet, assignments);
    CHECK((told_by(drawn).find("Funicular polygon") != std::string::npos) == is_shared);
    for (const std::string& name : found) {  // a ruler reads it here as in a triangle
      CAPTURE(name);
      CHECK(std::any_of(drawn.measurements.begin(), drawn.measurements.end(),
                        [&](const Measurement& each) { return each.quantity.ends_with("." + name); }));
    }
  };
  const std::vector<std::string> of_levers{"P", "R_12", "R_13"};
  shared("levers", {}, false, of_levers);
  for (const char* direction : {"73", "73.000000001", "73.000000000000000000000000000001"})
    shared("levers", {std::string("sliding_levers.direction_P=") + direction}, true, of_levers);
  shared("levers", {"sliding_levers.direction_Q=-107"}, true, of_levers);
  shared("levers-Q-on-2", {"sliding_levers_Q_on_2.direction_P=108.5"}, true, of_levers);
  shared("fairbairn", {"fairbairn.theta=0"}, true, {"R_14"});
  shared("fairbairn", {}, false, {"R_14"});
}

TEST_CASE("ideal statics: the equation of virtual work is told", "[ideal-statics][sheets]") {
  for (const char* sheet :
       {"wedge-virtual-work", "double-slider-virtual-work", "levers-virtual-work", "levers-Q-on-2-virtual-work"}) {
    CAPTURE(sheet);
    CHECK(told_by(statics().draw(sheet, {})).find("$\\it{P}$·$v_{P}$ − $\\it{Q}$·$v_{Q}$ = 0") != std::string::npos);
  }
  CHECK(told_by(statics().draw("fairbairn-virtual-work", {})).find("$\\it{M}$·$ω_{2}$ = $\\it{F}$·$v_{D6}$") !=
        std::string::npos);
}

// A link from C to B, which the block slides on.
TEST_CASE("ideal statics: the lever reaches its block, also beyond D", "[ideal-statics][sheets]") {
  const DrawnSheet drawn = statics().draw("fairbairn", {"fairbairn.theta=15", "fairbairn.CD=0.3"});
  std::vector<double> links;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->meaning == drawings::Meaning::link)
      if (line->path.pieces.size() == 1)
        links.push_back(std::hypot(line->path.pieces[0].end.x - line->path.start.x,
                                   line->path.pieces[0].end.y - line->path.start.y));
  // C cos θ + √(AB² - (AC sin θ)²) = 0.5959 m, beside AB = 0.2 m: the mechanism's links come first, crank and lever.
  REQUIRE(links.size() > 1);
  CHECK(links[1] / links[0] == Approx(0.5959 / 0.2).epsilon(0.01));
}

TEST_CASE("ideal statics: letters find room", "[ideal-statics][sheets]") { letters_find_room(statics(), usual); }

TEST_CASE("ideal statics: the triangles of forces close, and the velocities add up, as they are drawn",
          "[ideal-statics][sheets]") {
  using Expected = std::vector<std::pair<std::string, int>>;
  const Expected bodies{{"wedge", 2},         {"double-slider", 2}, {"levers", 2},
                        {"levers-Q-on-2", 2}, {"fairbairn", 1},     {"fairbairn-short-lever", 1}};
  const Expected equations{{"wedge-virtual-work", 1},
                           {"double-slider-virtual-work", 1},
                           {"levers-virtual-work", 1},
                           {"levers-Q-on-2-virtual-work", 1},
                           {"fairbairn-virtual-work", 2}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (const auto& [sheet, expected] : bodies) {
      CAPTURE(usual[i], sheet);
      CHECK(closed_triangles(arrows_of(statics().draw(sheet, usual[i]), drawings::Meaning::force)) == expected);
    }
    for (const auto& [sheet, expected] : equations) {
      CAPTURE(usual[i], sheet);
      CHECK(sums(arrows_of(statics().draw(sheet, usual[i]), drawings::Meaning::velocity)) == expected);
    }
  }
}

TEST_CASE("ideal statics: Fairbairn's ram is cut free too", "[ideal-statics][sheets]") {
  for (const char* sheet : {"fairbairn", "fairbairn-short-lever"}) {
    const DrawnSheet drawn = statics().draw(sheet, {});
    std::set<std::string> letters;
    for (const drawings::Label& each : drawn.sheet.figure.labels) letters.insert(each.text);
    CAPTURE(sheet);
    CHECK(letters.contains("$\\vec{\\it{F}}$"));
    CHECK(letters.contains("$\\vec{\\it{R}}_{56}$"));
  }
}

TEST_CASE("ideal statics: an arm along a lever's edge stands outside of the lever", "[ideal-statics][sheets]") {
  const auto offsets = [](const char* sheet) {
    std::map<std::string, double> all;
    for (const auto& each : all_of<drawings::Dimension>(statics().draw(sheet, {})))
      all[each.text] = std::abs(each.offset);
    return all;
  };
  for (const char* sheet : {"levers-virtual-work", "levers-Q-on-2-virtual-work"})
    for (const char* arm : {"$b_{P}$", "$b_{Q}$"}) CHECK(offsets(sheet).at(arm) > 2);
  CHECK(offsets("levers-Q-on-2").at("$b_{A0}$") > 2);
  CHECK(offsets("levers-Q-on-2").at("$b_{B0}$") == 0);  // away from the edges
}

TEST_CASE("ideal statics: the force that drives the double slider is drawn", "[ideal-statics][sheets]") {
  CHECK(arrows_of(statics().draw("double-slider-virtual-work", {}), drawings::Meaning::force).size() == 2);
}

TEST_CASE("ideal statics: the wedge's sheet has its dimensions", "[ideal-statics][sheets]") {
  const DrawnSheet drawn = statics().draw("wedge", {});
  std::map<std::string, double> lengths;
  for (const drawings::Dimension& each : all_of<drawings::Dimension>(drawn))
    lengths[each.text] = std::hypot(each.to.x - each.from.x, each.to.y - each.from.y);
  REQUIRE(lengths.size() == 3);
  const double mm_per_m = lengths.at("$y_{u}$") / 0.120;
  CHECK(lengths.at("$y_{l}$") == Approx(0.035 * mm_per_m));
  CHECK(lengths.at("$w$") == Approx(0.025 * mm_per_m));
  CHECK(all_of<drawings::Dimension>(statics().draw("wedge-virtual-work", {})).empty());
}

TEST_CASE("ideal statics: a flat wedge has its angle too", "[ideal-statics][sheets]") {
  CHECK(all_of<drawings::AngleMark>(statics().draw("wedge", {"wedge_collar.theta=12"})).size() == 1);
}

// The slot's round ends have a radius of 3 mm, a block reaches 5 mm along its link.
TEST_CASE("ideal statics: the slot of Fairbairn's ram leaves the lever's block free", "[ideal-statics][sheets]") {
  const DrawnSheet drawn = statics().draw("fairbairn-virtual-work", {"fairbairn.theta=5"});
  const auto slots = all_of<drawings::Slot>(drawn);
  const auto blocks = all_of<drawings::Slider>(drawn);
  REQUIRE(slots.size() == 1);
  REQUIRE(blocks.size() == 2);
  const double low = std::min(slots[0].from.y, slots[0].to.y) - 3,
               high = std::min(blocks[0].at.y, blocks[1].at.y) + 5;
  CHECK(low > high);
}

TEST_CASE("ideal statics: the scales' captions keep off each other", "[ideal-statics][sheets]") {
  constexpr double size = 3.2, least = 3;  // mm
  for (const Language language : {Language::english, Language::italian}) {
    const auto bars = all_of<drawings::ScaleBar>(statics().draw("fairbairn-short-lever", {}, {.language = language}));
    REQUIRE(bars.size() == 5);
    for (std::size_t i = 0; i + 1 < bars.size(); ++i)
      CHECK(bars[i].at.x + drawings::measure(bars[i].caption, size).width + least < bars[i + 1].at.x);
  }
}
