// The eccentric cam: every route holds against a corpus of numerical derivatives; contact kept and lost by 1e-9 and
// 1e-30; a roller that just reaches its axis; what the source took for maximum lift; what is refused.
#include <cmath>

#include "exercises/kit/proof/verdict.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& cam() {
  static const Tried tried("cam-dynamics");
  return tried;
}

const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/cam.txt");
  return cases;
}

std::string refusal(const Assignments& assignments) {
  try {
    cam().checked(assignments);
  } catch (const BadGivens& refused) {
    return refused.what();
  }
  return {};
}

}  // namespace

TEST_CASE("its values are the corpus', to the last bit of a double, by every route", "[cam-dynamics]") {
  CHECK(corpus().size() == 19);
  holds_against(cam(), corpus());
  CHECK(cam().checked({}).quantities.size() == 94);
}

TEST_CASE("a follower that leaves the cam has no reactions, and all its kinematics", "[cam-dynamics]") {
  const CheckedExercise lost = cam().checked({"P=-30"});
  for (const char* name : {"R_23", "R_13", "R_12", "M_m", "M_m_virtual_work"}) {
    CAPTURE(name);
    CHECK(find(lost, name).settled.kind == geometry::Settled::Kind::absent);
    CHECK(find(lost, name).settled.reason.english.find("contact is lost") != std::string::npos);
  }
  CHECK(lost.passed());
  CHECK(value(lost, "a_B3_y") == value(cam().checked({}), "a_B3_y"));
}

TEST_CASE("over the turn contact is lost before it is at maximum lift, and there for e = 0", "[cam-dynamics]") {
  const CheckedExercise stated = cam().checked({});
  CHECK(value(stated, "cycle.omega_2_first_loss") == Approx(30.930).margin(0.0005));
  CHECK(value(stated, "cycle.angle_at_P_min_deg") == Approx(81.1).margin(0.05));
  CHECK(value(stated, "maximum_lift.omega_2_contact_loss") == Approx(31.08).margin(0.005));
  // At that speed P is just what is needed.
  CHECK(value(cam().checked({"n_lift=30.9302rad/s"}), "cycle.P_min") == Approx(50).margin(0.01));
  const CheckedExercise middle = cam().checked({"e=0"});
  CHECK(value(middle, "cycle.omega_2_first_loss") == Approx(value(middle, "maximum_lift.omega_2_contact_loss")));
  // The cam at rest has no place that needs more force; what it would lose contact at, it has.
  CHECK(value(cam().checked({"n_lift=0"}), "cycle.omega_2_first_loss") == Approx(30.930).margin(0.0005));
}

TEST_CASE("a pulled follower without mass never presses, at whatever speed", "[cam-dynamics]") {
  for (const char* P : {"P=-20", "P=0"}) {
    const CheckedExercise pulled = cam().checked({P, "m_3=0", "g=0"});
    const std::string why = find(pulled, "maximum_lift.omega_2_contact_loss").settled.reason.english;
    CAPTURE(P, why);
    CHECK(why.find("lost at any speed") != std::string::npos);
  }
  const CheckedExercise pressed = cam().checked({"m_3=0"});
  CHECK(find(pressed, "maximum_lift.omega_2_contact_loss").settled.reason.english.find("never lost") !=
        std::string::npos);
}

TEST_CASE("the source's least closing force is that of the drawn position", "[cam-dynamics]") {
  const CheckedExercise stated = cam().checked({});
  int rounded = 0, read = 0, explained = 0, unexplained = 0;
  for (const CheckedQuantity& quantity : stated.quantities)
    for (const PrintedVerdict& printed : quantity.printed) {
      CAPTURE(quantity.spec.name, printed.text);
      CHECK(printed.explanation_holds);
      if (printed.verdict == Verdict::rounding) ++rounded;
      if (printed.verdict == Verdict::reading) ++read;
      if (printed.verdict == Verdict::disagrees) ++(printed.explanation ? explained : unexplained);
    }
  CHECK(rounded == 10);
  CHECK(read == 7);
  CHECK(explained == 15);
  CHECK(unexplained == 0);
  const auto& P_min = find(stated, "maximum_lift.P_min").printed.front();
  REQUIRE(P_min.explanation);
  CHECK(P_min.explanation->english.find("drawn position") != std::string::npos);
}

TEST_CASE("a cam whose follower would leave it is refused, by however little", "[cam-dynamics]") {
  for (const char* offset : {"e=0.12", "e=-0.12", "e=0.5", "e=0.1200000000000000000000000000001"}) {
    CAPTURE(offset);
    CHECK(refusal({offset}).find("the follower leaves the cam") != std::string::npos);
  }
  CHECK(refusal({"e=0.13"}).find("0.16 m must be less than r + r_r = 0.15 m") != std::string::npos);
  for (const char* wrong : {"m_2=-1", "m_3=-1", "A0A=0", "r=0", "r_r=-0.01", "g=-9.81"}) {
    CAPTURE(wrong);
    CHECK_FALSE(refusal({wrong}).empty());
  }
  for (const char* possible : {"r_r=0", "n=0", "n=-50", "P=0", "P=-5", "e=0", "m_3=0"}) {
    CAPTURE(possible);
    CHECK(refusal({possible}).empty());
  }
}

TEST_CASE("every sheet is drawn, whatever is given", "[cam-dynamics][sheets]") { draws_every_sheet(cam(), corpus()); }

TEST_CASE("letters find room on all sheets", "[cam-dynamics][sheets]") {
  letters_find_room(cam(), {{}, {"phi=200"}, {"e=-0.035", "n=-77"}, {"e=0", "phi=90"}});
}

TEST_CASE("the arms of the cam's forces are told apart, and measured", "[cam-dynamics][sheets]") {
  const DrawnSheet drawn = cam().draw("torque", {});
  const auto end_of = [&](const std::string& letters) {
    for (const drawings::Dimension& each : all_of<drawings::Dimension>(drawn))
      if (each.text == letters) {
        const double x = each.to.x - each.from.x, y = each.to.y - each.from.y, long_ = std::hypot(x, y);
        CHECK(long_ > 15);
        return drawings::Point{each.to.x - each.offset * y / long_, each.to.y + each.offset * x / long_};
      }
    throw std::logic_error("no dimension " + letters);
  };
  const drawings::Point d_2 = end_of("$d_{2}$"), d_32 = end_of("$d_{32}$");
  CHECK(std::hypot(d_2.x - d_32.x, d_2.y - d_32.y) > 3);
  const CheckedExercise result = cam().checked({});
  for (const char* arm : {"d_2", "d_32"}) CHECK_FALSE(find(result, arm).on_sheets.empty());
}

TEST_CASE("the cam's angle is marked beyond the centre of its disc, which is near the axis",
          "[cam-dynamics][sheets]") {
  const DrawnSheet drawn = cam().draw("velocities", {});
  constexpr double one_to_five = 200, mass = 2.5;  // mm a metre, mm
  int marked = 0;
  for (const drawings::Rotation& each : all_of<drawings::Rotation>(drawn))
    if (each.from == 0 && each.to == Approx(21 * M_PI / 180)) {
      CHECK(each.radius > 0.03 * one_to_five + mass);
      ++marked;
    }
  CHECK(marked == 1);
}
