// What a strict reader found on the sheets of the shipped mechanisms, by its causes.
#include <algorithm>
#include <cmath>

#include "drawings/paths/vectors.h"
#include "exercises/scenes/file/file_head.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/scenes/said.h"

using namespace epure;
using namespace epure::tests;

namespace {

DrawnSheet shipped(const std::string& file, const std::string& sheet) {
  const auto exercise = exercise_said(scenes::bytes_of(EPURE_SCENES "/" + file + ".yaml"));
  return exercise->draw(sheet, Givens(exercise->about().givens), {});
}

bool has_label(const DrawnSheet& sheet, const std::string& text) {
  const auto& labels = sheet.sheet.figure.labels;
  return std::any_of(labels.begin(), labels.end(), [&](const auto& label) { return label.text == text; });
}

double to_segment(drawings::Point p, drawings::Point from, drawings::Point to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double t = std::max(0.0, std::min(1.0, ((p.x - from.x) * dx + (p.y - from.y) * dy) / (dx * dx + dy * dy)));
  return std::hypot(p.x - from.x - t * dx, p.y - from.y - t * dy);
}

}  // namespace

TEST_CASE("a slot ends before the hinges of its link", "[scenes]") {
  const DrawnSheet sheet = shipped("quick-return", "velocities");
  const auto slots = all_of<drawings::Slot>(sheet);
  REQUIRE(slots.size() == 1);
  for (const drawings::FixedHinge& hinge : all_of<drawings::FixedHinge>(sheet))
    CHECK(to_segment(hinge.at, slots[0].from, slots[0].to) > 3);
}

TEST_CASE("the arc arrow of a rate is clear of slots and links", "[scenes]") {
  const std::string sheet_of[][2] = {{"quick-return", "velocities"},
                                     {"quick-return", "velocity-polygon-A"},
                                     {"cutting-stroke", "velocities"},
                                     {"peaucellier", "velocity-polygon-B"}};
  for (const auto& [file, name] : sheet_of) {
    CAPTURE(file, name);
    const DrawnSheet sheet = shipped(file, name);
    const auto arrows = all_of<drawings::Rotation>(sheet);
    REQUIRE(!arrows.empty());
    for (const drawings::Rotation& arrow : arrows)
      for (int i = 0; i <= 10; ++i) {
        const double at = arrow.from + (arrow.to - arrow.from) * i / 10;
        const drawings::Point p{arrow.centre.x + arrow.radius * std::cos(at),
                                arrow.centre.y + arrow.radius * std::sin(at)};
        for (const drawings::Slot& slot : all_of<drawings::Slot>(sheet))
          CHECK(to_segment(p, slot.from, slot.to) > slot.width / 2);
        for (const drawings::Line& line : all_of<drawings::Line>(sheet))
          if (line.meaning == drawings::Meaning::link && line.path.pieces.size() == 1 && line.path.pieces[0].straight)
            CHECK(to_segment(p, line.path.start, line.path.pieces[0].end) > 0.5);
      }
  }
}

TEST_CASE("a guide's wall stands where no link passes through it, and a point of the frame alone is no hinge",
          "[scenes]") {
  const DrawnSheet sheet = shipped("trammel", "velocities");
  const auto guides = all_of<drawings::Guide>(sheet);
  REQUIRE(guides.size() == 2);
  for (const drawings::Guide& guide : guides) {
    if (std::abs(guide.from.x - guide.to.x) < 1)
      CHECK(guide.from.y > guide.to.y);  // its wall on the left: the ladder is on the right
    else
      CHECK(guide.from.x < guide.to.x);
  }
  CHECK(all_of<drawings::FixedHinge>(sheet).empty());
  CHECK(has_label(sheet, "1"));
}

TEST_CASE("a rod that slides in a link of one hinge is a piston's, in a cylinder", "[scenes]") {
  const DrawnSheet sheet = shipped("oscillating-cylinder", "velocities");
  CHECK(all_of<drawings::Slot>(sheet).empty());
  for (const std::string letters : {"$s$", "3", "4", "$K$"}) CHECK(has_label(sheet, letters));
}

TEST_CASE("the step of a centre off the sheet stands where its lines leave", "[scenes]") {
  const DrawnSheet sheet = shipped("cutting-stroke", "instant-centres");
  for (const drawings::StepNumber& step : sheet.sheet.figure.steps)
    for (const drawings::Slider& block : all_of<drawings::Slider>(sheet))
      CHECK(drawings::distance(step.at, block.at) > 10);
}

TEST_CASE("centres that are one to the eye are drawn again, larger", "[scenes]") {
  CHECK(all_of<drawings::ScaleBar>(shipped("stephenson", "instant-centres-2")).size() == 2);
}

TEST_CASE("where the drive cannot go all round its positions divide what it can", "[scenes]") {
  for (const std::string file : {"chebyshev", "roberts", "peaucellier"}) {
    CAPTURE(file);
    const DrawnSheet sheet = shipped(file, "path");
    for (int i = 0; i < 12; ++i) CHECK(has_label(sheet, std::to_string(i)));
  }
}

TEST_CASE("what a shipped mechanism is drawn from is among its givens", "[scenes]") {
  for (const std::string file : {"watt", "excavator", "jansen", "geared-five-bar", "stephenson"}) {
    CAPTURE(file);
    const auto exercise = exercise_said(scenes::bytes_of(EPURE_SCENES "/" + file + ".yaml"));
    CHECK(exercise->about().givens.size() > 6);
  }
}

TEST_CASE("an offset is told with the line and the point that it is of", "[scenes]") {
  CHECK(tells(shipped("chebyshev", "velocities"), "Distance of $P$ from $g$, to the left: $e$"));
}

TEST_CASE("a sheet tells what the letters of its givens mean, and from where its known vectors are", "[scenes]") {
  CHECK(tells(shipped("quick-return", "velocities"), "$h$: height of the guide $g$ above $O_{4}$;"));
  CHECK(tells(shipped("excavator", "acceleration-polygon-R"), "What these letters mean: sheet 1."));
  CHECK(tells(shipped("quick-return", "velocities"), "by the polygon, sheet 3."));
  CHECK(tells(shipped("peaucellier", "instant-centres-2"), "$P_{38}$: sheet 11."));
}

TEST_CASE("a centre at infinity that was found before leads to others: its lines are drawn", "[scenes]") {
  const DrawnSheet sheet = shipped("peaucellier", "instant-centres-2");
  const auto& labels = sheet.sheet.figure.labels;
  CHECK(std::count_if(labels.begin(), labels.end(), [](const drawings::Label& label) {
          return label.text.find("to $P_{67}$") != std::string::npos;
        }) == 3);  // the two on which it lies, and that on which P17 does
}
