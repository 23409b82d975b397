// Forces of mechanisms from files: under loads the scenes of the docs hold against values made apart; near a dead
// centre they are found however large they grow, and at it they are refused; what is wrong with loads: is told with
// its place. Their sheets are told as they are drawn, and what is drawn is what was found.
#include <cmath>
#include <map>

#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/scene_exercise.h"
#include "geometry/numbers/given.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/scenes/said.h"

using namespace epure;
using namespace epure::tests;

namespace {

std::string with_loads(const std::string& file, const std::string& loads) {
  return scenes::bytes_of(EPURE_SCENES "/" + file + ".yaml") + "loads: " + loads + "\n";
}

// Scenes of which docs/scenes has none: a driven block in its guide; two blocks hinged on each other, in two guides.
std::string bytes_of_case(const std::string& name) {
  if (name == "driven-piston")
    return "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {along: [1, 0]}}\n  2: {O A: 120 mm}\n  3: {A B: 400 mm}\n"
           "  4: {B: [0, 0], D: [100 mm, 20 mm], b: {through: [30 mm, 0], along: [1, 0]}}\nslides: {b: g}\n"
           "drive: {slide: B, on: g, at: 450 mm}\nassembly: {A: left of O B}\n";
  if (name == "two-blocks")
    return "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {through: [0, 200 mm], along: [1, 0]}}\n"
           "  2: {O: [0, 0], s: {along: [1, 0]}}\n  3: {X: [0, 0], p: {along: [1, 0]}}\n"
           "  4: {X: [0, 0], D: [50 mm, 10 mm], q: {along: [1, 0]}}\nslides: {p: s, q: g}\n"
           "drive: {link: 2, angle: 50 deg}\n";
  if (name == "wheel-pair")
    return "epure: 1\nid: f\nlinks:\n  1: {A: [0, 0], B: [90 mm, 120 mm]}\n  2: {A: [0, 0]}\n  3: {B: [0, 0]}\n"
           "gears: [{wheels: 2 3, on: 1, teeth: [20, 40]}]\ndrive: {link: 2, angle: 30 deg}\n";
  if (name == "ring-wheel")
    return "epure: 1\nid: f\nlinks:\n  1: {A: [0, 0], B: [-40 mm, 0]}\n  2: {A: [0, 0]}\n"
           "  3: {B: [0, 0], E: [50 mm, 10 mm]}\ngears: [{wheels: 2 3, on: 1, teeth: [20 mm, 60 mm], inside: yes, "
           "pressure_angle: 25 deg}]\ndrive: {link: 2, angle: 30 deg}\n";
  if (name == "geared-press")
    return "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], C: [150 mm, 0], g: {along: [1, 0]}}\n  2: {O: [0, 0]}\n"
           "  3: {C A: 50 mm}\n  4: {A B: 200 mm}\n  5: {B: [0, 0], b: {along: [1, 0]}}\nslides: {b: g}\n"
           "gears: [{wheels: 2 3, on: 1, teeth: [20, 40]}]\ndrive: {link: 2, angle: 80 deg, speed: 1 rad/s}\n"
           "assembly: {B: ahead on g}\n";
  std::string text = scenes::bytes_of(EPURE_SCENES "/" + name + ".yaml");
  // A file that chooses its sheets has none of forces.
  if (const auto chosen = text.find("\nsheets:"); chosen != std::string::npos)
    text.erase(chosen + 1, text.find('\n', chosen + 1) - chosen);
  return text;
}

std::string refused_loads(const std::string& text) {
  try {
    scenes::Scene("f", text);
  } catch (const scenes::BadScene& bad) {
    return std::string(bad.what()).substr(2);
  }
  return {};
}

// In the order of the letters; as make_scene_forces.py has them.
const std::map<std::string, std::string>& loads_of_cases() {
  static const std::map<std::string, std::string> all = {
      {"four-bar", "[{at: P, force: 0.2 kN, direction: -100 deg}, {on: 4, couple: -20 N*m}]"},
      {"slider-crank",
       "[{at: B, on: 4, force: 1000 N, direction: 180 deg}, {on: 4, couple: 3 N*m}, {at: G, force: [0 N, -50 N]}]"},
      {"scotch-yoke", "[{at: C, force: [-200 N, 30 N]}]"},
      {"oldham", "[{at: C, force: [10 N, -20 N]}, {on: 4, couple: -25 N*m}]"},
      {"trammel", "[{at: P, force: [0 N, -700 N]}]"},
      {"excavator", "[{at: T, force: [0 N, -20 kN]}, {at: [2 m, 0.5 m], on: 2, force: 3 kN, direction: -60 deg}]"},
      {"oscillating-cylinder",
       "[{at: K, force: 900 N, direction: 20 deg}, {at: [100 mm, 0 m], on: 3, force: [0, -40]}]"},
      {"cardan-circles", "[{at: P, force: 80 N, direction: -30 deg}]"},
      {"geneva", "[{on: 3, couple: 12 N*m}]"},
      {"wheel-pair", "[{on: 3, couple: -30 N*m}]"},
      {"ring-wheel", "[{at: E, force: [-100 N, 40 N]}, {on: 3, couple: 6 N*m}]"},
      {"geared-five-bar", "[{at: [70 mm, 20 mm], on: 3, force: [30 N, -80 N]}, {on: 5, couple: 4 N*m}]"},
      {"planetary-gear", "[{at: P, force: [40 N, -25 N]}, {on: 4, couple: 3 N*m}]"},
      {"geared-press", "[{at: B, on: 5, force: [-500 N, 0]}]"},
      {"jansen", "[{at: F, force: [30 N, 200 N]}]"},
      {"driven-piston", "[{on: 2, couple: 15 N*m}, {at: D, force: [3 N, -8 N]}]"},
      {"two-blocks", "[{at: D, force: [-60 N, 25 N]}, {on: 3, couple: 2 N*m}]"}};
  return all;
}

// The same with friction, as make_scene_forces.py has it; and, where it is at rest, a speed.
const std::map<std::string, std::string>& friction_of_cases() {
  static const std::map<std::string, std::string> all = {
      {"slider-crank", "{b: 0.15}"},    {"scotch-yoke", "{A: 0.2, b: 8 deg}"},
      {"oldham", "{q: 0.1, s: 0.3}"},   {"geared-press", "{b: 0.2}"},
      {"trammel", "{A: 1/4, B: 0.25}"}, {"oscillating-cylinder", "{p: 0.12}"},
      {"cardan-circles", "{A: 0.1}"},   {"geneva", "{A: 0.15}"},
      {"driven-piston", "{b: 0.2}"},    {"two-blocks", "{p: 0.1, q: 8 deg}"}};
  return all;
}
const std::map<std::string, std::string>& circles_of_cases() {
  static const std::map<std::string, std::string> all = {
      {"four-bar", "{A0: 4 mm, A: 5 mm, B: 6 mm, B0: 3 mm}"},
      {"slider-crank", "{b: 0.15, A0: 4 mm, A: 0.006 m, B: 5 mm}"}};
  return all;
}
// Here each force found by trial from the one before leads ever farther away.
const std::map<std::string, std::string>& large_circles_of_cases() {
  static const std::map<std::string, std::string> all = {
      {"four-bar", "{A0: 40 mm, A: 100 mm, B: 120 mm, B0: 100 mm}"}};
  return all;
}
std::string moving(std::string text) {
  for (const auto& [at_rest, with_speed] :
       {std::pair<std::string, std::string>{"at: 450 mm}", "at: 450 mm, speed: 1 m/s}"},
        {"angle: 50 deg}", "angle: 50 deg, speed: 1 rad/s}"}})
    if (const auto at = text.find(at_rest); at != std::string::npos) text.replace(at, at_rest.size(), with_speed);
  return text;
}

std::vector<std::string> steps_of_forces(const std::string& text, const std::string& sheet, Language language,
                                         const std::vector<std::string>& set = {}) {
  const auto scene = std::make_shared<const scenes::Scene>("f", text);
  Givens givens(scene->givens());
  for (const std::string& each : set) givens.set(each);
  const DrawnSheet drawn = scenes::scene_exercise(scene)->draw(sheet, givens, {.language = language});
  return told_steps(drawn);
}

template <class Do>
std::string why_refused(const Do& carry_out) {
  try {
    carry_out();
  } catch (const BadGivens& bad) {
    return bad.what();
  }
  return {};
}

bool is_of_force(const Quantity& quantity) { return quantity.unit == "N" || quantity.unit == "N*m"; }
void holds(const CorpusCase& c, const CheckedQuantity& quantity, std::size_t routes) {
  const std::string reference = c.reference(quantity.spec.name);
  CAPTURE(quantity.spec.name, reference);
  REQUIRE_FALSE(reference.empty());
  is_the_reference(quantity, reference);
  CHECK(quantity.routes.size() == routes);
}

std::string loaded_four_bar(const std::string& loads) {
  return "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [400 mm, 0]}\n  2: {A0 A: 120 mm}\n"
         "  3: {A B: 350 mm}\n  4: {B0 B: 280 mm}\ndrive: {link: 2, angle: 60 deg}\n"
         "assembly: {B: left of A B0}\nloads:\n  - " +
         loads + "\n";
}

}  // namespace

TEST_CASE("reactions and driving efforts hold against the corpus, to the last bit, by each route", "[scenes]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/scene_forces.txt");
  CHECK(corpus.size() == loads_of_cases().size() + friction_of_cases().size() + circles_of_cases().size() +
                             large_circles_of_cases().size());
  for (const CorpusCase& c : corpus) {
    if (!loads_of_cases().contains(c.name)) continue;  // with friction: below
    const CheckedExercise found =
        checked_text(bytes_of_case(c.name) + "loads: " + loads_of_cases().at(c.name) + "\n");
    CAPTURE(c.name, complaints(found));
    CHECK(found.passed());
    int count = 0;
    for (const CheckedQuantity& quantity : found.quantities) {
      if (!is_of_force(quantity.spec)) continue;
      const bool is_of_drive = quantity.spec.name[0] == 'F' || quantity.spec.name == "M_2";
      holds(c, quantity, is_of_drive ? 3 : 2);
      ++count;
    }
    CHECK(count >= 3);
  }
}

void hold_with_friction(const std::string& ending, const std::map<std::string, std::string>& friction_of) {
  std::size_t cases = 0;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/scene_forces.txt")) {
    if (!c.name.ends_with(ending)) continue;
    ++cases;
    const std::string name = c.name.substr(0, c.name.size() - ending.size());
    const CheckedExercise found = checked_text(moving(bytes_of_case(name)) + "loads: " + loads_of_cases().at(name) +
                                               "\nfriction: " + friction_of.at(name) + "\n");
    CAPTURE(c.name, complaints(found));
    CHECK(found.passed());
    for (const CheckedQuantity& quantity : found.quantities)
      if (is_of_force(quantity.spec)) holds(c, quantity, quantity.spec.name.ends_with("_0") ? 3 : 2);
  }
  CHECK(cases == friction_of.size());
}
TEST_CASE("with friction they hold against the corpus too", "[scenes]") {
  hold_with_friction("-with-friction", friction_of_cases());
}
TEST_CASE("and with friction circles in hinges", "[scenes]") {
  hold_with_friction("-with-circles", circles_of_cases());
  hold_with_friction("-with-large-circles", large_circles_of_cases());
}

// A slider pushed with 3 N by a rod from 3 m below and 4 m behind it: |R| = |(3, 9/4 ± |R| r / 4)|. Turning on with
// the circle, that has one solution below r = 4 m, and none from there. Turning against it, one below 4 m, two up to
// 5 m, and none above.
TEST_CASE("how many sets of forces friction circles allow is told beside the limits too", "[scenes]") {
  const auto with = [](const std::string& speed, const std::string& r) {
    return "epure: 1\nid: f\nlinks:\n  1: {O: [-1 m, -3 m], g: {along: [1, 0]}}\n  2: {O A: 1 m}\n  3: {A B: 5 m}\n"
           "  4: {B: [0, 0], b: {along: [1, 0]}}\nslides: {b: g}\ndrive: {link: 2, angle: 0 deg, speed: " +
           speed +
           " rad/s}\nassembly: {B: ahead on g}\nloads: [{at: B, on: 4, force: [-3 N, 0]}]\nfriction: {B: " + r +
           "}\n";
  };
  struct Case {
    std::string speed, radius, refusal;
  };
  const std::string jams = "jams", two = "more than one set of forces";
  for (const auto& [speed, radius, refusal] : std::vector<Case>{{"1", "2 m", ""},
                                                                {"1", "3.999999999999999999999999 m", ""},
                                                                {"1", "4 m", jams},
                                                                {"1", "4.5 m", jams},
                                                                {"-1", "2 m", ""},
                                                                {"-1", "3.999999999999999999999999 m", ""},
                                                                {"-1", "4.000000000000000000000001 m", two},
                                                                {"-1", "4.999999999999999999999999 m", two},
                                                                {"-1", "5.000000000000000000000001 m", jams},
                                                                {"-1", "100 m", jams}}) {
    CAPTURE(speed, radius);
    const std::string text = with(speed, radius);
    if (refusal.empty())
      passes(text);
    else
      CHECK(why_refused([&] { checked_text(text); }).find(refusal) != std::string::npos);
  }
  // |R| = sqrt(3² + (9/4 + |R| / 2)²)
  CHECK(value(checked_text(with("1", "2 m")), "R_34") == Approx(6.08257569495584));
  // Of two circles, neither alone too large.
  const auto with_two = [](const std::string& circles) {
    return with_loads("slider-crank", "[{at: B, on: 4, force: [-600 N, 0]}]") + "friction: " + circles + "\n";
  };
  passes(with_two("{A: 100 mm, B: 150 mm}"));
  CHECK(why_refused([&] { checked_text(with_two("{A: 200 mm, B: 250 mm}")); }).find(jams) != std::string::npos);
}

// Rod 5 and its block bear nothing, though they would jam under any load: the circle in B is too large. So would
// every trial of forces, but from none. The values: Newton's iteration in mpmath.
TEST_CASE("a group without loads bears nothing, however much friction there is", "[scenes]") {
  const std::string text = R"yaml(epure: 1
id: f
links:
  1: {L: [183.433 mm, 28.268 mm], V: [287.999 mm, 228.126 mm], e: {through: [0.238704 m, -190.892 mm], along: -33 deg}}
  2: {L: [0, 0], B: [142.3 mm, 0]}
  3: {V: [0, 0], T: [0.691 m, 0]}
  4: {B: [0, 0], T: [0.8334 m, 0]}
  5: {B M: 82 mm}
slides: {M: e}
drive: {link: 2, angle: 295.8 deg, speed: 60 rpm, acceleration: -7 rad/s^2}
assembly: {T: right of V B, M: ahead on e}
loads: []
masses:
  4: {mass: 0.8 kg, at: [-0.091 m, 0.092 m], inertia: 0.02 kg*m^2}
gravity: 9.81 m/s^2
friction: {M: 0.032, B: 16 mm, L: 4 mm, T: 18 mm, V: 5 mm}
)yaml";
  passes(text);
  const CheckedExercise found = checked_text(text);
  CHECK(value(found, "R_25") == 0);
  CHECK(value(found, "N_M") == 0);
  CHECK(value(found, "M_2") == Approx(0.30659332));
  CHECK(value(found, "M_34") == Approx(-0.047360119));
}

// Of three circles together too, of which no change of the forces comes back smaller.
TEST_CASE("a group of several large friction circles without loads bears nothing", "[scenes]") {
  passes(R"yaml(epure: 1
id: f
links:
  1: {H: [-190.94123 mm, -48.05774 mm], V: [31.75931 mm, 292.53023 mm], U: [0.25621278 m, 127.62658 mm]}
  2: {H: [0, 0], M: [358.43794 mm, 146.7206 mm], L: [16.78465 mm, -617.42289 mm]}
  3: {U: [0, 0], Y: [0.460239 m, 0]}
  4: {L: [0, 0], Y: [40.7454 cm, 0], S: [-15.853553 cm, -52.57349 mm]}
  5: {S: [0, 0], G: [0.74382104 m, -201.09568 mm], e: {through: [0, 0], along: 0 deg}}
  6: {H: [0, 0], f: {through: [0, 0], along: 0 deg}}
  7: {G X: 287.947 mm}
  8: {Y X: 0.691505 m}
slides: {f: e}
drive: {length: V M, is: 549.8983 mm, speed: -20 cm/s, acceleration: 2 m/s^2}
assembly: {M: left of H V, Y: left of U L, e: from S towards H, X: right of G Y}
loads:
  - {on: 6, couple: -22 N*m}
  - {at: L, on: 4, force: [18 N, -75 N]}
friction: {f: 9 deg, G: 32 mm, L: 16 mm, S: 48 mm, X: 64 mm, Y: 48 mm}
)yaml");
}

// A link that rests has no inertia to act, whatever moves beside it; and the telescope bears nothing, as the load on
// it goes through its hinge.
TEST_CASE("with friction circles too it is proved which forces are zero", "[scenes]") {
  passes(R"yaml(epure: 1
id: f
links:
  1: {E: [-22.0506 cm, 142.622 mm], W: [0.476789 m, 342.231 mm]}
  2: {E: [0, 0], J: [271.424 mm, 63.675 mm]}
  3: {W: [0, 0], C: [864.909 mm, 38.12 cm], e: {through: [0, -2 cm], along: 0 deg}}
  4: {C: [0, 0], U: [539.5 mm, 0], g: {through: [61.108 mm, 176.485 mm], along: 0 deg}}
  5: {J: [0, 0], U: [348.3 mm, 0], f: {through: [-0.084918 m, -268.79 mm], along: 94 deg}}
  6: {T: [0, 0], h: {through: [0, 0], along: 0 deg}}
slides: {E: e, h: f, T: g}
drive: {length: W J, is: 528.28 mm, speed: -20 cm/s, acceleration: 2 m/s^2}
assembly: {J: right of E W, e: from W towards E, U: right of C J}
loads:
  - {on: 3, couple: 38 N*m}
  - {on: 5, couple: 43 N*m}
  - {at: T, on: 6, force: [-266 N, -240 N]}
masses:
  3: {mass: 3.5 kg, at: [0.054 m, -0.086 m], inertia: 0.029 kg*m^2}
friction: {C: 23 mm, U: 2 mm}
)yaml");
  passes(R"yaml(epure: 1
id: f
links:
  1: {F: [-254.67445 mm, 0.09199324 m], U: [-297.672 mm, -218.22994 mm], L: [-154.7119 mm, -0.08366851 m]}
  2: {F: [0, 0], B: [289.43888 mm, -0.10570411 m], C: [0.22134343 m, -19.55464 cm]}
  3: {L: [0, 0], e: {through: [0, 0], along: 0 deg}}
  4: {C: [0, 0], f: {through: [0, 0], along: 0 deg}}
slides: {f: e}
drive: {length: U B, is: 92.6821 mm, speed: -20 cm/s, acceleration: 2 m/s^2}
assembly: {B: left of F U, e: from L towards C}
loads:
  - {at: L, on: 3, force: [205 N, -114 N]}
  - {on: 2, couple: 48 N*m}
masses:
  2: {mass: 3.1 kg, at: [-0.031 m, -0.094 m]}
gravity: 9.81 m/s^2
friction: {f: 9 deg, C: 3 mm, F: 3 mm}
)yaml");
}

// The tool's rod bears nothing where the load acts on the rocker.
TEST_CASE("where nothing presses there is no friction, and that is proved", "[scenes]") {
  const std::string text = scenes::bytes_of(EPURE_SCENES "/quick-return.yaml") +
                           "loads: [{at: B, on: 4, force: [-100 N, 0]}]\nfriction: {A: 0.1, C: 0.2}\n";
  const CheckedExercise found = checked_text(text);
  CAPTURE(complaints(found));
  CHECK(found.passed());
  for (const std::string name : {"N_C", "T_C", "R_gC"}) {
    CHECK(find(found, name).settled.kind == geometry::Settled::Kind::certain);
    CHECK(value(found, name) == 0);
  }
  CHECK(value(found, "T_A") != 0);
  // A group that bears nothing has no couples of friction either, and no arms of forces that are none.
  const CheckedExercise idle =
      checked_text(scenes::bytes_of(EPURE_SCENES "/four-bar.yaml") +
                   "loads: [{on: 2, couple: 5 N*m}]\nfriction: {A: 2 mm, B: 3 mm, B0: 1 mm}\n");
  CAPTURE(complaints(idle));
  CHECK(idle.passed());
  CHECK(idle.undecided.empty());
  CHECK(value(idle, "M_34") == 0);
}

// A crank at a right angle to its guide pushes the pin with tan(elevation) = h / d on it: with a coefficient of d / h
// and more nothing moves. The crank's pin is 3 m below the guide and the slider 4 m ahead of it.
TEST_CASE("a mechanism that jams by friction is refused, beside that limit it is not", "[scenes]") {
  const auto with = [](const std::string& f) {
    return "epure: 1\nid: f\nlinks:\n  1: {O: [0, -4 m], g: {along: [1, 0]}}\n  2: {O A: 1 m}\n  3: {A B: 5 m}\n"
           "slides: {B: g}\ndrive: {link: 2, angle: 90 deg, speed: -1 rad/s}\nassembly: {B: ahead on g}\n"
           "loads: [{at: B, force: [-3 N, 0]}]\nfriction: {B: " +
           f + "}\n";
  };
  for (const std::string free : {"1.333333333", "1.33333333333333333333333333333333"}) {
    CAPTURE(free);
    const CheckedExercise found = checked_text(with(free));
    CHECK(found.passed());
    CHECK(value(found, "R_23_x") > 1e8);
  }
  for (const std::string too_much : {"4/3", "1.333333333333333333333333333333334", "3"}) {
    CAPTURE(too_much);
    CHECK(why_refused([&] { checked_text(with(too_much)); }).find("jams") != std::string::npos);
  }
}

TEST_CASE("friction of what does not slide now, or never, is refused with its place", "[scenes]") {
  const auto text = [](const std::string& friction) {
    return with_loads("slider-crank", "[{at: B, on: 4, force: [-3 N, 0]}]") + "friction: " + friction + "\n";
  };
  CHECK(why_refused([&] {
          checked_text(text("{b: 0.1}"), {"e=0", "phi=0deg"});
        }) == "b does not slide on g at this instant: friction there may have any size up to its limit");
  CHECK(why_refused([&] {
          checked_text(text("{b: 0.1}"), {"n=0", "alpha=0"});
        }) ==
        "b does not slide on g at this instant: friction there may have any size up to its limit; no drive has a "
        "speed");
  for (const auto& [friction, says] : std::map<std::string, std::string>{
           {"{A: 0.1}", "A does not slide: friction is told of a point or line that does, C of  slides: {C: g}"},
           {"{b: -0.1}", "\"-0.1\" is below zero, and no coefficient of friction is"},
           {"{b: 90 deg}", "\"90 deg\" is no angle of friction: these are from 0 to below 90 degrees"},
           {"{b: -1 deg}", "\"-1 deg\" is no angle of friction: these are from 0 to below 90 degrees"},
           {"[b]", "friction: {C: 0.15} or {C: 8 deg} of what slides, {A: 5 mm}, its friction circle, of a hinge"},
           {"{G: 5 mm}", "G is no hinge: of what slides there is a coefficient of friction or its angle"},
           {"{A: -5 mm}", "\"-5 mm\" is below zero, and no radius of a friction circle is"},
           {"{z: 1}", "no link has a point z"}})
    CHECK(refused_loads(text(friction)).find(says) != std::string::npos);
  CHECK(refused_loads(scenes::bytes_of(EPURE_SCENES "/slider-crank.yaml") + "friction: {b: 0.1}\n")
            .find("nothing presses here: friction needs  loads:  or  masses:") != std::string::npos);
}

TEST_CASE("without loads no force is asked for, and with none in the list all are proved zero", "[scenes]") {
  for (const CheckedQuantity& quantity : checked_text(scenes::bytes_of(EPURE_SCENES "/four-bar.yaml")).quantities)
    CHECK_FALSE(is_of_force(quantity.spec));
  const CheckedExercise idle = checked_text(with_loads("four-bar", "[]"));
  CHECK(idle.passed());
  CHECK(find(idle, "M_2").settled.kind == geometry::Settled::Kind::certain);
  CHECK(value(idle, "R_34") == 0);
}

// A slider-crank pushed along its line: at a right angle between rod and guide nothing would hold it. The rod's
// elevation over the guide is d, so the rod bears F/cos and the guide F tan, which grow beyond all bounds.
TEST_CASE("beside a dead centre forces are found however large, and at it refused", "[scenes]") {
  const std::string text =
      "epure: 1\nid: f\ngivens: {e: 0 m}\nlinks:\n  1: {O: [0, 0], g: {through: [0, e], along: [1, 0]}}\n"
      "  2: {O A: 0.5 m}\n  3: {A B: 1 m}\nslides: {B: g}\ndrive: {link: 2, angle: 90 deg}\n"
      "assembly: {B: ahead on g}\nloads: [{at: B, force: [-3 N, 0]}]\n";
  for (const int places : {9, 30}) {
    CAPTURE(places);
    // The guide lies 1 m less m below A.
    const double m = std::pow(10.0, -places), along = std::sqrt(m * (2 - m));
    const CheckedExercise found =
        checked_text(text, {"e=-0.4" + std::string(static_cast<std::size_t>(places) - 1, '9') + "m"});
    CAPTURE(complaints(found));
    CHECK(found.passed());
    CHECK(value(found, "R_23_x") == Approx(3));
    CHECK(value(found, "N_B") == Approx(3 * (1 - m) / along).epsilon(1e-12));
    CHECK(value(found, "R_23") == Approx(3 / along).epsilon(1e-12));
  }
  for (const std::string e : {"e=-0.5m", "e=-0.50000000000000000000000000000000001m"}) {
    CAPTURE(e);
    const std::string why = why_refused([&] { checked_text(text, {e}); });
    CHECK(why.find("B") != std::string::npos);
    CHECK(why.find(e == "e=-0.5m" ? "square to g" : "does not reach g") != std::string::npos);
  }
}

TEST_CASE("what is wrong with loads is told with its place", "[scenes]") {
  const auto why = [](const std::string& load) { return refused_loads(loaded_four_bar(load)); };
  CHECK(why("{at: Z, force: 1 N, direction: 0 deg}").starts_with("11:10: no link has a point Z"));
  CHECK(why("{at: B, force: 1 N, direction: 0 deg}") ==
        "11:10: B is of links 3 and 4: say on which the force acts, as  on: 4");
  CHECK(why("{at: B, on: 2, force: 1 N, direction: 0 deg}") == "11:17: link 2 has no point B");
  CHECK(why("{at: B, on: 9, force: 1 N, direction: 0 deg}") == "11:17: there is no link 9");
  CHECK(why("{at: A0, on: 1, force: 1 N, direction: 0 deg}").starts_with("11:18: link 1 is the frame"));
  CHECK(why("{at: B, on: 3, force: 1 N}") == "11:5: direction: is missing");
  CHECK(why("{at: B, on: 3, force: 1 m, direction: 0 deg}").starts_with("11:27: \"1 m\" is a length where a force"));
  CHECK(why("{at: B, on: 3, force: [1 N, 2], direction: 0 deg}").starts_with("11:48: a force of two components"));
  CHECK(why("{at: B, on: 3, force: [1 N]}").starts_with("11:27: two components are asked"));
  CHECK(why("{on: 3, couple: 2 N}").starts_with("11:21: \"2 N\" is a force where a couple"));
  CHECK(why("{on: 1, couple: 2 N*m}").starts_with("11:10: link 1 is the frame"));
  CHECK(why("{on: 3, coupel: 2 N*m}").find("coupel") != std::string::npos);
}

// A planetary gear that its sun drives: two forces on the planet are unknown at once. And two planets for one ring.
TEST_CASE("forces in teeth that are found only together, or not at all, are refused by name", "[scenes]") {
  std::string by_sun = with_loads("planetary-gear", "[{on: 2, couple: 1 N*m}]");
  by_sun.replace(by_sun.find("drive: {link: 2"), 15, "drive: {link: 4");
  CHECK(refused_loads(by_sun).find("links 2 and 3 are held by forces in teeth that are found only together") !=
        std::string::npos);
  const std::string two_planets =
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {C: [80 mm, 0], O: [0, 0], D: [-80 mm, 0]}\n  3: {C: [0, 0]}\n"
      "  4: {O: [0, 0]}\n  5: {D: [0, 0]}\ngears:\n  - {wheels: 1 3, on: 2, teeth: [72, 24], inside: yes}\n"
      "  - {wheels: 3 4, on: 2, teeth: [24, 24]}\n  - {wheels: 1 5, on: 2, teeth: [72, 24], inside: yes}\n"
      "  - {wheels: 5 4, on: 2, teeth: [24, 24]}\ndrive: {link: 2, angle: 0 deg}\nloads: [{on: 4, couple: 1 N*m}]\n";
  CHECK(refused_loads(two_planets).find("hang on more than they can follow") != std::string::npos);
  for (const std::string angle : {"-1 deg", "90 deg", "2 m"}) {
    const std::string gears = "gears: [{wheels: 2 3, on: 1, teeth: [20, 40]";
    std::string text = bytes_of_case("wheel-pair");
    text.replace(text.find(gears), gears.size(), gears + ", pressure_angle: " + angle);
    CAPTURE(angle);
    CHECK(refused_loads(text).find(angle) != std::string::npos);
  }
}

TEST_CASE("the forces of wheels are told along their lines of action", "[scenes]") {
  const std::string winch = scenes::bytes_of(EPURE_SCENES "/winch.yaml");
  const std::vector<std::string> drum = steps_of_forces(winch, "forces-4", Language::english),
                                 between = steps_of_forces(winch, "forces-3", Language::italian);
  REQUIRE(drum.size() == 5);
  CHECK(drum[0] ==
        "Along the line of action through the pitch point, at α_34 = α to the common tangent: R_34, which presses "
        "the tooth towards the wheel's centre.");
  CHECK(drum[1] == "Link 4, moments about C: R_34·h_34 = F·h_F.");
  CHECK(drum[3] == "From a the known R_34, ⊥ BC + α_34.");
  REQUIRE(between.size() == 5);
  CHECK(between[1] == "Membro 3, momenti rispetto a B: R_23·h_23 = R_43·h_34,3.");
  const std::vector<std::string> ring = steps_of_forces(
      bytes_of_case("ring-wheel") + "loads: [{on: 3, couple: 6 N*m}]\n", "forces-3", Language::english);
  CHECK(ring[0] ==
        "Along the line of action through the pitch point, at α = 25° to the common tangent: R_23, which presses the "
        "tooth outwards, as link 3 is a ring.");
}

// Nothing presses where nothing acts: that is proved, and the line of action is any of the two.
TEST_CASE("teeth that bear nothing are proved to", "[scenes]") {
  const CheckedExercise idle = checked_text(with_loads("geared-five-bar", "[{on: 2, couple: 3 N*m}]"));
  CAPTURE(complaints(idle));
  CHECK(idle.passed());
  for (const char* name : {"R_25", "R_25_x", "R_25_t", "R_25_r", "R_15"}) {
    CAPTURE(name);
    CHECK(find(idle, name).settled.kind == geometry::Settled::Kind::certain);
    CHECK(value(idle, name) == 0);
  }
}

TEST_CASE("sheets of forces go from the last group to the drive, and are told as they are drawn", "[scenes]") {
  const std::string four_bar = scenes::bytes_of(EPURE_SCENES "/loaded-four-bar.yaml"),
                    shaper = scenes::bytes_of(EPURE_SCENES "/cutting-stroke.yaml");
  CHECK(steps_of_forces(four_bar, "forces", Language::english) ==
        std::vector<std::string>{"First links 3 and 4, where only loads act: R_23, R_34, R_14 (sheet 8).",
                                 "At last link 2, with what the others exert on it: R_12, M_2 (sheet 9)."});
  CHECK(steps_of_forces(shaper, "forces", Language::italian)[1] ==
        "Poi il membro 4, con ciò che gli altri vi esercitano: R_14, N_A (tavola 11).");
  CHECK(steps_of_forces(four_bar, "forces-3-4", Language::english) ==
        std::vector<std::string>{"Link 3, moments about B: R_23^t·AB = F·h_F.",
                                 "Link 4, moments about B: R_14^t·B_0B = C.", "From o_3,4 the known R_23^t, ⊥ AB.",
                                 "From a the known F, ∠ −100°.", "From b the known R_14^t, ⊥ B_0B.",
                                 "Through c the line ∥ B_0B: the direction of R_14^n.",
                                 "Through o_3,4 the line ∥ AB: the direction of R_23^n. The two lines meet at d.",
                                 "R_23 is the sum of its two parts.", "R_14 is the sum of its two parts.",
                                 "R_43 closes the forces on link 3."});
  CHECK(steps_of_forces(four_bar, "forces-2", Language::italian) ==
        std::vector<std::string>{"Due sole forze: R_12 = −R_32.",
                                 "Membro 2, momenti rispetto a A_0: M_2 = R_32·h_23."});
  CHECK(steps_of_forces(shaper, "forces-4", Language::italian) ==
        std::vector<std::string>{"Non c'è attrito: la N_A è normale a s. Qui agisce la sua opposta, −N_A.",
                                 "Membro 4, momenti rispetto a O_4: N_A·h_NA = −R_54·h_45.",
                                 "Da o_4 la R_54 nota, ∥ R_45.", "Da a la −N_A nota, ⊥ s.",
                                 "La R_14, da b a o_4, chiude il poligono."});
  // Of the other way the couple acts, and of no force at all.
  CHECK(steps_of_forces(four_bar, "forces-3-4", Language::english, {"C=-20N*m"})[1] ==
        "Link 4, moments about B: R_14^t·B_0B = −C.");
  CHECK(steps_of_forces(four_bar, "forces-3-4", Language::english, {"F=0N"})[0] ==
        "Link 3, moments about B: R_23^t·AB = 0.");
}

TEST_CASE("every sheet of forces has room for its letters, and each reaction on it is what was found", "[scenes]") {
  for (const auto& [name, loads] : loads_of_cases()) {
    const std::string text = bytes_of_case(name) + "loads: " + loads + "\n";
    const auto exercise = exercise_said(text);
    int count = 0;
    for (const SheetSpec& sheet : exercise->about().sheets) {
      if (!sheet.name.starts_with("forces")) continue;
      CAPTURE(name, sheet.name);
      for (const Language language : {Language::english, Language::italian}) {
        const DrawnSheet drawn = exercise->draw(sheet.name, Givens(exercise->about().givens), {.language = language});
        CAPTURE(drawings::overlaps(drawn.sheet));
        CHECK(drawings::overlaps(drawn.sheet).empty());
      }
      ++count;
    }
    CHECK(count >= 3);
    for (const CheckedQuantity& quantity : checked_text(text).quantities) {
      CAPTURE(name, quantity.spec.name);
      const bool is_reaction = quantity.spec.name.starts_with("R_") || quantity.spec.name.starts_with("N_");
      const bool is_size = !quantity.spec.name.ends_with("_x") && !quantity.spec.name.ends_with("_y");
      // Parts of a tooth's force are told, not drawn: the polygon has it whole.
      const bool is_of_teeth = quantity.spec.meaning.english.find("pitch circles") != std::string::npos ||
                               quantity.spec.meaning.english.find("line of centres") != std::string::npos;
      if (is_reaction && is_size && !is_of_teeth) CHECK_FALSE(quantity.on_sheets.empty());
    }
  }
}

TEST_CASE("a polygon of more forces than there are letters has letters with numbers", "[scenes]") {
  std::string loads = "[";
  for (int i = 1; i <= 30; ++i) loads += "{at: B, on: 4, force: [" + std::to_string(i) + " N, 1 N]}, ";
  const auto exercise = exercise_said(with_loads("four-bar", loads + "]"));
  for (const SheetSpec& sheet : exercise->about().sheets)
    CHECK_FALSE(drawings::svg(exercise->draw(sheet.name, Givens(exercise->about().givens), {}).sheet).empty());
}

TEST_CASE("inertia is told and drawn among the loads", "[scenes]") {
  const std::string engine = scenes::bytes_of(EPURE_SCENES "/engine.yaml");
  const std::vector<std::string> on_rod = steps_of_forces(engine, "forces-3-4", Language::english),
                                 on_crank = steps_of_forces(engine, "forces-2", Language::italian);
  CHECK(on_rod[0] == "Link 3, d'Alembert: F_3 = −m_3·a_G in G, and C_3 = −J_3·α_3.");
  CHECK(on_rod[1] == "Link 3, moments about B: R_23^t·AB = −W_3·h_W3 + F_3·h_F3 − C_3.");
  CHECK(on_crank[0] == "Membro 2, d'Alembert: F_2 = −m_2·a_S in S.");
  CHECK(on_crank[1] == "Membro 2, momenti rispetto a O: M_2 = −W_2·h_W2 − R_32·h_23.");
  // Five forces are known on rod and piston: their polygon stands alone.
  CHECK(on_rod.back() == "There is no friction: N_b is square to c.");
  CHECK(steps_of_forces(engine, "forces-3-4-polygon", Language::english).size() == 10);
  const CheckedExercise growing = checked_text(scenes::bytes_of(EPURE_SCENES "/loaded-four-bar.yaml") +
                                               "masses: {2: {mass: 2 kg, at: A, inertia: 0.1 kg*m^2}}\n");
  for (const CheckedQuantity& quantity : growing.quantities) {
    CHECK(quantity.spec.name != "C_2");  // it turns steadily
    CHECK(quantity.spec.name != "h_F_2");
  }
}

namespace {

// With plain blanks.
std::string given_on(const std::string& text, const std::string& sheet, bool blank,
                     Language language = Language::english) {
  const auto scene = std::make_shared<const scenes::Scene>("f", text);
  const DrawnSheet drawn =
      scenes::scene_exercise(scene)->draw(sheet, Givens(scene->givens()), {.language = language, .blank = blank});
  return geometry::in_plain_characters(drawings::plain(std::get<drawings::Paragraph>(drawn.sheet.column.at(1)).text));
}

}  // namespace

// Attacked: of a load in place neither its size nor the drive's speed stood on a sheet that asked for reactions.
TEST_CASE("what a file says in place stands beside its givens, on sheets to be solved too", "[scenes]") {
  const std::string text =
      "epure: 1\nid: f\ngivens: {theta: 40 deg, F: 10 N}\nlinks:\n  1: {A0: [0, 0], g: {along: [1, 0]}}\n"
      "  2: {A0 A: 120 mm}\n  3: {A: [0, 0], B: [350 mm, 0], G: [170 mm, 0]}\n  4: {B: [0, 0], b: {along: [1, 0]}}\n"
      "slides: {b: g}\ndrive: {link: 2, angle: theta, speed: -71.5 rpm, acceleration: 13 rad/s^2}\n"
      "assembly: {B: ahead on g}\nloads: [{at: B, on: 4, force: 237 N, direction: 180 deg}, {on: 3, couple: -31 "
      "N*m}, "
      "{at: G, force: [-5 N, 3*F]}, {at: A, on: 2, force: -F, direction: 90 deg}]\n"
      "masses: {3: {mass: 1.73 kg, at: G, inertia: 187 kg cm^2}}\ngravity: 9.81 m/s^2\nfriction: {b: 0.137}\n";
  for (const bool blank : {false, true}) {
    CHECK(given_on(text, "forces-3-4", blank) ==
          "θ = 40°, F = 10 N, speed of link 2 = -71.5 rpm, acceleration of link 2 = 13 rad/s², Q_B = 237 N, "
          "T_3 = -31 N m, Q_G,x = -5 N, Q_G,y = 30 N, g = 9.81 m/s², m_3 = 1.73 kg, J_3 = 187 kg cm², "
          "friction of b = 0.137");
    CHECK(given_on(text, "velocities", blank, Language::italian) ==
          "θ = 40°, F = 10 N, velocità del membro 2 = -71,5 giri/min, accelerazione del membro 2 = 13 rad/s², "
          "Q_B = 237 N, T_3 = -31 N m, Q_G,x = -5 N, Q_G,y = 30 N, g = 9,81 m/s², m_3 = 1,73 kg, J_3 = 187 kg cm², "
          "attrito di b = 0,137");
  }
  // Of a file that has no givens there is nothing else to tell.
  const std::string wheels =
      "epure: 1\nid: f\nlinks:\n  1: {A: [0, 0], B: [90 mm, 120 mm]}\n  2: {A: [0, 0]}\n  3: {B: [0, 0]}\n"
      "gears: [{wheels: 2 3, on: 1, teeth: [20, 40], pressure_angle: 25 deg}]\ndrive: {link: 2, angle: 30 deg}\n";
  CHECK(given_on(wheels, "velocities", true) ==
        "teeth of wheel 2 = 20, teeth of wheel 3 = 40, pressure angle = 25°, angle of link 2 = 30°");
  // What is a given is told once.
  CHECK(given_on(scenes::bytes_of(EPURE_SCENES "/engine.yaml"), "velocities", true).ends_with("g = 9.81 m/s²"));
}

// Attacked: the check held what a step told as the file has it, 1.5 kN, against 1500 N.
TEST_CASE("loads, their directions and friction pass the check in any unit", "[scenes]") {
  const std::string head =
      "epure: 1\nid: f\ngivens: {r: 100 mm}\nlinks:\n  1: {O: [0, 0], g: {through: [0, 20 mm], along: [1, 0]}}\n"
      "  2: {O A: r}\n  3: {A B: 330 mm}\n  4: {B: [0, 0], b: {along: [1, 0]}}\nslides: {b: g}\nassembly: {B: ahead "
      "on g}\n"
      "drive: {link: 2, angle: 50 deg, speed: 60 rpm}\nloads:\n  - {at: B, on: 4, ";
  for (const std::string load : {"force: [1.5 kN, 0.3 kN]}", "force: [50.39 daN, -41.2 kgf]}",
                                 "force: 1.5 kN, direction: 2.5 rad}", "force: 1500 N, direction: 91.25 gon}"})
    for (const std::string friction :
         {"{b: 0.14 rad}", "{b: 9.3 gon}", "{b: 0.02 turn, O: 0.35 cm}", "{b: 0.15, A: 0.12 in}", "{b: 1/7}"}) {
      CAPTURE(load, friction);
      const CheckedExercise checked = checked_text(head + load + "\nfriction: " + friction + "\n");
      for (const Complaint& each : checked.failures) UNSCOPED_INFO(each.sentence.english);
      CHECK(checked.passed());
    }
}

// Attacked: weights are asked for, and their numbers stood at arrows too short to be drawn.
TEST_CASE("on a sheet to be solved no weight is drawn that it asks for", "[scenes]") {
  const auto scene = std::make_shared<const scenes::Scene>("f", scenes::bytes_of(EPURE_SCENES "/engine.yaml"));
  const auto exercise = scenes::scene_exercise(scene);
  for (const std::string sheet : {"forces-3-4", "forces-2"})
    for (const bool blank : {false, true}) {
      const DrawnSheet drawn = exercise->draw(sheet, Givens(scene->givens()), {.blank = blank, .for_class = true});
      CHECK(std::any_of(drawn.asked.begin(), drawn.asked.end(),
                        [](const auto& name) { return name.starts_with("W_"); }));
      const auto& labels = drawn.sheet.figure.labels;
      const auto tells_weight = [](const drawings::Label& each) { return each.text.find("W") != std::string::npos; };
      CHECK(std::any_of(labels.begin(), labels.end(), tells_weight) != blank);
    }
}

// At rest there is no inertia; without gravity no weight; as fast again inertia is four times as large.
TEST_CASE("inertia goes with the square of the speed, weights do not", "[scenes]") {
  const std::string engine = scenes::bytes_of(EPURE_SCENES "/engine.yaml");
  const CheckedExercise still = checked_text(engine, {"n=0rpm"}), slow = checked_text(engine, {"F=0N", "g=0m/s^2"}),
                        fast = checked_text(engine, {"F=0N", "g=0m/s^2", "n=3000rpm"});
  for (const CheckedExercise* each : {&still, &slow, &fast}) {
    CAPTURE(complaints(*each));
    CHECK(each->passed());
  }
  CHECK(value(still, "F_3") == 0);
  CHECK(value(still, "W_3") == Approx(11.772));
  CHECK(value(slow, "W_3") == 0);
  for (const char* name : {"F_3", "C_3", "R_12", "R_34_x", "N_b", "M_2"})
    CHECK(value(fast, name) == Approx(4 * value(slow, name)).epsilon(1e-12));
  // A crank with its mass on its own line runs evenly without a couple, its centrifugal force through its hinge.
  const CheckedExercise rotor = checked_text(
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O: [0, 0], S: [20 mm, 0]}\n"
      "drive: {link: 2, angle: 40 deg, speed: 600 rpm}\nmasses: {2: {mass: 3 kg, at: S, inertia: 0.1 kg*m^2}}\n");
  CAPTURE(complaints(rotor));
  CHECK(rotor.passed());
  CHECK(find(rotor, "M_2").settled.kind == geometry::Settled::Kind::certain);
  CHECK(value(rotor, "M_2") == 0);
  CHECK(value(rotor, "R_12") == Approx(3 * 0.02 * std::pow(62.83185307179586, 2)));
}

TEST_CASE("what is wrong with masses is told with its place", "[scenes]") {
  const auto why = [](const std::string& masses) {
    std::string text = loaded_four_bar("");
    text = text.substr(0, text.find("loads:")) + masses + "\n";
    return refused_loads(text);
  };
  CHECK(why("masses: {3: {mass: 2 kg}}").starts_with("10:13: at: is missing: where the centre of mass is"));
  CHECK(why("masses: {3: {mass: 2 kg, at: B0}}") == "10:30: link 3 has no point B0");
  CHECK(why("masses: {7: {mass: 2 kg, at: B}}") == "10:10: there is no link 7");
  CHECK(why("masses: {1: {mass: 2 kg, at: A0}}").starts_with("10:10: link 1 is the frame: its mass"));
  CHECK(why("masses: {3: {mass: -2 kg, at: A}}").starts_with("10:20: \"-2 kg\" is below zero"));
  CHECK(why("masses: {3: {mass: 2 N, at: A}}").starts_with("10:20: \"2 N\" is a force where a mass"));
  CHECK(why("masses: {3: {mass: 2 kg, at: A, inertia: 2 kg}}").find("a moment of inertia") != std::string::npos);
  CHECK(why("masses: {3: {mas: 2 kg, at: A}}").find("did you mean mass") != std::string::npos);
  CHECK(why("gravity: 9.81 m/s^2").starts_with("10:10: nothing weighs here"));
  CHECK(why("masses: {3: {mass: 2 kg, at: A}}\ngravity: [1 m/s^2]").starts_with("11:10: two components are asked"));
  CHECK(why("masses: {3: {mass: 2 kg, at: A}}\ngravity: 9.81 m").starts_with("11:10: \"9.81 m\" is a length"));
  CHECK(why("masses: [3]").find("masses: {3: {mass: 2 kg") != std::string::npos);
}

TEST_CASE("loads in any direction are told as they are given, and that is checked", "[scenes]") {
  std::string text = scenes::bytes_of(EPURE_SCENES "/loaded-four-bar.yaml");
  const std::string here = "direction: ";
  const std::size_t from = text.find(here) + here.size(), to = text.find('}', from);
  for (const std::string direction : {"80.5 deg", "-97.80 deg", "45.1234 deg", "1.2 rad"}) {
    const CheckedExercise checked = checked_text(std::string(text).replace(from, to - from, direction));
    CAPTURE(direction, complaints(checked));
    CHECK(checked.passed());
  }
}

// A route that cannot tell the sign of the moment knows all the same how small the arm is, which the other proves
// zero.
TEST_CASE("arms of forces through the joint are decided, however it is given", "[scenes]") {
  passes(R"yaml(epure: 1
id: f
givens:
  r: {value: 60 mm}
  l: {value: 220 mm}
  phi: {value: 150 deg}
  n: {value: 1500 rpm}
  F: {value: 3000 N}
  m_2: {value: 2 kg}
  m_3: {value: 1.2 kg}
  J_3: {value: 0.0085 kg*m^2}
  m_4: {value: 0.9 kg}
  g: 9.81 m/s^2
links:
  1: {O: [0, 0], c: {along: [0, 1]}}
  2: {O: [0, 0], A: [r, 0], S: [r/4, 0]}
  3: {A: [0, 0], B: [l, 0], G: [l/3, 0]}
  4: {B: [0, 0.0000000001], b: {along: [0, 1]}}
slides: {b: c}
drive: {link: 2, angle: phi, speed: n}
assembly: {B: ahead on c}
loads:
  - {at: B, on: 4, force: F, direction: -90 deg}
masses:
  2: {mass: m_2, at: S}
  3: {mass: m_3, at: G, inertia: J_3}
  4: {mass: m_4, at: B}
gravity: g
)yaml");
}
