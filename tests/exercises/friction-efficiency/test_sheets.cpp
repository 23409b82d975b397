// The sheets of the mechanisms with friction, whatever is given.
#include <set>

#include "drawings/paths/vectors.h"
#include "tests/exercises/arrows_of.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/friction-efficiency/cases.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("friction: every sheet is drawn, whatever is given", "[friction-efficiency][sheets]") {
  draws_every_sheet(friction(), read_corpus(EPURE_CORPUS "/friction_efficiency.txt"));
}

namespace {

bool has_label(const DrawnSheet& drawn, const std::string& text) {
  return std::any_of(drawn.sheet.figure.labels.begin(), drawn.sheet.figure.labels.end(),
                     [&](const drawings::Label& label) { return label.text.find(text) != std::string::npos; });
}
// These alone, not within others.
bool has_letters(const DrawnSheet& drawn, const std::string& text) {
  return std::any_of(drawn.sheet.figure.labels.begin(), drawn.sheet.figure.labels.end(),
                     [&](const drawings::Label& label) { return label.text == text; });
}

}  // namespace

TEST_CASE("friction: the polygons of the retrograde motion name their own points", "[friction-efficiency][sheets]") {
  const auto named = [](const char* sheet, const char* of_direct, const char* of_retrograde) {
    CAPTURE(sheet);
    const DrawnSheet drawn = friction().draw(sheet, {});
    CHECK(has_label(drawn, of_direct));
    CHECK(has_label(drawn, of_retrograde));
  };
  for (const char* sheet : {"levers", "levers-Q-on-2"}) {
    named(sheet, "∥ $A_{0}$$H_{2}$", "∥ $A_{0}$$H_{2}^{'}$");
    named(sheet, "∥ $B_{0}$$H_{3}$", "∥ $B_{0}$$H_{3}^{'}$");
  }
  // The origin of their coordinates lies on the paper here.
  const DrawnSheet drawn = friction().draw("levers-Q-on-2", {});
  for (const char* H : {"H_2_retrograde_x", "H_3_retrograde_y"})
    CHECK(std::any_of(drawn.measurements.begin(), drawn.measurements.end(),
                      [&](const Measurement& each) { return each.quantity.ends_with(H); }));
  named("fairbairn", "∥ $CH$", "∥ $CH'$");
  named("two-forces", "∥ $OK$", "∥ $OK'$");
}

TEST_CASE("friction: the sense of sliding stands at every contact, and the force against it",
          "[friction-efficiency][sheets]") {
  const auto shows = [](const char* sheet, std::size_t contacts) {
    CAPTURE(sheet);
    const DrawnSheet drawn = friction().draw(sheet, {});
    const auto velocities = arrows_of(drawn, drawings::Meaning::velocity),
               forces = arrows_of(drawn, drawings::Meaning::force);
    CHECK(velocities.size() == contacts);
    for (const auto& v : velocities) {
      int found = 0;
      for (const auto& R : forces) {
        if (std::abs(std::hypot(R.to.x - v.from.x, R.to.y - v.from.y) - 5) > 0.5) continue;
        const double along = (R.to.x - R.from.x) * (v.to.x - v.from.x) + (R.to.y - R.from.y) * (v.to.y - v.from.y);
        found += along < 0 ? 1 : 0;
      }
      CHECK(found >= 1);
    }
  };
  shows("wedge", 4);
  shows("two-forces", 5);
  shows("double-slider", 2);
  shows("levers", 2);
  shows("levers-Q-on-2", 2);
  shows("fairbairn", 3);
}

// In the direct motion the ram is driven against F, which points to the right.
TEST_CASE("friction: Fairbairn's ram is cut free with its guide's force", "[friction-efficiency][sheets]") {
  for (const char* sheet : {"fairbairn", "fairbairn-short-lever"}) {
    CAPTURE(sheet);
    const DrawnSheet drawn = friction().draw(sheet, {});
    CHECK(has_label(drawn, "$\\vec{v}_{61}$"));
    int leftwards = 0;
    for (const auto& v : arrows_of(drawn, drawings::Meaning::velocity)) leftwards += v.to.x - v.from.x < -8 ? 1 : 0;
    CHECK(leftwards == 1);
  }
}

TEST_CASE("friction: the lines of load, effort and normal stand at their angles", "[friction-efficiency][sheets]") {
  const DrawnSheet drawn = friction().draw("levers", {});
  for (const char* angle : {"$δ_{Q}$", "$δ_{P}$", "$ν$"}) CHECK(has_letters(drawn, angle));
  CHECK(!has_letters(friction().draw("levers", {"sliding_levers.direction_P=0"}), "$δ_{P}$"));
}

TEST_CASE("friction: the levers stand on their frame, with the dimensions that are given",
          "[friction-efficiency][sheets]") {
  for (const char* sheet : {"levers", "levers-Q-on-2"}) {
    CAPTURE(sheet);
    const DrawnSheet drawn = friction().draw(sheet, {});
    CHECK(all_of<drawings::FixedHinge>(drawn).size() == 2);
    std::set<std::string> dimensions;
    for (const drawings::Dimension& each : all_of<drawings::Dimension>(drawn)) dimensions.insert(each.text);
    for (const char* each : {"$x_{Q}$", "$x_{C}$", "$y_{C}$", "$b_{P}$"}) CHECK(dimensions.contains(each));
  }
}

TEST_CASE("friction: the retrograde motion has a line of the link of its own", "[friction-efficiency][sheets]") {
  CHECK(has_letters(friction().draw("double-slider", {}), "$t'$"));
  CHECK(!has_letters(friction().draw("double-slider", {"phi=0"}), "$t'$"));
}

// In the direct motion P pushes slider 4 to the right, and slider 2 lifts the load.
TEST_CASE("friction: the double slider's sliders slide as P drives them", "[friction-efficiency][sheets]") {
  const DrawnSheet drawn = friction().draw("double-slider", {});
  int upwards = 0, rightwards = 0;
  for (const auto& v : arrows_of(drawn, drawings::Meaning::velocity)) {
    if (v.to.y - v.from.y > 1) ++upwards;
    if (v.to.x - v.from.x > 1) ++rightwards;
  }
  CHECK(upwards == 1);
  CHECK(rightwards == 1);
}

TEST_CASE("friction: parallel forces do not meet: the funicular polygon shares them out",
          "[friction-efficiency][sheets]") {
  const auto is_shared = [](const char* sheet, const Assignments& assignments) {
    return has_label(friction().draw(sheet, assignments), "$O_{f}$");
  };
  CHECK(!is_shared("two-forces", {}));
  CHECK(is_shared("two-forces", {"phi=0"}));
  CHECK(!is_shared("levers", {}));
  CHECK(is_shared("levers", {"sliding_levers.direction_P=78"}));  // as the contact's force in the direct motion
  CHECK(!is_shared("fairbairn", {}));
  CHECK(is_shared("fairbairn", {"phi=0", "fairbairn.theta=0"}));
  // In the retrograde motion alone: the contact's force turned the other way is parallel to P.
  const DrawnSheet back = friction().draw("levers", {"sliding_levers.direction_P=68"});
  CHECK(has_label(back, "$O'_{f}$"));
  CHECK(has_label(back, "3″"));
  CHECK(!has_label(back, "$O_{f}$"));
  // In both motions, each with its own strings.
  const DrawnSheet both = friction().draw("fairbairn", {"fairbairn.theta=0.5"});
  for (const char* letters : {"$O_{f}$", "$O'_{f}$", "3′", "3″"}) CHECK(has_label(both, letters));
  CHECK(!has_label(friction().draw("levers", {}), "$O'_{f}$"));
}

TEST_CASE("friction: no force is negated twice", "[friction-efficiency][sheets]") {
  CHECK(!has_label(friction().draw("two-forces", {"phi=18"}), "−−"));
}

TEST_CASE("friction: every limit stands on the chart", "[friction-efficiency][sheets]") {
  const DrawnSheet drawn = friction().draw("efficiencies", {});
  std::set<std::string> measured;
  for (const Measurement& each : drawn.measurements)
    if (each.quantity.ends_with("_friction_angle_deg")) measured.insert(each.quantity);
  CHECK(measured.size() == 11);  // six that lock, five that jam
}

TEST_CASE("friction: self-locking is said", "[friction-efficiency][sheets]") {
  const auto told = [](const Assignments& assignments) {
    std::string all;
    const DrawnSheet drawn = friction().draw("wedge", assignments);
    for (const drawings::Block& block : drawn.sheet.column)
      if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) all += paragraph->text + "\n";
    return all;
  };
  CHECK_THAT(told({}), !Contains("self-locking"));
  CHECK_THAT(told({"wedge_collar.theta=8"}), Contains("must push the other way"));
  CHECK_THAT(told({"wedge_collar.theta=10"}), Contains("exactly at the limit of self-locking"));
  CHECK_THAT(told({"wedge_collar.theta=10.000000001"}), !Contains("self-locking"));
}

TEST_CASE("friction: the sign of the effort in the retrograde motion is said", "[friction-efficiency][sheets]") {
  for (const char* sheet : {"wedge", "two-forces", "double-slider", "levers", "levers-Q-on-2"})
    CHECK_THAT(told_on(friction(), sheet, {}), Contains("$\\it{P}'$ > 0: like $\\it{P}$ it holds the load back"));
  CHECK_THAT(told_on(friction(), "fairbairn", {}), Contains("$\\it{M}'$ > 0: like $\\it{M}$"));
  CHECK_THAT(told_on(friction(), "wedge", {"wedge_collar.theta=8"}),
             !Contains("> 0") && Contains("$\\it{P}'$ < 0: self-locking"));
}

TEST_CASE("friction: letters find room", "[friction-efficiency][sheets]") {
  letters_find_room(friction(), {{}, {"phi=12"}, {"wedge_collar.theta=25", "fairbairn.theta=10"}});
}

TEST_CASE("friction: the normal that the steps name stands at both levers and the whole",
          "[friction-efficiency][sheets]") {
  for (const char* sheet : {"levers", "levers-Q-on-2"}) {
    const std::vector<drawings::Label> labels = friction().draw(sheet, {}).sheet.figure.labels;
    CHECK(std::count_if(labels.begin(), labels.end(), [](const auto& each) { return each.text == "$n$"; }) == 3);
  }
}

TEST_CASE("friction: the levers' steps find where the lines of the hinges' forces lead",
          "[friction-efficiency][sheets]") {
  const std::string line = "Through $C$ the line $φ$ from $n$ meets ", Q = "$\\vec{\\it{Q}}$ at ",
                    P = "$\\vec{\\it{P}}$ at ";
  const auto told = [](const char* sheet, const Assignments& assignments) {
    return words_of(friction().draw(sheet, assignments));
  };
  CHECK_THAT(told("levers", {}), Contains(line + Q + "$H_{3}$ and " + P + "$H_{2}$."));
  CHECK_THAT(told("levers-Q-on-2", {}), Contains(line + Q + "$H_{2}$ and " + P + "$H_{3}$."));
  // Parallel forces do not meet.
  CHECK_THAT(told("levers", {"sliding_levers.direction_P=78"}), Contains(line + Q + "$H_{3}$."));
}

TEST_CASE("friction: beneath its polygons stands which motion they are of", "[friction-efficiency][sheets]") {
  for (const char* sheet : {"wedge", "two-forces", "double-slider", "levers", "levers-Q-on-2", "fairbairn"}) {
    const auto marks = friction().draw(sheet, {}).sheet.figure.marks;
    for (const std::string motion : {"direct motion", "retrograde motion"})
      CHECK(std::any_of(marks.begin(), marks.end(), [&](const drawings::Mark& mark) {
        const auto* caption = std::get_if<drawings::Writing>(&mark);
        return caption && caption->text == motion;
      }));
  }
}

TEST_CASE("friction: what the words call dashed has no line drawn through over it", "[friction-efficiency][sheets]") {
  const drawings::Figure figure = friction().draw("levers", {}).sheet.figure;
  const auto lines = [&](drawings::Meaning meaning) {  // from C
    std::vector<drawings::Point> directions;
    for (const drawings::Label& C : figure.labels)
      for (const drawings::Mark& mark : figure.marks)
        if (const auto* line = std::get_if<drawings::Line>(&mark);
            line && C.text == "$C$" && line->meaning == meaning && line->path.pieces.size() == 1 &&
            drawings::distance(line->path.start, C.at) < 0.01)
          directions.push_back(drawings::unit(line->path.start, line->path.pieces[0].end));
    return directions;
  };
  const auto dashed = lines(drawings::Meaning::alternative), solid = lines(drawings::Meaning::construction);
  CHECK(dashed.size() == 2);
  CHECK_FALSE(solid.empty());
  for (const drawings::Point& u : dashed)
    for (const drawings::Point& v : solid) CHECK(drawings::distance(u, v) > 0.01);
}
