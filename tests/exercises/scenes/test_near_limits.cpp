// Mechanisms from files beside a dead centre or change point, missed by ever less: each is decided, on the side that
// was said, and where it does not close the sentence tells by how much.
#include <cmath>

#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/scene_exercise.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

CheckedExercise checked_bytes(const std::string& path, const std::string& text, const std::vector<std::string>& set) {
  const auto exercise = scenes::scene_exercise(std::make_shared<const scenes::Scene>(path, text));
  Givens givens(exercise->about().givens);
  for (const std::string& each : set) givens.set(each);
  return check(*exercise, givens, Rung::climb);
}

CheckedExercise checked(const std::string& file, const std::vector<std::string>& set) {
  const std::string path = EPURE_SCENES "/" + file + ".yaml";
  return checked_bytes(path, scenes::bytes_of(path), set);
}

// "0.00...01", so many places, and what is left of 1 without it: "0.99...9".
std::string little(int places) { return "0." + std::string(static_cast<std::size_t>(places - 1), '0') + "1"; }
std::string one_less(int places) { return "0." + std::string(static_cast<std::size_t>(places), '9'); }

void holds(const CheckedExercise& result, const std::string& quantity, double expected) {
  CAPTURE(quantity, complaints(result));
  CHECK(result.passed());
  CHECK(value(result, quantity) == Approx(expected).epsilon(1e-12));
}

std::string refusal(const std::string& file, const std::vector<std::string>& set) {
  try {
    checked(file, set);
  } catch (const BadGivens& bad) {
    return bad.what();
  }
  return {};
}

}  // namespace

// In doubles both places of B are one from 1e-16 on, and the equations of all joints are none too independent long
// before.
TEST_CASE("a scene is decided however near to a dead centre or change point it is", "[scenes]") {
  for (const int places : {3, 7, 10, 12, 13, 14, 15, 16, 17, 18, 20, 25, 32, 40, 70}) {
    const double m = std::pow(10.0, -places);
    CAPTURE(places);
    const CheckedExercise trammel = checked("trammel", {"a=" + one_less(places) + "m"});
    holds(trammel, "B_y", std::sqrt(m * (2 - m)));
    holds(trammel, "v_B_y", -0.5 * (1 - m) / std::sqrt(m * (2 - m)));
    // e = 50 mm less m: A is that much less than l from the guide, at a crank angle of 30°.
    const CheckedExercise slider =
        checked("slider-crank", {"r=0.5m", "l=0.3m", "phi=30deg", "e=0.04" + one_less(places).substr(2) + "m"});
    const double less = m / 100;
    holds(slider, "B_x", 0.5 * std::sqrt(3) / 2 + std::sqrt(less * (0.6 - less)));
    // A parallelogram but for AB, in line.
    const CheckedExercise four_bar = checked("four-bar", {"A0A=0.12m", "AB=0.4" + little(places).substr(2) + "m",
                                                          "B0B=0.12m", "A0B0=0.4m", "theta=180deg"});
    const double more = m / 10;
    holds(four_bar, "B_y",
          2 / 0.52 * std::sqrt((0.52 + more / 2) * (0.12 - more / 2) * (0.4 + more / 2) * (more / 2)));
  }
}

TEST_CASE("a scene that hardly does not close tells by how much, to its own digits", "[scenes]") {
  for (const int places : {13, 17, 43, 90}) {
    const std::string m = "1e-" + std::to_string(places), more = little(places).substr(2);
    CAPTURE(places);
    CHECK(
        refusal("four-bar", {"A0A=0.12m", "AB=0.4" + more.substr(1) + "m", "B0B=0.12m", "A0B0=0.4m", "theta=0deg"}) ==
        "the mechanism does not close: B: A B (0.4 m) and B0 B (0.12 m) do not meet, for A B0 is 0.28 m, " + m +
            " m too near");
    CHECK(refusal("four-bar",
                  {"A0A=0.12m", "AB=0.4m", "B0B=0.12m", "A0B0=0.4" + more.substr(1) + "m", "theta=180deg"}) ==
          "the mechanism does not close: B: A B (0.4 m) and B0 B (0.12 m) do not meet, for A B0 is 0.52 m, " + m +
              " m too far");
    CHECK(refusal("trammel", {"a=1." + more + "m"}) ==
          "the mechanism does not close: B: A B (1 m) does not reach y, which is 1 m away from A: " + m +
              " m are missing");
  }
}

// As long as the other rod but for what no double tells.
TEST_CASE("bars that fold in line are no equal ones, and A is not on B0", "[scenes]") {
  const std::string more = little(30).substr(3);
  CHECK(refusal("parallelogram", {"phi=0deg", "r=0.5m"}).find("lie in one place") != std::string::npos);
  const std::string folded =
      refusal("four-bar", {"A0A=0.5m", "AB=0.5m", "B0B=0.5" + more + "m", "A0B0=0.5" + more + "m", "theta=0deg"});
  CAPTURE(folded);
  CHECK(folded.find("lie in one line, folded") != std::string::npos);
}

// At such angles doubles find the rods now too short and now long enough: an attack's, where one in ten was refused.
TEST_CASE("two rods stretched out all but for less than doubles tell close", "[scenes]") {
  const std::string file =
      "epure: 1\nid: rods\ntitle: Rods\ngivens: {theta: 45 deg, c: 0.3 m}\n"
      "links: {1: {O: [0, 0], Q: [1 m, 0]}, 2: {O A: 0.3 m}, 3: {A B: 0.8 m}, 4: {Q B: 0.7 m}, 5: {A C: 0.5 m}, "
      "6: {B C: c}}\ndrive: {link: 2, angle: theta, speed: 1 rad/s}\nassembly: {B: left of A Q, C: left of A B}\n";
  for (const std::string theta : {"20", "33", "45", "58", "77", "101"}) {
    CAPTURE(theta);
    // B C = 0.3 m + m: C stands off A B by sqrt(2 m 0.5 0.3/0.8), and so do links 5 and 6 turn from it.
    const CheckedExercise result =
        checked_bytes("rods.yaml", file, {"theta=" + theta + "deg", "c=0.3000000000000001m"});
    CAPTURE(complaints(result));
    CHECK(result.passed());
    const double turned = (value(result, "theta_5") - value(result, "theta_3")) * M_PI / 180;
    CHECK(turned == Approx(std::sqrt(2e-16 * 0.3 / (0.5 * 0.8))).epsilon(1e-6));
    try {
      checked_bytes("rods.yaml", file, {"theta=" + theta + "deg"});
      CHECK(false);
    } catch (const BadGivens& bad) {
      CHECK_THAT(std::string(bad.what()),
                 Catch::Matchers::StartsWith("C: A C and B C lie in one line, stretched out"));
    }
  }
}
