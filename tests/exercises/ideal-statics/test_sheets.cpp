// The sheets of the mechanisms in equilibrium, whatever is given.
#include "tests/exercises/ideal-statics/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments> usual{{},
                                     {"wedge_collar.theta=20", "double_slider.theta=30"},
                                     {"sliding_levers.direction_P=73", "fairbairn.theta=10"},
                                     {"sliding_levers.y_C=0", "fairbairn.AB=0.5"}};

std::vector<drawings::Arrow> arrows_of(const DrawnSheet& drawn, drawings::Meaning meaning) {
  std::vector<drawings::Arrow> all;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* arrow = std::get_if<drawings::Arrow>(&mark); arrow && arrow->meaning == meaning)
      all.push_back(*arrow);
  return all;
}
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

}  // namespace

TEST_CASE("ideal statics: every sheet is drawn, whatever is given", "[ideal-statics][sheets]") {
  draws_every_sheet(statics(), read_corpus(EPURE_CORPUS "/ideal_statics.txt"));
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
