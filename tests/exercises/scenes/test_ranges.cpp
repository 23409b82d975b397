// extremes: [theta_2] and the like: how far a drive goes that does not go round, held against values made apart
// (make_ranges.py) and against random mechanisms; where it goes round that is told, and so is what cannot be told.
#include <cmath>
#include <random>

#include "exercises/scenes/file/file_head.h"
#include "tests/exercises/scenes/said.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

// Four bars, driven by the crank: its length, the coupler's, the rocker's, the frame's.
std::string driven_bars(const std::string& crank, const std::string& coupler, const std::string& rocker,
                        const std::string& frame, const std::string& angle) {
  return "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [" + frame + ", 0]}\n  2: {A0 A: " + crank +
         "}\n  3: {A B: " + coupler + "}\n  4: {B0 B: " + rocker + "}\ndrive: {link: 2, angle: " + angle +
         ", speed: 10 rpm}\nassembly: {B: left of A B0}\nextremes: [theta_2]\n";
}

const std::map<std::string, std::string>& cases_of_ranges() {
  static const std::map<std::string, std::string> all{
      {"triple-rocker", driven_bars("200 mm", "150 mm", "180 mm", "400 mm", "30 deg")},
      {"folded-and-stretched", driven_bars("300 mm", "330 mm", "280 mm", "330 mm", "60 deg")},
      {"rocker",
       "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [400 mm, 0]}\n  2: {A0 A: 120 mm}\n  3: {A B: 350 mm}\n"
       "  4: {B0 B: 280 mm}\ndrive: {link: 4, angle: 120 deg, speed: 10 rpm}\n"
       "assembly: {A: left of B A0}\nextremes: [theta_4]\n"},
      {"crank-on-a-guide",
       "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {through: [0, -30 mm], along: [1, 0]}}\n  2: {O A: 300 mm}\n"
       "  3: {A B: 150 mm}\nslides: {B: g}\ndrive: {link: 2, angle: 10 deg, speed: 60 rpm}\n"
       "assembly: {B: ahead on g}\nextremes: [theta_2]\n"},
      {"piston",
       "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {through: [0, -30 mm], along: [1, 0]}}\n  2: {O A: 80 mm}\n"
       "  3: {A B: 260 mm}\nslides: {B: g}\ndrive: {slide: B, on: g, at: 300 mm, speed: 1 m/s}\n"
       "assembly: {A: left of O B}\nextremes: [s_B]\n"},
      {"slot",
       "epure: 1\nid: f\nlinks:\n  1: {O4: [0, 0], O2: [0, 300 mm]}\n  2: {O2 A: 260 mm}\n"
       "  4: {O4: [0, 0], s: {through: [0, 60 mm], along: [1, 0]}}\nslides: {A: s}\n"
       "drive: {link: 2, angle: 60 deg, speed: 60 rpm}\nassembly: {s: from O4 towards A}\nextremes: [theta_2]\n"},
      {"excavator",
       "epure: 1\nid: f\nlinks:\n  1: {A: [0, 0], P: [0.5 m, -0.2 m]}\n"
       "  2: {A: [0, 0], Q: [2 m, 0.3 m], B: [4 m, 0]}\n  3: {B: [0, 0], R: [-1 m, 0.25 m], T: [2 m, 0]}\n"
       "drive:\n  - {length: P Q, is: 1.8 m, speed: 0.2 m/s}\n  - {length: Q R, is: 1.4 m, speed: -0.1 m/s}\n"
       "assembly: {Q: left of A P, R: right of B Q}\nextremes: [l_PQ, l_QR]\n"},
      {"six-bar",
       "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [400 mm, 0], D: [100 mm, 600 mm]}\n  2: {A0 A: 120 mm}\n"
       "  3: {A: [0, 0], B: [350 mm, 0], P: [175 mm, 100 mm]}\n  4: {B0 B: 280 mm}\n  5: {P E: 230 mm}\n"
       "  6: {D E: 180 mm}\ndrive: {link: 2, angle: 60 deg, speed: 60 rpm}\n"
       "assembly: {B: left of A B0, E: left of P D}\nextremes: [theta_2]\n"},
      {"six-bar-of-rockers",
       "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [400 mm, 0], D: [450 mm, 350 mm]}\n  2: {A0 A: 200 mm}\n"
       "  3: {A: [0, 0], B: [150 mm, 0], P: [75 mm, 50 mm]}\n  4: {B0 B: 180 mm}\n  5: {P E: 160 mm}\n"
       "  6: {D E: 144 mm}\ndrive: {link: 2, angle: 40 deg, speed: 60 rpm}\n"
       "assembly: {B: left of A B0, E: left of P D}\nextremes: [theta_2]\n"},
      {"six-bar-folded",
       "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [169 mm, 0], D: [-31 mm, -288 mm]}\n  2: {A0 A: 355 mm}\n"
       "  3: {A: [0, 0], B: [141 mm, 0], P: [18 mm, 105 mm]}\n  4: {B0 B: 205 mm}\n  5: {P E: 405 mm}\n"
       "  6: {D E: 472 mm}\ndrive: {link: 2, angle: 41 deg, speed: 60 rpm}\n"
       "assembly: {B: left of A B0, E: left of P D}\nextremes: [theta_2]\n"},
      {"geared",
       "epure: 1\nid: f\nlinks:\n  1: {O: [-100 mm, 0], A0: [0, 0], B0: [400 mm, 0]}\n  2: {O: [0, 0]}\n"
       "  3: {A0 A: 200 mm}\n  4: {A B: 150 mm}\n  5: {B0 B: 180 mm}\n"
       "gears: [{wheels: 2 3, on: 1, teeth: [20, 40]}]\ndrive: {link: 2, angle: -20 deg, speed: 10 rpm}\n"
       "assembly: {B: left of A B0}\nextremes: [theta_2]\n"}};
  return all;
}

std::string refused_range(const std::string& text) {
  try {
    checked_text(text);
  } catch (const scenes::BadScene& bad) {
    return bad.what();
  }
  return {};
}

using geometry::Settled;

}  // namespace

TEST_CASE("the ends of what a drive can go hold against the corpus, to the last bit, by both routes", "[scenes]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/ranges.txt");
  CHECK(corpus.size() == cases_of_ranges().size());
  for (const CorpusCase& c : corpus) {
    const CheckedExercise found = checked_text(cases_of_ranges().at(c.name));
    CAPTURE(c.name, complaints(found));
    CHECK(found.passed());
    CHECK(found.undecided.empty());
    for (const auto& [name, reference] : c.references) {
      CAPTURE(name, reference);
      const CheckedQuantity& quantity = find(found, name);
      is_the_reference(quantity, reference);
      CHECK(quantity.routes.size() == 2);
    }
  }
}

TEST_CASE("a drive that goes round has no range, and that is told by both routes", "[scenes]") {
  const std::string crank = driven_bars("120 mm", "350 mm", "280 mm", "400 mm", "60 deg");
  const CheckedExercise found = checked_text(crank);
  CAPTURE(complaints(found));
  CHECK(found.passed());
  for (const char* name : {"theta_2_max", "theta_2_min"}) {
    const CheckedQuantity& end = find(found, name);
    CHECK(end.routes.size() == 2);
    for (const RouteValue& route : end.routes) {
      CHECK(route.settled.kind == Settled::Kind::absent);
      CHECK_THAT(route.settled.reason.english, Contains("link 2 goes right round"));
    }
  }
}

TEST_CASE("a point that can be slid for ever has no range", "[scenes]") {
  const CheckedExercise found = checked_text(
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {along: [1, 0]}}\n  2: {A: [0, 0], Q: [0, 80 mm], b: {along: [1, "
      "0]}}\n"
      "slides: {b: g}\ndrive: {slide: A, on: g, at: 70 mm, speed: 0.3 m/s}\nextremes: [s_A]\n");
  CAPTURE(complaints(found));
  CHECK(found.passed());
  for (const RouteValue& route : find(found, "s_A_min").routes)
    CHECK_THAT(route.settled.reason.english, Contains("farther off than all its links in one line"));
}

// By whether A and B0 are as far apart as coupler and rocker allow: of the angle of the crank a cosine alone.
TEST_CASE("of random four-bars the range is that of the cosine rule, or they go round", "[scenes]") {
  std::mt19937 random(1811);
  std::uniform_int_distribution<int> length(50, 400), degrees(0, 359);
  int rocking = 0, turning = 0;
  for (int tried = 0; tried < 4000 && rocking + turning < 60; ++tried) {
    const int a = length(random), b = length(random), c = length(random), d = length(random), at = degrees(random);
    const auto cosine_where = [&](double apart) { return (a * a + d * d - apart * apart) / (2.0 * a * d); };
    const double nearest = cosine_where(std::abs(b - c)), farthest = cosine_where(b + c),
                 now = std::cos(at * std::numbers::pi / 180);
    // Where it hardly closes, or hardly goes round, is another test's.
    constexpr double clear = 0.02;
    if (now > nearest - clear || now < farthest + clear || std::abs(nearest - 1) < clear ||
        std::abs(farthest + 1) < clear)
      continue;
    CAPTURE(a, b, c, d, at);
    const auto mm = [](int x) { return std::to_string(x) + " mm"; };
    const CheckedExercise found = checked_text(driven_bars(mm(a), mm(b), mm(c), mm(d), std::to_string(at) + " deg"));
    CAPTURE(complaints(found));
    CHECK(found.failures.empty());
    CHECK(found.undecided.empty());
    const bool stops_near = nearest<1, stops_far = farthest> - 1;
    if (!stops_near && !stops_far) {
      ++turning;
      CHECK(find(found, "theta_2_max").settled.kind == Settled::Kind::absent);
      continue;
    }
    ++rocking;
    // From near to far above the frame, or the same below; without a near end through 0, without a far one through
    // 180 degrees.
    const double low = stops_near ? std::acos(nearest) * 180 / std::numbers::pi : 0,
                 high = stops_far ? std::acos(farthest) * 180 / std::numbers::pi : 180;
    const bool is_below = at > 180;
    double least = is_below ? -high : low, greatest = is_below ? -low : high;
    if (!stops_near) least = -high, greatest = high;
    if (!stops_far) least = low, greatest = 360 - low;
    CHECK(value(found, "theta_2_min") == Approx(least).epsilon(1e-11));
    CHECK(value(found, "theta_2_max") == Approx(greatest).epsilon(1e-11));
  }
  CHECK(rocking >= 30);
  CHECK(turning >= 5);
}

TEST_CASE("through a change point, and where several groups stop a drive at once, its range is undecided",
          "[scenes]") {
  const std::string cell =
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], C: [120 mm, 0]}\n  2: {C A: 120 mm}\n  3: {O B: 400 mm}\n"
      "  4: {O D: 400 mm}\n  5: {A B: 200 mm}\n  6: {A D: 200 mm}\n"
      "drive: {link: 2, angle: 20 deg}\nassembly: {B: left of O A, D: right of O A}\nextremes: [theta_2]\n";
  for (const std::string& text : {driven_bars("100 mm", "300 mm", "100 mm", "300 mm", "60 deg"), cell}) {
    const CheckedExercise found = checked_text(text);
    CHECK(found.failures.empty());
    CHECK(find(found, "theta_2_max").settled.kind == Settled::Kind::undecided);
  }
}

TEST_CASE("what sets a drive has its range, and nothing else where the drive does not turn", "[scenes]") {
  std::string piston = cases_of_ranges().at("piston");
  piston.replace(piston.find("[s_B]"), 5, "[A_x]");
  CHECK_THAT(refused_range(piston), Contains("extremes are told of how far a drive goes (s_B): not of \"A_x\""));
  std::string arm = cases_of_ranges().at("excavator");
  arm.replace(arm.find("[l_PQ, l_QR]"), 12, "[l_QP]");
  CHECK_THAT(refused_range(arm), Contains("(l_PQ and l_QR): not of \"l_QP\"; did you mean l_PQ"));
}

TEST_CASE("the mechanism stands in outline at the ends of its range, lettered, and with what stops it", "[scenes]") {
  const auto exercise = exercise_said(cases_of_ranges().at("six-bar"));
  const DrawnSheet drawn = exercise->draw("range-theta_2", Givens(exercise->about().givens), {});
  const std::string words = words_of(drawn);
  CHECK_THAT(words, Contains("$E$: $P$ $E$ and $D$ $E$ lie in one line, stretched out: $PD$ = $PE$ + $DE$."));
  CHECK_THAT(words, Contains("at its dead centres"));
  // On a sheet to be solved nothing is in outline: fewer marks by all of it.
  const DrawnSheet blank = exercise->draw("range-theta_2", Givens(exercise->about().givens), {.blank = true});
  CHECK(blank.sheet.figure.marks.size() + 10 < drawn.sheet.figure.marks.size());

  const auto crank = exercise_said(driven_bars("120 mm", "350 mm", "280 mm", "400 mm", "60 deg"));
  CHECK_THAT(words_of(crank->draw("range-theta_2", Givens(crank->about().givens), {})),
             Contains("link 2 goes right round: the mechanism closes everywhere."));
}
