// extremes: the greatest and least values over a turn of the drive, and where, held against values made apart
// (make_extremes.py); what has none is refused with the reason, and what cannot be told apart is undecided.
#include <cmath>

#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/scene_exercise.h"
#include "exercises/scenes/shipped.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/scenes/said.h"

using namespace epure;
using namespace epure::tests;

namespace {

// Four bars: crank, coupler, rocker, frame.
std::string bars(const std::string& crank, const std::string& coupler, const std::string& rocker,
                 const std::string& frame, const std::string& more) {
  return "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [" + frame +
         ", 0], D: [100 mm, 450 mm]}\n  2: {A0 A: " + crank + "}\n  3: {A: [0, 0], B: [" + coupler +
         ", 0], P: [175 mm, 100 mm]}\n  4: {B0 B: " + rocker + "}\n" + more +
         "drive: {link: 2, angle: 60 deg, speed: 60 rpm}\n";
}
std::string extremes_of_four_bar(const std::string& extremes) {
  return bars("120 mm", "350 mm", "280 mm", "400 mm", "") + "assembly: {B: left of A B0}\nextremes: " + extremes +
         "\n";
}
std::string extremes_of_six_bar(const std::string& extremes) {
  return bars("120 mm", "350 mm", "280 mm", "400 mm", "  5: {P E: 300 mm}\n  6: {D E: 250 mm}\n") +
         "assembly: {B: left of A B0, E: left of P D}\nextremes: " + extremes + "\n";
}
std::string extremes_of_slider_crank(const std::string& offset, const std::string& extremes,
                                     const std::string& crank = "80 mm") {
  return "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {through: [0, " + offset +
         "], along: [1, 0]}}\n  2: {O A: " + crank +
         "}\n  3: {A B: 260 mm}\nslides: {B: g}\ndrive: {link: 2, angle: 50 deg, speed: 60 rpm}\n"
         "assembly: {B: ahead on g}\nextremes: " +
         extremes + "\n";
}

const std::map<std::string, std::string>& cases_of_extremes() {
  static const std::map<std::string, std::string> all{
      {"four-bar", extremes_of_four_bar("[theta_4, P_x, P_y, omega_3, v_P_y]")},
      {"six-bar", extremes_of_six_bar("[theta_6, E_y, v_E_x, omega_6]")},
      {"slider-crank", extremes_of_slider_crank("-30 mm", "[B_x, v_B_x, theta_3, omega_3]")},
      {"quick-return",
       "epure: 1\nid: f\nlinks:\n  1: {O4: [0, 0], O2: [0, 300 mm], g: {through: [0, 650 mm], along: [1, 0]}}\n"
       "  2: {O2 A: 175 mm}\n  4: {O4: [0, 0], B: [700 mm, 0], s: {along: [1, 0]}}\n  5: {B C: 800 mm}\n"
       "slides: {A: s, C: g}\ndrive: {link: 2, angle: 50 deg, speed: 60 rpm, acceleration: 3 rad/s^2}\n"
       "assembly: {s: from O4 towards A, C: ahead on g}\nextremes: [C_x, v_C_x, theta_4, omega_4]\n"},
      {"planet",
       "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O C: 50 mm}\n  3: {C: [0, 0], P: [24 mm, 18 mm]}\n"
       "gears: [{wheels: 1 3, on: 2, teeth: [30, 20]}]\ndrive: {link: 2, angle: 50 deg, speed: 60 rpm}\n"
       "extremes: [P_x, P_y, v_P_x]\n"}};
  return all;
}

std::string refused_extremes(const std::string& text) {
  try {
    checked_text(text);
  } catch (const scenes::BadScene& bad) {
    return bad.what();
  } catch (const BadGivens& bad) {
    return bad.what();
  }
  return {};
}

}  // namespace

TEST_CASE("extremes and where they are hold against the corpus, to the last bit, by both routes", "[scenes]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/extremes.txt");
  CHECK(corpus.size() == cases_of_extremes().size());
  for (const CorpusCase& c : corpus) {
    const CheckedExercise found = checked_text(cases_of_extremes().at(c.name));
    CAPTURE(c.name, complaints(found));
    CHECK(found.passed());
    CHECK(found.undecided.empty());
    int count = 0;
    for (const CheckedQuantity& quantity : found.quantities) {
      const std::string reference = c.reference(quantity.spec.name);
      if (reference.empty()) continue;
      CAPTURE(quantity.spec.name, reference);
      CHECK(quantity.settled.kind == geometry::Settled::Kind::certain);
      is_the_reference(quantity, reference);
      CHECK(quantity.routes.size() == 2);
      ++count;
    }
    CHECK(count == static_cast<int>(c.references.size()));
  }
}

// Where the crank is in line with the guide, and square to it: exactly there.
TEST_CASE("an extreme at a plain part of a turn is there exactly", "[scenes]") {
  const CheckedExercise found = checked_text(extremes_of_slider_crank("0", "[B_x, theta_3, omega_3]"));
  CAPTURE(complaints(found));
  CHECK(found.passed());
  const std::map<std::string, double> places{{"B_x_max_at", 0},      {"B_x_min_at", 180},   {"theta_3_max_at", 270},
                                             {"theta_3_min_at", 90}, {"omega_3_min_at", 0}, {"omega_3_max_at", 180}};
  for (const auto& [name, degrees] : places) {
    CAPTURE(name);
    CHECK(find(found, name).settled.kind == geometry::Settled::Kind::certain);
    CHECK(value(found, name) == degrees);
  }
  CHECK(value(found, "B_x_max") == 0.34);
  CHECK(value(found, "B_x_min") == 0.18);
}

// By the cosine rule where crank and coupler are in line: r = 50, b = 140, c = 110, and the frame from 122 to 190.
TEST_CASE("the limits of a rocker are where crank and coupler are in line, whatever the lengths", "[scenes]") {
  const double r = 0.05, b = 0.14, c = 0.11;
  // The whole of it turned by 180° as well.
  for (const int turned : {0, 180})
    for (int d = 122; d < 190; d += 8) {
      CAPTURE(d, turned);
      const std::string frame = (turned == 0 ? "" : "-") + std::to_string(d) + " mm";
      const CheckedExercise found = checked_text(bars("50 mm", "140 mm", "110 mm", frame, "") +
                                                 "assembly: {B: left of A B0}\nextremes: [theta_4]\n");
      CAPTURE(complaints(found));
      CHECK(found.passed());
      const auto rocker = [&](double reach) {
        const double f = d * 1e-3;
        return 180 - turned - std::acos((f * f + c * c - reach * reach) / (2 * f * c)) * 180 / std::numbers::pi;
      };
      CHECK(value(found, "theta_4_min") == Approx(rocker(b + r)).epsilon(1e-12));
      CHECK(value(found, "theta_4_max") == Approx(rocker(b - r)).epsilon(1e-12));
    }
}

TEST_CASE("what is greatest in more than one position has a value, and no one place", "[scenes]") {
  // At 180° of link 6, which goes through it there and back.
  const CheckedExercise found = checked_text(extremes_of_six_bar("[E_x]"));
  CHECK(found.failures.empty());
  CHECK(value(found, "E_x_min") == -0.15);
  CHECK(find(found, "E_x_min").settled.kind == geometry::Settled::Kind::certain);
  for (const RouteValue& route : find(found, "E_x_min_at").routes) {
    CHECK(route.settled.kind == geometry::Settled::Kind::absent);
    CHECK_THAT(route.settled.reason.english, Contains("in more than one position: ") && Contains("°, "));
  }
  CHECK(find(found, "E_x_max_at").settled.kind == geometry::Settled::Kind::certain);
  CHECK(found.undecided.empty());
}

TEST_CASE("a lever that swings on passes its far place twice in a turn", "[scenes]") {
  // O4 B and B C in line: 900 mm from O4, 750 mm from its guide, so √(0.9² - 0.75²) m along it.
  const std::string text(scenes::shipped_scene("quick-return")->text);
  const CheckedExercise found = checked_text(text, {"O4B=100mm", "h=750mm"});
  CHECK(found.passed());
  CHECK(found.undecided.empty());
  CHECK(value(found, "C_x_max") == Approx(std::sqrt(0.2475)).epsilon(1e-15));
  CHECK(find(found, "C_x_max_at").settled.kind == geometry::Settled::Kind::absent);
}

void have_no_value(const std::string& text, const std::string& quantity, const std::string& reason) {
  const CheckedExercise found = checked_text(text);
  CAPTURE(complaints(found));
  CHECK(found.passed());
  CHECK(found.undecided.empty());
  for (const char* ending : {"_max", "_max_at", "_min", "_min_at"}) {
    const CheckedQuantity& one = find(found, quantity + ending);
    CHECK(one.routes.size() == 2);
    for (const RouteValue& route : one.routes) {
      CHECK(route.settled.kind == geometry::Settled::Kind::absent);
      CHECK_THAT(route.settled.reason.english, Contains(reason));
    }
  }
}

TEST_CASE("extremes that do not exist have no value, and the reason is told", "[scenes]") {
  have_no_value(extremes_of_slider_crank("0", "[B_x]", "270 mm"), "B_x", "link 2 does not turn right round");
  // Over some degrees it does not close.
  have_no_value(
      "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [-134.8 mm, 172.6 mm]}\n  2: {A0 A: 110 mm}\n"
      "  3: {A B: 116 mm}\n  4: {B0 B: 226 mm}\ndrive: {link: 2, angle: 185.4 deg}\n"
      "assembly: {B: left of A B0}\nextremes: [theta_4]\n",
      "theta_4", "link 2 does not turn right round");
  have_no_value(
      bars("300 mm", "350 mm", "280 mm", "100 mm", "") + "assembly: {B: left of A B0}\nextremes: [theta_4]\n",
      "theta_4", "it grows or falls without end");
}

TEST_CASE("what extremes cannot be asked of is refused", "[scenes]") {
  CHECK_THAT(refused_extremes(extremes_of_four_bar("[omega_2]")),
             Contains("of what link 2 moves, and of how far a drive goes (theta_2): not of \"omega_2\""));
  CHECK_THAT(refused_extremes(extremes_of_four_bar("[a_P_x]")),
             Contains("extremes are told of coordinates (C_x), directions of links"));
  CHECK_THAT(refused_extremes(extremes_of_four_bar("[B0_x]")), Contains("(theta_2): not of \"B0_x\""));
  CHECK_THAT(refused_extremes(extremes_of_four_bar("[P_x, P_x]")), Contains("P_x stands here twice"));
  CHECK_THAT(refused_extremes(extremes_of_four_bar("P_x")), Contains("extremes: [theta_4, v_C_x]"));
  CHECK_THAT(refused_extremes("epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {along: [1, 0]}}\n  2: {O A: 80 mm}\n"
                              "  3: {A B: 260 mm}\nslides: {B: g}\ndrive: {slide: B, on: g, at: 300 mm}\n"
                              "assembly: {A: left of O B}\nextremes: [A_x]\n"),
             Contains("of a mechanism that no single turned link drives"));
}

// A link that gears turn evenly, a point on a guide along x.
TEST_CASE("what hardly changes has no extremes that could be told, and that is said soon", "[scenes]") {
  std::string planet = cases_of_extremes().at("planet");
  planet.replace(planet.find("[P_x, P_y, v_P_x]"), 17, "[omega_3]");
  for (const std::string& text : {extremes_of_slider_crank("0", "[B_y]"), planet}) {
    const CheckedExercise found = checked_text(text);
    CHECK(found.failures.empty());
    CHECK(found.undecided.size() == 4);
  }
}

// Through its change points the drive does not determine the motion.
TEST_CASE("of a parallelogram over a turn extremes are undecided, and that soon", "[scenes]") {
  const CheckedExercise found = checked_text(bars("100 mm", "300 mm", "100 mm", "300 mm", "") +
                                             "assembly: {B: left of A B0}\nextremes: [omega_3]\n");
  CHECK(found.failures.empty());
  CHECK(found.undecided.size() == 4);
}

TEST_CASE("what extremes are asked of has its chart, with their places on it", "[scenes]") {
  const auto exercise = exercise_said(extremes_of_four_bar("[theta_4, omega_4]") + "charts: [[omega_3, omega_4]]\n");
  std::vector<std::string> charts;
  for (const SheetSpec& sheet : exercise->about().sheets)
    if (sheet.name.starts_with("chart")) charts.push_back(sheet.name);
  REQUIRE(charts == std::vector<std::string>{"chart-omega_3-omega_4", "chart-theta_4"});
  for (const std::string& chart : charts) {
    const DrawnSheet drawn = exercise->draw(chart, Givens(exercise->about().givens), {});
    const std::string of = chart == charts[0] ? "omega_4" : "theta_4";
    for (const std::string& name : {of + "_max", of + "_max_at", of + "_min", of + "_min_at"}) {
      CAPTURE(chart, name);
      CHECK(std::any_of(drawn.measurements.begin(), drawn.measurements.end(),
                        [&](const Measurement& each) { return each.quantity == name; }));
    }
  }
}
