// Links that slide in each other, as they are drawn and told; charts of what does not change.
#include "drawings/paths/vectors.h"
#include "exercises/kit/proof/place.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/scene_exercise.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/scenes/said.h"

using namespace epure;
using namespace epure::tests;

namespace {

DrawnSheet drawn_of(const Exercise& of, const std::string& sheet) {
  return of.draw(sheet, Givens(of.about().givens), {});
}

// A crank whose pin drives a yoke: the slot across the guide, told after it.
const std::string yoke =
    "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {along: [1, 0]}}\n  2: {O A: 100 mm}\n  3: {C: [250 mm, 0], b: "
    "{along: [1, 0]}, s: {along: [0, 1]}}\nslides: {b: g, A: s}\ndrive: {link: 2, angle: 35 deg, speed: 90 rpm}\n";

// A crank whose block slides in a lever; `side` says which way.
std::string shaper(const std::string& side) {
  return "epure: 1\nid: f\nlinks:\n  1: {O3: [0, 0], O5: [0, -350 mm]}\n  2: {O3 A: 100 mm}\n  3: {A: [0, 0], b: "
         "{along: [1, 0]}}\n  4: {O5: [0, 0], B: [600 mm, 0], s: {along: [1, 0]}}\nslides: {b: s}\ndrive: {link: 2, "
         "angle: 80 deg, speed: 50 rpm}\nassembly: {" +
         side + "}\n";
}

}  // namespace

TEST_CASE("a yoke's slot stands across its guide, and the crank's pin in it", "[scenes]") {
  const DrawnSheet sheet = drawn_of(*exercise_said(yoke), "velocities");
  const std::vector<drawings::Slot> slots = all_of<drawings::Slot>(sheet);
  REQUIRE(slots.size() == 1);
  const auto& [from, to, width] = slots.front();
  CHECK(from.x == Approx(to.x));
  CHECK(std::abs(from.y - to.y) > 10);
  const auto hinges = all_of<drawings::Hinge>(sheet);
  CHECK(std::any_of(hinges.begin(), hinges.end(), [&](const drawings::Hinge& pin) {
    return std::abs(pin.at.x - from.x) < 1e-6 && pin.at.y > std::min(from.y, to.y) &&
           pin.at.y < std::max(from.y, to.y);
  }));
}

TEST_CASE("the middle of Oldham's coupling is a block in both slots, which have their letters", "[scenes]") {
  const DrawnSheet sheet = drawn_of(*exercise_said(scenes::bytes_of(EPURE_SCENES "/oldham.yaml")), "velocities");
  CHECK(all_of<drawings::Slot>(sheet).size() == 2);
  const auto blocks = all_of<drawings::Slider>(sheet);
  REQUIRE(blocks.size() == 2);
  CHECK(drawings::distance(blocks[0].at, blocks[1].at) < 1e-6);
  for (const std::string letters : {"$p$", "$t$", "$ω_{2}$"})
    CHECK(std::any_of(sheet.sheet.figure.labels.begin(), sheet.sheet.figure.labels.end(),
                      [&](const drawings::Label& label) { return label.text == letters; }));
}

// There the link's point under C is the hinge, and at rest.
TEST_CASE("a block that stands in a hinge of its link is accelerated by nothing there, by both routes", "[scenes]") {
  const std::string text = scenes::bytes_of(EPURE_SCENES "/oldham.yaml");
  for (const auto& [place, link] : {std::pair{"0", "4"}, {"180deg", "4"}, {"90deg", "2"}, {"-90deg", "2"}}) {
    const CheckedExercise result = checked_text(text, {std::string("phi=") + place});
    CAPTURE(place, complaints(result));
    CHECK(result.passed());
    CHECK(result.undecided.empty());
    for (const char* part : {"_n", "_t"}) CHECK(value(result, std::string("a_C_on_") + link + part) == 0);
  }
  for (const char* near : {"1e-9deg", "90.000000000000000000000000000001deg"}) {
    const CheckedExercise result = checked_text(text, {std::string("phi=") + near});
    CAPTURE(near, complaints(result));
    CHECK(result.passed());
    CHECK(result.undecided.empty());
  }
}

TEST_CASE("a block in a lever is drawn in its slot, and the polygon is that of its pin", "[scenes]") {
  const auto exercise = exercise_said(shaper("b: from A away from O5"));
  CHECK(sheets_of(*exercise) == std::vector<std::string>{"velocities", "accelerations", "velocity-polygon",
                                                         "acceleration-polygon", "instant-centres"});
  const DrawnSheet sheet = drawn_of(*exercise, "velocities");
  REQUIRE(all_of<drawings::Slot>(sheet).size() == 1);
  REQUIRE(all_of<drawings::Slider>(sheet).size() == 1);
  const drawings::Point at = all_of<drawings::Slider>(sheet).front().at;
  const auto [from, to, width] = all_of<drawings::Slot>(sheet).front();
  CHECK((at.x - from.x) * (to.y - from.y) == Approx((at.y - from.y) * (to.x - from.x)).margin(1e-6));
  CHECK(tells(drawn_of(*exercise, "velocity-polygon"), "a*"));
  // ω4 = r ω2 (r + d sin θ)/(r² + d² + 2 r d sin θ), of the lever that points from O5 to A; by the other line too.
  constexpr double r = 0.1, d = 0.35, pi = 3.14159265358979323846;
  const double sine = std::sin(80 * pi / 180), omega_2 = 50 * 2 * pi / 60;
  const double omega_4 = r * omega_2 * (r + d * sine) / (r * r + d * d + 2 * r * d * sine);
  for (const std::string side : {"b: from A away from O5", "s: from O5 towards A"}) {
    CAPTURE(side);
    const CheckedExercise result = check(*exercise_said(shaper(side)), Givens(exercise->about().givens), Rung::climb);
    CHECK(result.passed());
    CHECK(value(result, "omega_4") == Approx(omega_4));
    CHECK(value(result, "omega_3") == Approx(omega_4));
  }
}

TEST_CASE("what does not change has a chart around its value", "[scenes]") {
  // A lever whose hinge is as far from the crank's as the pin is turns half as fast, but for rounding.
  const auto exercise = exercise_said(
      "epure: 1\nid: f\nlinks:\n  1: {O2: [0, 0], O4: [-100 mm, 0]}\n  2: {O2 A: 100 mm}\n  4: {O4: [0, 0], s: "
      "{along: [1, 0]}}\nslides: {A: s}\ndrive: {link: 2, angle: 40 deg, speed: 50 rpm}\nassembly: {s: from O4 "
      "towards A}\ncharts: [omega_4]\n");
  const DrawnSheet sheet = drawn_of(*exercise, "chart-omega_4");
  CHECK_FALSE(line(sheet, "omega_4").path.pieces.empty());
}

TEST_CASE("what lines led in lines keep from turning has no acceleration centre, in a mechanism of several groups",
          "[scenes]") {
  passes(
      "epure: 1\nid: f\nlinks:\n  1: {E: [0, 0], A: [-25 mm, 14 mm], e: {through: [-238 mm, -292 mm], along: 107 "
      "deg}}\n  2: {E: [0, 0], U: [179 mm, 0], D: [141 mm, -254 mm]}\n  3: {U: [0, 0], F: [387 mm, 0]}\n  4: {A: [0, "
      "0], F: [224 mm, 0]}\n  5: {F: [0, 0], Q: [471 mm, 0]}\n  6: {D: [0, 0], Q: [368 mm, 0]}\n  7: {f: {through: "
      "[0, 0], along: 0 deg}, g: {through: [268 mm, -482 mm], along: 90 deg}}\nslides: {f: e, U: g}\ndrive: {link: "
      "2, angle: -324 deg, speed: 10 rad/s}\nassembly: {F: left of U A, Q: left of F D}\n");
}

// What links do by themselves is proved without a wheel beside them that no exact number holds.
TEST_CASE("links of one place do not move against each other, whatever else the mechanism has", "[scenes]") {
  passes(
      "epure: 1\nid: f\nlinks:\n  1: {X: [0, 0]}\n  2: {X: [0, 0], A: [238.1 mm, 0], Y: [410 mm, -89 mm]}\n  3: {Y "
      "W: 35 mm}\n  4: {Y: [0, 0], e: {through: [0, 0], along: 0 deg}}\n  5: {A: [0, 0], f: {through: [0, 0], along: "
      "0 deg}}\n  6: {Y: [0, 0], E: [235 mm, 457 mm], g: {through: [0, 0], along: 0 deg}}\nslides: {f: e, A: "
      "g}\ngears: [{wheels: 1 3, on: 2, teeth: [40, 47], inside: yes}]\ndrive: {link: 2, angle: -150 deg, speed: 10 "
      "rad/s, acceleration: 2 rad/s^2}\nassembly: {e: from Y towards A, g: from Y towards A}\n");
}

TEST_CASE("a differential whose carrier and sun are driven alike turns as one", "[scenes]") {
  passes(
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O: [0, 0], C: [80 mm, 0], D: [160 mm, 0]}\n  3: {C: [0, 0], "
      "Q: [30 mm, 0]}\n  5: {O: [0, 0]}\n  4: {D: [0, 0], P: [0, 30 mm]}\ngears: [{wheels: 5 3, on: 2, teeth: [40, "
      "20]}, {wheels: 3 4, on: 2, teeth: [20, 37]}]\ndrive: [{link: 2, angle: 180 deg, speed: 30 rpm}, {link: 5, "
      "angle: 20 deg, speed: 30 rpm}]\n");
}

TEST_CASE("polodes do not hang on whether the drive moves", "[scenes]") {
  const auto exercise = exercise_said(
      "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [400 mm, 0]}\n  2: {A0 A: 120 mm}\n  3: {A B: 350 mm}\n  4: "
      "{B0 B: 280 mm}\ndrive: {link: 2, angle: 60 deg}\nassembly: {B: left of A B0}\npolodes: [3]\n");
  CHECK_FALSE(line(drawn_of(*exercise, "polodes"), "fixed_polode").path.pieces.empty());
}

TEST_CASE("wheels at rest touch in their centre by every route", "[scenes]") {
  const auto exercise = exercise_said(
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], Q: [90 mm, 0]}\n  2: {O A: 30 mm}\n  3: {Q B: 30 mm}\ngears: "
      "[{wheels: 2 3, on: 1, teeth: [30, 60]}]\ndrive: {link: 2, angle: 20 deg}\n");
  const CheckedExercise result = check(*exercise, Givens(exercise->about().givens), Rung::climb);
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(value(result, "P23_x") == 0.03);
  CHECK(find(result, "P23_x").routes.size() == 3);
}

TEST_CASE("a point is not called what something else is", "[scenes]") {
  const auto why = [](const std::string& link, const std::string& more) {
    try {
      exercise_said(
          "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {along: [1, 0]}}\n  2: {O A: 120 mm}\n  3: " + link +
          "\nslides: {x: g}\ndrive: {link: 2, angle: 30 deg, speed: 60 rpm}\nassembly: {x: ahead on g}\n" + more);
    } catch (const scenes::BadScene& bad) {
      return std::string(bad.what());
    }
    return std::string();
  };
  const std::string loads = "loads: [{at: x, on: 3, force: [100 N, 0]}]\n";
  CHECK(why("{A: [0, 0], x: [350 mm, 0], S: [0, 0.1]}", loads).empty());
  CHECK(why("{A: [0, 0], x: [350 mm, 0], N: [0, 0.1]}", "").empty());
  CHECK(why("{A: [0, 0], x: [350 mm, 0], N: [0, 0.1]}", loads).find("N_x would be two things, \"") !=
        std::string::npos);
  CHECK(
      why("{A: [0, 0], x: [350 mm, 0], BA: [0, 0.1]}", "").find("BA means B seen from A: name the point otherwise") !=
      std::string::npos);
}

TEST_CASE("a pin that leads two slotted links has two stars in the second, and each link its own polygons",
          "[scenes]") {
  const auto exercise = exercise_said(
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], O3: [-100 mm, 0], O4: [0, -200 mm]}\n  2: {O A: 50 mm}\n  3: {O3: "
      "[0, 0], s: {along: [1, 0]}}\n  4: {O4: [0, 0], u: {along: [1, 0]}}\nslides: {A: [s, u]}\ndrive: {link: 2, "
      "angle: 40 deg, speed: 10 rad/s}\nassembly: {s: from O3 towards A, u: from O4 towards A}\n");
  CHECK(sheets_of(*exercise) == std::vector<std::string>{"velocities", "accelerations", "velocity-polygon-A-3",
                                                         "velocity-polygon-A-4", "acceleration-polygon-A-3",
                                                         "acceleration-polygon-A-4", "instant-centres"});
  const Solution solution = exercise->solution(Givens(exercise->about().givens));
  CHECK(solution.described("v_A_on_3").symbol == "$v_{A*}$");
  CHECK(solution.described("v_A_on_4").symbol == "$v_{A**}$");
  CHECK(drawn_of(*exercise, "velocity-polygon-A-4").sheet.title == "f: Velocity polygon of A, link 4");
  const CheckedExercise result = check(*exercise, Givens(exercise->about().givens), Rung::climb);
  CHECK(result.passed());
  for (const std::string name : {"v_A_on_3", "v_A_rel_3", "v_A_on_4", "v_A_rel_4"})  // measured on its own sheet
    CHECK_FALSE(find(result, name).on_sheets.empty());
}

// By the rods alone it would be zero to 300 places, and no number told to be so.
TEST_CASE("what slides on an upright guide has no velocity and no acceleration along x", "[scenes]") {
  const CheckedExercise result = checked_text(
      "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], g3: {through: [-16 mm, 153 mm], along: 99 deg}, g4: {through: [-15 "
      "mm, "
      "93 mm], along: 90 deg}}\n  2: {A0 A: 196 mm}\n  3: {A: [0, 0], S3: [425 mm, 0], C3: [51 mm, 5 mm]}\n  4: {C3: "
      "[0, 0], S4: [622 mm, 0]}\nslides: {S3: g3, S4: g4}\ndrive: {link: 2, angle: 138 deg, speed: 15.8 "
      "rad/s}\nassembly: {S3: behind on g3, S4: ahead on g4}\n");
  CAPTURE(complaints(result));
  CHECK(result.passed());
  for (const char* name : {"v_S4_x", "a_S4_x"}) {
    CAPTURE(name);
    CHECK(find(result, name).settled.kind == geometry::Settled::Kind::certain);
    CHECK(value(result, name) == 0);
  }
}
