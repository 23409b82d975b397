// Trusses from files: those of docs/trusses against forces found by hand, joint by joint; what is refused, with its
// place; sheets.
#include <cmath>

#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/file/text_tree.h"
#include "exercises/scenes/file/truss_file.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

std::unique_ptr<Exercise> file(const std::string& name) {
  return scenes::truss_of_text(name, scenes::bytes_of(EPURE_TRUSSES "/" + name + ".yaml"));
}

// A triangle, with one of its parts put otherwise.
struct Triangle {
  std::string joints = "{A: [0, 0], B: [4 m, 0], C: [2 m, 1.5 m]}", bars = "[A C, C B, A B]",
              supports = "{A: hinge, B: roller}", loads = "{C: [0, -3 kN]}";
  std::string text() const {
    return "epure: 1\nid: t\ntruss:\n  joints: " + joints + "\n  bars: " + bars + "\n  supports: " + supports +
           "\n  loads: " + loads + "\n";
  }
};

// The sentence that it is refused with, without the file's name; empty when it is read.
std::string file_refusal(const Triangle& of) {
  try {
    scenes::truss_of_text("f", of.text());
  } catch (const scenes::BadScene& bad) {
    return std::string(bad.what()).substr(2);
  }
  return {};
}

CheckedExercise checked(const Exercise& exercise, const Assignments& set = {}) {
  Givens givens(exercise.about().givens);
  for (const std::string& each : set) givens.set(each);
  return check(exercise, givens, Rung::climb);
}

void holds(const CheckedExercise& found, const std::string& quantity, double expected) {
  CAPTURE(quantity, expected, complaints(found));
  CHECK(found.passed());
  CHECK(std::abs(value(found, quantity) - expected) <= 1e-12 * (1 + std::abs(expected)));
}

}  // namespace

TEST_CASE("a triangle by hand: 3 kN on a roof of 3 : 4", "[truss]") {
  const CheckedExercise found = checked(*scenes::truss_of_text("f", Triangle{}.text()));
  holds(found, "R_A_y", 1500);
  holds(found, "R_B", 1500);
  holds(found, "N_1", -2500);
  holds(found, "N_2", -2500);
  holds(found, "N_3", 2000);
}

TEST_CASE("the king post of the docs by hand, its wind turned level and the post proved to bear nothing", "[truss]") {
  const auto exercise = file("king-post");
  // 8 m, 2.5 m high, 12 kN below: each rafter's half bears 6 kN upwards.
  const CheckedExercise still = checked(*exercise, {"W=0"});
  holds(still, "R_A_y", 6000);
  holds(still, "N_1", 6000 * 4 / 2.5);
  holds(still, "N_3", -6000 * std::hypot(4, 2.5) / 2.5);
  holds(still, "N_5", 12000);
  // Level to the right at the top: the roller is pressed by W h/L.
  const CheckedExercise windy = checked(*exercise, {"P=0", "W=8 kN", "beta=0"});
  holds(windy, "R_A_x", -8000);
  holds(windy, "R_B", 2500);
  const geometry::Settled post = find(windy, "N_5").settled;
  CHECK(post.kind == geometry::Settled::Kind::certain);
  CHECK(post.enclosure.lower == 0);
  CHECK(post.enclosure.upper == 0);
}

TEST_CASE("brackets and inclined rollers of the docs", "[truss]") {
  const CheckedExercise bracket = checked(*file("wall-bracket"));
  // Moments about A: what the wall's roller presses, level.
  holds(bracket, "R_B", -(2000 * 2.4 + 500 * 1.2) / 1.5 * -1);
  holds(bracket, "R_A_y", 2500);
  const CheckedExercise inclined = checked(*file("inclined-roller"));
  CHECK(inclined.passed());
  const double across = value(inclined, "R_B");
  // 10 kN at 3 m, and (-5, -10) kN at (6, 3) m, and 2 kN at 9 m.
  CHECK(std::abs(across * std::cos(M_PI / 6) * 9 - (30000 + 60000 - 15000 + 18000)) < 1e-7);
}

TEST_CASE("what no plan can be drawn of is refused with its place and a sentence", "[truss]") {
  CHECK(file_refusal({}).empty());
  CHECK(file_refusal({.joints = "{A: [0, 0], B: [4 m, 0], C: [4 m, 0]}"}) == "4:3: joints B and C are in one place");
  CHECK(file_refusal({.bars = "[A C, C B]"}).starts_with("4:3: the truss is unstable: 2 bars and 3 components"));
  CHECK(file_refusal(
            {.joints = "{A: [0, 0], B: [4, 0], C: [4, 4], D: [0, 4]}", .bars = "[A B, B C, C D, D A, A C, B D]"})
            .starts_with("4:3: bars 5 (A C) and 6 (B D) cross or touch"));
  CHECK(file_refusal(
            {.joints = "{A: [0, 0], B: [4, 0], C: [2, 3], D: [2, 1]}", .bars = "[A B, B C, C A, A D, B D, C D]"})
            .find("statically undetermined") != std::string::npos);
  CHECK(file_refusal({.bars = "[A C, C B, A D]"}).find("there is no joint D") != std::string::npos);
  CHECK(file_refusal({.joints = "{a: [0, 0], B: [4, 0], C: [2, 3]}"}).find("is no name of a joint") !=
        std::string::npos);
  CHECK(file_refusal({.supports = "{A: hinge, B: hinge}"}).find("stands on a hinge and a roller") !=
        std::string::npos);
  CHECK(file_refusal({.supports = "{A: hinge}"}).find("stands on a hinge and a roller") != std::string::npos);
  CHECK(file_refusal({.supports = "{A: hinge, B: {roller: 90 deg}}"}) ==
        "6:13: the truss is unstable: the roller's line of action passes through the hinge");
  CHECK(file_refusal({.supports = "{A: hinge, B: {roller: 89.999999999 deg}}"}).empty());
  CHECK(file_refusal({.loads = "{C: [0, 0]}"}).find("nothing loads the truss") != std::string::npos);
  CHECK(file_refusal({.loads = "{C: [0, -3 m]}"}).find("is a length where") != std::string::npos);
  CHECK(file_refusal({.loads = "{C: {force: 3 kN}}"}).find("angle: is missing") != std::string::npos);
}

TEST_CASE("a bar through which nothing runs is told from one through which almost nothing does", "[truss]") {
  const auto force_of_the_tie = [](const std::string& load) {
    return find(checked(
                    *scenes::truss_of_text("f", Triangle{.loads = "{C: [0, -3 kN], B: [" + load + ", 0]}"}.text())),
                "N_3")
        .settled;
  };
  const geometry::Settled none = force_of_the_tie("-2 kN");
  CHECK(none.kind == geometry::Settled::Kind::certain);
  CHECK(none.enclosure.upper == 0);
  CHECK(force_of_the_tie("-1999.999999999 N").enclosure.lower > 0);
  CHECK(force_of_the_tie("-2000.000000000000000000000000000001 N").enclosure.upper < 0);
}

TEST_CASE("the sheets of the docs' trusses are drawn, and every bar that bears is read off the plan",
          "[truss][sheets]") {
  for (const char* name : {"king-post", "wall-bracket", "inclined-roller"}) {
    const auto exercise = file(name);
    CAPTURE(name);
    CHECK(exercise->about().sheets.size() == 3);
    const CheckedExercise found = checked(*exercise);
    CAPTURE(complaints(found));
    CHECK(found.passed());
  }
}
