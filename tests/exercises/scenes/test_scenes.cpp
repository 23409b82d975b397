// Mechanisms from files: those of docs/scenes hold against values made apart; files that are wrong are refused with
// their place and a sentence; the format says what it says.
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drawings/text/text.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/place.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/scenes/coincidences.h"
#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/scene.h"
#include "exercises/scenes/scene_exercise.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/scenes/said.h"

using namespace epure;
using namespace epure::tests;

namespace {

std::unique_ptr<Exercise> exercise_of(const std::string& name) {
  const std::string file = EPURE_SCENES "/" + name + ".yaml";
  return scenes::scene_exercise(std::make_shared<const scenes::Scene>(file, scenes::bytes_of(file)));
}

// The sentence that a file is refused with, its name left out; empty when it is read.
std::string refusal(const std::string& text) {
  try {
    scenes::Scene("f", text);
  } catch (const scenes::BadScene& bad) {
    return std::string(bad.what()).substr(2);
  }
  return {};
}

// A four-bar with lines put in, or in the place of others.
std::string four_bar(const std::string& drive = "drive: {link: 2, angle: 60 deg, speed: 60 rpm}",
                     const std::string& assembly = "assembly: {B: left of A B0}",
                     const std::string& crank = "2: {A0 A: 120 mm}") {
  return "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [400 mm, 0]}\n  " + crank +
         "\n  3: {A B: 350 mm}\n  4: {B0 B: 280 mm}\n" + drive + "\n" + assembly + "\n";
}

double value_in(const std::string& text, const std::string& quantity) { return value(checked_text(text), quantity); }

}  // namespace

TEST_CASE("what a scene says of a given is plain text, whatever letters it has", "[scenes]") {
  const std::string drive = "drive: {link: 2, angle: a, speed: 60 rpm}\ngivens: {a: {value: 60 deg, meaning: '";
  for (const std::string meaning : {"price in $", "a_{b", "$\\x$"}) {
    CAPTURE(meaning);
    const auto scene = std::make_shared<const scenes::Scene>("f", four_bar(drive + meaning + "'}}"));
    CHECK(drawings::plain(scene->givens().front().meaning.english) == meaning);
  }
}

TEST_CASE("every scene of the docs holds against the corpus, to the last bit, by both routes", "[scenes]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/linkages.txt");
  CHECK(corpus.size() == 25);
  for (const CorpusCase& c : corpus) {
    const auto exercise = exercise_of(c.name);
    const CheckedExercise checked = check(*exercise, Givens(exercise->about().givens), Rung::climb);
    CAPTURE(c.name, complaints(checked));
    CHECK(checked.passed());
    for (const CheckedQuantity& quantity : checked.quantities) {
      const std::string& name = quantity.spec.name;
      if (name.find("_max") != std::string::npos || name.find("_min") != std::string::npos)
        continue;  // test_extremes
      const std::string reference = c.reference(name);
      CAPTURE(name, reference);
      REQUIRE_FALSE(reference.empty());
      is_the_reference(quantity, reference);
    }
  }
}

TEST_CASE("a scene's sheets find room for their letters", "[scenes]") {
  for (const auto& entry : std::filesystem::directory_iterator(EPURE_SCENES)) {
    const auto exercise = exercise_of(entry.path().stem());
    for (const SheetSpec& sheet : exercise->about().sheets)
      for (const Language language : {Language::english, Language::italian}) {
        const DrawnSheet drawn = exercise->draw(sheet.name, Givens(exercise->about().givens), {.language = language});
        CAPTURE(entry.path().filename(), sheet.name, drawings::overlaps(drawn.sheet));
        CHECK(drawings::overlaps(drawn.sheet).empty());
      }
  }
}

TEST_CASE("a number is read exactly, with any unit, and formulas of givens", "[scenes]") {
  const std::string A_x = "A_x";
  CHECK(value_in(four_bar("drive: {link: 2, angle: 0 deg, speed: 60 rpm}"), A_x) == 0.12);
  CHECK(value_in(four_bar("drive: {link: 2, angle: 0 deg}", "assembly: {B: left of A B0}", "2: {A0 A: 1/30 m}"),
                 A_x) == 1.0 / 30);
  CHECK(value_in(four_bar("drive: {link: 2, angle: 0 deg}\ngivens: {r: 100 mm, k: 3}\nwhere: {h: r/k}",
                          "assembly: {B: left of A B0}", "2: {A0 A: (h + 2*h)/1.0 + 20 mm}"),
                 A_x) == 0.12);
}

TEST_CASE("formulas keep their dimensions: a ratio of lengths is a number, and no length", "[scenes]") {
  const std::string A_x = "A_x";
  const auto where = [](const std::string& names, const std::string& length,
                        const std::string& drive = "{link: 2, angle: 0 deg}") {
    return four_bar(
        "drive: " + drive + "\ngivens: {r: 100 mm, l: 400 mm, v: 0.5 m/s, n: 60 rpm}\nwhere: {" + names + "}",
        "assembly: {B: left of A B0}", "2: {A0 A: " + length + "}");
  };
  CHECK(value_in(where("k: r/l", "k*l + 20 mm"), A_x) == 0.12);
  CHECK(value_in(where("k: 1 + r/l, q: k*r*l", "q/(5*r)"), A_x) == 0.1);
  CHECK(value_in(where("h: 1/50 m", "h + r"), A_x) == 0.12);
  CHECK(value_in(where("w: v/r", "r", "{link: 2, angle: 0 deg, speed: w + 1 rad/s}"), "omega_2") == 6);
  const auto why = [&](const std::string& names, const std::string& length) { return refusal(where(names, length)); };
  CHECK(why("k: r/l", "k") == "5:13: \"k\" is a pure number where a length is asked");
  CHECK(why("k: r*l", "k") == "5:13: \"k\" is an area where a length is asked");
  CHECK(why("k: r/l", "k + r") == "5:13: in \"k + r\" a pure number and a length are added");
  CHECK(why("k: r*r*r", "k") == "5:13: \"k\" is a number in m^3 where a length is asked");
  CHECK(why("k: n*r", "r").starts_with("10:12: in \"n*r\" degrees or turns stand in a product with units"));
}

TEST_CASE("a group at a dead centre or change point is named, with what is special", "[scenes]") {
  const auto why = [](const std::string& file, const std::vector<std::string>& set) -> std::string {
    const auto exercise = exercise_of(file);
    Givens givens(exercise->about().givens);
    for (const std::string& each : set) givens.set(each);
    try {
      check(*exercise, givens, Rung::climb);
    } catch (const BadGivens& bad) {
      return bad.what();
    }
    return {};
  };
  const std::string end = ": at this dead centre or change point the drive does not determine the motion";
  CHECK(why("parallelogram", {"phi=0deg"}) ==
        "B: A B and B0 B lie in one line, folded, with B0 between" + end + " (links 3 and 4)");
  CHECK(why("parallelogram", {"phi=180deg"}) ==
        "B: A B and B0 B lie in one line, stretched out" + end + " (links 3 and 4)");
  CHECK(why("parallelogram", {"phi=0deg", "r=0.5m"}) ==
        "B: A and B0 lie in one place, and A B is as long as B0 B" + end + " (links 3 and 4)");
  CHECK(why("parallelogram", {"phi=0.001deg"}).empty());
  CHECK(why("trammel", {"a=1m"}) == "B: A B stands square to y" + end + " (link 2)");
  CHECK(why("quick-return", {"O2A=300mm", "theta=-90deg"}) ==
        "A: A is as near to O4 as s lets it come" + end + " (link 4)");
}

TEST_CASE("what a book printed has its verdict; a number of nothing, or in a wrong unit, is refused", "[scenes]") {
  const auto printed = [](const std::string& number, const std::string& quantity = "omega_3") {
    const auto scene = std::make_shared<const scenes::Scene>("f", four_bar() + "printed: [{" + number + "}]\n");
    const auto exercise = scenes::scene_exercise(scene);
    return find(check(*exercise, Givens(scene->givens()), Rung::climb), quantity).printed.at(0);
  };
  const std::string omega_3 = "quantity: omega_3, unit: rad/s, place: page 57, value: ";
  CHECK(printed(omega_3 + "-1.42").verdict == Verdict::rounding);
  CHECK(printed(omega_3 + "1.42").verdict == Verdict::rounding);
  CHECK(printed(omega_3 + "-1.44").verdict == Verdict::disagrees);
  CHECK(printed(omega_3 + "-1.44, reading: 0.03").verdict == Verdict::reading);
  CHECK(printed(omega_3 + "-1.42").route == "page 57");
  // A = (60, 103.9), B 350 mm from it and 280 mm from (400, 0): AB points at 29.76°, B0B at 97.42°.
  const auto direction = [&](const std::string& name, const std::string& value) {
    return printed("quantity: " + name + ", unit: deg, place: p, value: " + value, name).verdict;
  };
  CHECK(direction("theta_3", "29.76") == Verdict::rounding);
  CHECK(direction("theta_3", "29.5, reading: 0.3") == Verdict::reading);
  CHECK(direction("theta_4", "\"-262.58\"") == Verdict::rounding);
  CHECK(direction("theta_4", "457.42") == Verdict::rounding);
  CHECK(direction("theta_4", "98") == Verdict::disagrees);
  CHECK(printed("quantity: theta_3, unit: °, place: p, value: 29.76", "theta_3").verdict == Verdict::rounding);
  const auto why = [&](const std::string& number) -> std::string {
    try {
      printed(number);
    } catch (const scenes::BadScene& bad) {
      return std::string(bad.what()).substr(2);
    }
    return {};
  };
  CHECK(why("quantity: omega_3, unit: mm, place: p, value: 1") == "10:37: omega_3 is told in rad/s, not in mm");
  CHECK(why("quantity: omega_33, unit: rad/s, place: p, value: 1")
            .starts_with("10:22: this mechanism has no quantity \"omega_33\"; did you mean omega_3"));
  CHECK(why("quantity: omega_3, unit: rpm, place: p, value: 1").starts_with("10:37: rpm counts turns"));
  CHECK(why("quantity: theta_3, unit: rad, place: p, value: 0.5") == "10:37: theta_3 is told in deg, not in rad");
  CHECK(why("quantity: omega_3, unit: rad/s, place: p, value: x").starts_with("10:61: "));
  CHECK(why("quantity: omega_3, unit: rad/s, value: 1") == "10:11: place: is missing");
}

TEST_CASE("straight lines are proved: an offset that is zero is exactly so, in every place", "[scenes]") {
  const auto offset = [](const std::string& file, const std::string& set) {
    const auto exercise = exercise_of(file);
    Givens givens(exercise->about().givens);
    givens.set(set);
    const CheckedExercise checked = check(*exercise, givens, Rung::climb);
    CAPTURE(file, set, complaints(checked));
    CHECK(checked.passed());
    return find(checked, "e").settled.enclosure;
  };
  for (const char* theta : {"theta=60deg", "theta=-45deg", "theta=23.4deg"})
    CHECK(offset("peaucellier", theta).upper == 0);
  for (const char* phi : {"phi=35deg", "phi=-70deg"}) CHECK(offset("cardan-circles", phi).upper == 0);
  for (const char* phi : {"phi=35deg", "phi=-70deg", "phi=1.25rad"}) CHECK(offset("cardan-gear", phi).upper == 0);
  CHECK(offset("chebyshev", "theta=45deg").lower > 0);
  CHECK(offset("roberts", "theta=75deg").upper < 0);
}

TEST_CASE("a file that is wrong is refused with its place and a sentence", "[scenes]") {
  const auto begins = [](const std::string& sentence, const std::string& beginning) {
    UNSCOPED_INFO(sentence);
    return sentence.starts_with(beginning);
  };
  CHECK(refusal(four_bar()).empty());
  // The file itself.
  CHECK(refusal("") == " the file is empty");
  CHECK(begins(refusal("epure: 1\nid: f\nid: g\n"), "3:1: \"id\" stands here twice (first in line 2)"));
  CHECK(begins(refusal("epure: 1\nid: &a f\nlinks: *a\n"), "2:5: an anchor"));
  CHECK(begins(refusal("epure: 1\nid: !x f\n"), "2:5: a tag"));
  CHECK(begins(refusal("epure: 1\n---\nepure: 1\n"), "2:1: a second document"));
  CHECK(begins(refusal("epure: 1\n\tid: f\n"), "2:1: a tab"));
  CHECK(begins(refusal(std::string("epure: 1\nid: \0f\n", 17)), "2:5: a control character"));
  CHECK(begins(refusal("epure: 1\nid: \xff\n"), "2:5: these bytes are no text in UTF-8"));
  CHECK(begins(refusal("epure: " + std::string(100, '[') + std::string(100, ']')), "1:19: nested deeper than 12"));
  CHECK(begins(refusal("a: " + std::string(5000, 'x')), "1:4: a text of 5000 characters"));
  CHECK(begins(refusal("a: \"" + std::string(300'000, 'x') + "\""), " the file has 300005 bytes"));
  const auto times = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  CHECK(begins(refusal("a: [" + times(100, "1,") + "]"), "1:165: more than 80 entries in one list"));
  CHECK_THAT(refusal("a: [" + times(40, "[" + times(79, "1,") + "],") + "]"), Contains("more than 2000 entries"));
  // So many that it would take minutes.
  std::string chain = "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n";
  for (int i = 2; i <= 25; ++i) chain += "  " + std::to_string(i) + ": {A" + std::to_string(i) + ": [0, 0]}\n";
  CHECK(begins(refusal(chain), "4:3: 25 links are too many: 24 at most"));
  const auto plate = [](const std::string& letter) {
    std::string points = letter + ": [0, 0]";
    for (int i = 1; i < 70; ++i) points += ", " + letter + std::to_string(i) + "x: [" + std::to_string(i) + ", 0]";
    return "{" + points + "}\n";
  };
  CHECK(begins(refusal("epure: 1\nid: f\nlinks:\n  1: " + plate("B") + "  2: " + plate("C")),
               "4:3: 140 points are too many: 100 at most"));
  std::string letters = "A";
  for (int i = 1; i < 25; ++i) letters += ", A" + std::to_string(i);
  for (const std::string section : {"paths", "polodes", "charts", "extremes"})
    CHECK_THAT(refusal(four_bar() + section + ": [" + letters + "]\n"), Contains("25 are asked for; 24 at most"));
  CHECK_THAT(refusal(four_bar() + "charts: [[" + letters + "]]\n"), Contains("25 are asked for; 24 at most"));
  // All together: two paths, two polodes, 21 charts.
  std::string charts = "v_A";
  for (int i = 1; i < 21; ++i) charts += ", v_A" + std::to_string(i);
  CHECK_THAT(refusal(four_bar() + "paths: [A, B]\npolodes: [3]\ncharts: [" + charts + "]\n"),
             Contains("25 curves over all places of the drive are asked for") &&
                 Contains("a mechanism of 4 links may have 24"));
  CHECK(begins(refusal("epure: 2\nid: f\n"), "1:8: a scene begins with  epure: 1"));
  CHECK(begins(refusal("epure: 1\nid: ../f\n"), "2:5: \"../f\" is no id"));
  CHECK(begins(refusal(four_bar() + "link: 3\n"), "10:1: \"link\" has no meaning here; did you mean links?"));
  // Numbers.
  CHECK(begins(refusal(four_bar("drive: {link: 2, angle: 60 parsec}")), "8:25: \"parsec\" is no unit; known are: m"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}\ngivens: {r: 3 parsec}")), "9:13: \"parsec\" is no unit; known"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}\nunits: {length: parsec}")),
               "9:17: \"parsec\" is no unit of a length; known are: m, "));
  CHECK(begins(refusal(four_bar("drive: {link: 2, angle: 60}")), "8:25: \"60\" has no unit where an angle is asked"));
  CHECK(begins(refusal(four_bar("drive: {link: 2, angle: 60 mm}")), "8:25: \"60 mm\" is a length where an angle"));
  CHECK(begins(refusal(four_bar("drive: {link: 2, angle: 1e20 deg}")),
               "8:25: \"1e20 deg\" must be at most 1e12 turns or radians"));
  CHECK(begins(refusal(four_bar("drive: {link: 2, speed: 1/0}")), "8:25: "));
  CHECK(begins(refusal(four_bar("drive: {link: 2}", "", "2: {A0 A: 0}")), "5:13: the bar A0 A must be longer"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}", "", "2: {A0: [0, 0], A: [0, 0]}")),
               "5:19: A0 and A lie in one place of link 2"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}", "", "2: {A0 A: r}")), "5:13: \"r\" is no given"));
  // Joints.
  CHECK(
      begins(refusal(four_bar("drive: {link: 2}", "")),
             "1:1: B may lie on either side of A -> B0: say under assembly:  B: left of A B0  or  B: right of A B0"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}", "assembly: {B: left of A0 B0}")), "9:11: B may lie"));
  CHECK(
      begins(refusal(four_bar("drive: {link: 2}", "assembly: {B: above A B0}")), "9:15: a side reads: left of A B0"));
  CHECK(begins(refusal(four_bar("drive: {link: 7}")), "8:15: there is no moving link 7"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}\nslides: {A: g}")), "9:13: no link has a line g"));
  CHECK(begins(refusal(four_bar("drive: []")), "5:3: links 2, 3 and 4 are not held: a drive or joint is missing"));
  CHECK(begins(
      refusal(four_bar("drive: {link: 2}", "assembly: {B: left of A B0}", "2: {A0 A: 120 mm}\n  5: {A C: 1 m}")),
      "6:3: link 5 is not held: a drive or joint is missing"));
  CHECK(begins(refusal(four_bar("drive: [{link: 2}, {link: 4}]")),
               "6:3: link 3 hangs on more than it can follow (A and B)"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}", "assembly: {B: left of A B0}",
                                "2: {A0 A: 120 mm}\n  5: {A: [0, 0], B0: [1 m, 0]}")),
               "6:3: link 5 hangs on more than it can follow (A and B0)"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}", "", "2: {A0 A: 120 mm, P23: [1 m, 0]}")),
               "5:3: P23 is the instant centre of links 2 and 3: name the point otherwise"));
}

TEST_CASE("all that is open of a file is told at once, with what to write", "[scenes]") {
  CHECK(refusal("epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], Q: [1 m, 0], g: {along: 0 deg}}\n  2: {O A: 1 m}\n  3: {A "
                "B: 2 m}\n  4: {Q B: 2 m}\n  5: {B C: 3 m}\nslides: {C: g}\ndrive: {link: 2}\nassembly: {}\n") ==
        "11:11: 2 joints may lie in two places each: say under assembly:  B: left of A Q  or  B: right of A Q;  C: "
        "ahead on g  or  C: behind on g");
}

// Two links hinged to each other and to the frame's guide, a cylinder across: a scissor lift.
TEST_CASE("a cylinder within a group is refused with what to write instead", "[scenes]") {
  CHECK(refusal(
            "epure: 1\nid: f\nlinks:\n  1: {A: [0, 0], g: {along: 0 deg}}\n  2: {A: [0, 0], C: [1 m, 0], P: [1/2 m, "
            "0]}\n  3: {B: [0, 0], C: [1 m, 0], Q: [1/2 m, 0]}\nslides: {B: g}\ndrive: {length: P Q, is: 1/2 m}\n") ==
        "5:3: links 2 and 3 move only together, on what stands at A and B: ruler and compass place groups of one or "
        "two links only; the cylinder P Q lies between two of them: drive one by its angle instead, as  drive: "
        "{link: 2, angle: ..., speed: ...}");
}

TEST_CASE("a mechanism that does not close names its joint and what is missing", "[scenes]") {
  const auto why = [](const std::string& text) -> std::string {
    try {
      checked_text(text);
    } catch (const BadGivens& bad) {
      return bad.what();
    }
    return {};
  };
  const std::string steady = "drive: {link: 2, angle: 180 deg}", side = "assembly: {B: left of A B0}";
  CHECK(why(four_bar(steady, side, "2: {A0 A: 300 mm}")) ==
        "the mechanism does not close: B: A B (0.35 m) and B0 B (0.28 m) do not meet, for A B0 is 0.7 m, 0.07 m too "
        "far");
  CHECK(why(four_bar("drive: {link: 2, angle: 0 deg}", side, "2: {A0 A: 350 mm}")) ==
        "the mechanism does not close: B: A B (0.35 m) and B0 B (0.28 m) do not meet, for A B0 is 0.05 m, 0.02 m too "
        "near");
  CHECK(why("epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {through: [0, 1/2 m], along: [1, 0]}}\n  2: {O A: 1/5 m}\n "
            " 3: {A B: 1/4 m}\nslides: {B: g}\ndrive: {link: 2}\nassembly: {B: ahead on g}\n") ==
        "the mechanism does not close: B: A B (0.25 m) does not reach g, which is 0.5 m away from A: 0.25 m are "
        "missing");
}

TEST_CASE("points of different links that lie in one place are told, exactly", "[scenes]") {
  const auto told = [](const std::string& angle, const std::string& more = "", const std::string& assembly = "") {
    const scenes::Scene scene("f",
                              "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], Q: [1 m, 0], R: [1 m, 1 m]}\n  2: {O A: 1 "
                              "m}\n  3: {O B: 2 m}\n" +
                                  more + "drive: [{link: 2, angle: " + angle + "}, {link: 3, angle: 45 deg}]\n" +
                                  assembly);
    return scenes::coincidences(scene.built(Givens(scene.givens())));
  };
  REQUIRE(told("0 deg").size() == 1);
  CHECK(told("0 deg")[0].english == "Q and A lie in one place here. (Where they are a hinge, one letter says so.)");
  const auto with_side = told("0 deg", "  4: {A C: 1 m}\n  5: {R C: 1 m}\n", "assembly: {C: left of A R}\n");
  REQUIRE(with_side.size() == 1);
  CHECK(with_side[0].english.starts_with("Q and A lie in one place: is a side under assembly: wrong?"));
  CHECK(told("1e-12 deg").empty());  // doubles may take them for one
  CHECK(told("90 deg").empty());
}

TEST_CASE("givens may be Greek letters, or their names, and are drawn as letters", "[scenes]") {
  const std::string text = four_bar(
      "drive: {link: 2, angle: φ + θ_1, speed: n}\ngivens: {φ: 20 deg, theta_1: 40 deg, n: 60 rpm, O2A: 1 m}");
  const scenes::Scene scene("f", text);
  std::string symbols, letters;
  for (const GivenSpec& given : scene.givens()) symbols += given.symbol + " ", letters += given.letters + " ";
  CHECK(symbols == "phi theta_1 n O2A ");
  CHECK(letters == "$φ$ $θ_{1}$ $n$ $O_{2}A$ ");
  CHECK(value_in(text, "omega_3") == value_in(four_bar(), "omega_3"));
  CHECK(refusal(four_bar("drive: {link: 2}\ngivens: {phi: 1 deg, φ: 2 deg}")) ==
        "9:22: \"phi\" and \"φ\" are one name");
}

namespace {

std::vector<std::string> sheets_of(const Exercise& exercise) {
  std::vector<std::string> names;
  for (const SheetSpec& sheet : exercise.about().sheets) names.push_back(sheet.name);
  return names;
}

// The steps of a sheet, as plain text.
std::vector<std::string> steps_of(const std::string& scene, const std::string& sheet, Language language) {
  const auto exercise = exercise_of(scene);
  const DrawnSheet drawn = exercise->draw(sheet, Givens(exercise->about().givens), {.language = language});
  return told_steps(drawn);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a scene has polygons group by group, and its instant centres", "[scenes]") {
  CHECK(sheets_of(*exercise_of("four-bar")) == std::vector<std::string>{"velocities", "accelerations",
                                                                        "velocity-polygon", "acceleration-polygon",
                                                                        "acceleration-poles", "instant-centres",
                                                                        "path", "polodes", "chart-omega_3-omega_4"});
  CHECK(sheets_of(*exercise_of("jansen")) ==
        std::vector<std::string>{"velocities", "accelerations", "velocity-polygon-B", "velocity-polygon-D",
                                 "velocity-polygon-E", "acceleration-polygon-B", "acceleration-polygon-D",
                                 "acceleration-polygon-E", "acceleration-poles", "acceleration-poles-2",
                                 "acceleration-poles-3", "acceleration-poles-4", "instant-centres",
                                 "instant-centres-2", "instant-centres-3", "path"});
  CHECK(sheets_of(*exercise_of("excavator")).size() == 9);  // two drives: no centres
}

TEST_CASE("a polygon is told as it is drawn, Coriolis' acceleration subtracted", "[scenes]") {
  const std::vector<std::string> english = steps_of("quick-return", "acceleration-polygon-A", Language::english),
                                 italian = steps_of("quick-return", "acceleration-polygon-A", Language::italian);
  REQUIRE(english.size() == 6);
  REQUIRE(italian.size() == 6);
  CHECK(has(english[1], "is subtracted: its tip lies in a"));
  CHECK(has(english[2], "Through its start the line ∥ s"));
  CHECK(has(english[4], "The two lines meet at a*"));
  CHECK(has(english[5], "lie in line, in the proportion of O"));
  CHECK(has(italian[1], "si sottrae: la sua punta sta in a"));
  CHECK(has(italian[2], "Per la sua origine la retta ∥ s"));
}

// Every number that lies somewhere moves with the frame, on sheets too.
TEST_CASE("a mechanism need not stand in the origin of its frame", "[scenes]") {
  const auto at = [](const std::string& O2, const std::string& O3) {
    return checked_text("epure: 1\nid: f\nlinks:\n  1: {O2: " + O2 + ", O3: " + O3 +
                        "}\n  2: {O2 A: 0.1 m}\n  3: {O3: [0, 0], s: {along: [1, 0]}}\nslides: {A: s}\ndrive: {link: "
                        "2, angle: 150 deg, speed: 60 rpm}\nassembly: {s: from O3 towards A}\n");
  };
  const CheckedExercise here = at("[0, 0]", "[-0.2 m, 0]"), there = at("[0.1 m, 0.05 m]", "[-0.1 m, 0.05 m]"),
                        far = at("[40 m, 0]", "[39.8 m, 0]");
  for (const CheckedExercise* each : {&here, &there, &far}) {
    CAPTURE(complaints(*each));
    CHECK(each->passed());
  }
  CHECK(value(there, "P23_x") == Approx(value(here, "P23_x") + 0.1));
  CHECK(value(there, "P23_y") == Approx(value(here, "P23_y") + 0.05));
  CHECK_FALSE(find(here, "P23_x").on_sheets.empty());
  CHECK_FALSE(find(there, "P23_x").on_sheets.empty());
  CHECK(find(far, "P23_x").on_sheets.empty());  // its origin is not on the sheet
}

TEST_CASE("a point has a path where one drive moves it, and each path its sheet", "[scenes]") {
  const auto scene = [](const std::string& more) {
    return std::make_shared<const scenes::Scene>(
        "f", four_bar("drive: {link: 2, angle: 60 deg, speed: 60 rpm}", "assembly: {B: left of A B0}",
                      "2: {A0 A: 120 mm, Q: [60 mm, 10 mm]}") +
                 more + "\n");
  };
  CHECK(sheets_of(*scenes::scene_exercise(scene("paths: [Q]"))).back() == "path");
  CHECK(sheets_of(*scenes::scene_exercise(scene("paths: [Q, B]"))).back() == "path-B");
  CHECK(sheets_of(*scenes::scene_exercise(scene("paths: []"))).size() == 6);
  const auto why = [&](const std::string& more) -> std::string {
    try {
      scene(more);
    } catch (const scenes::BadScene& bad) {
      return bad.what();
    }
    return {};
  };
  CHECK(why("paths: [B0]") == "f:10:9: B0 is of the frame: it has no path");
  CHECK(why("paths: [Q, Q]") == "f:10:12: Q stands here twice");
  CHECK(why("paths: Q") == "f:10:8: paths: [P, Q], the points whose paths are asked for");
  CHECK(why("paths: [R]").starts_with("f:10:9: no link has a point R"));
  CHECK(refusal("epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O A: 1 m}\n  3: {A B: 1 m}\ndrive: [{link: 2}, "
                "{link: 3}]\npaths: [B]\n") == "8:8: with 2 drives a point has no one path");
  // A point of the crank: its path is the crank's circle, and so is the one that osculates it.
  const auto crank = scene("paths: [Q]");
  const CheckedExercise checked = check(*scenes::scene_exercise(crank), Givens(crank->givens()), Rung::climb);
  CHECK(checked.passed());
  CHECK(value(checked, "rho_Q") == Approx(std::hypot(0.06, 0.01)));
  CHECK(value(checked, "curvature_centre_Q_x") == 0);
}

TEST_CASE("paths are told as they are drawn, also of what slides and of cylinders", "[scenes]") {
  const std::vector<std::string> english = steps_of("chebyshev", "path", Language::english),
                                 italian = steps_of("trammel", "path", Language::italian);
  REQUIRE(english.size() == 4);
  CHECK(has(english[0],
            "The axis of link 2 in the middles of 12 equal parts of the range in which the mechanism closes: the "
            "positions of A."));
  CHECK(has(steps_of("jansen", "path", Language::english).at(0),
            "The axis of link 2 in 12 directions, from +x on: the positions of A."));
  CHECK(has(english[1], "In each B; on tracing paper P goes with link 3 and marks a point."));
  REQUIRE(italian.size() == 4);
  CHECK(has(italian[0], "A in 9 posti su x, fin dove il meccanismo si chiude."));
  // A cylinder lifts a beam: its end goes along a circle, as far as the cylinder lets it.
  const std::string lift =
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], P: [1 m, 0]}\n  2: {O: [0, 0], Q: [1 m, 0], R: [2 m, 0]}\ndrive: "
      "{length: P Q, is: 1 m, speed: 1 m/s}\nassembly: {Q: left of O P}\npaths: [R]\n";
  const auto scene = std::make_shared<const scenes::Scene>("f", lift);
  const auto exercise = scenes::scene_exercise(scene);
  const CheckedExercise checked = check(*exercise, Givens(scene->givens()), Rung::climb);
  CAPTURE(complaints(checked));
  CHECK(checked.passed());
  CHECK(value(checked, "rho_R") == Approx(2));
}

namespace {

std::vector<std::string> steps_with(const std::string& scene, const std::string& more, const std::string& sheet) {
  const auto made =
      std::make_shared<const scenes::Scene>("f", scenes::bytes_of(EPURE_SCENES "/" + scene + ".yaml") + more + "\n");
  const DrawnSheet drawn = scenes::scene_exercise(made)->draw(sheet, Givens(made->givens()), {});
  return told_steps(drawn);
}
int labels_of(const DrawnSheet& drawn, const std::string& letters) {
  const auto& all = drawn.sheet.figure.labels;
  return static_cast<int>(std::count_if(
      all.begin(), all.end(), [&](const drawings::Label& label) { return drawings::plain(label.text) == letters; }));
}

}  // namespace

TEST_CASE("a point of the path is found as its link is: a joint, what is driven, a point of the crank", "[scenes]") {
  CHECK(steps_with("quick-return", "paths: [C, A]", "path-C")[1] == "In each position A, then C.");
  CHECK(steps_with("quick-return", "paths: [C, A]", "path-A")[1] == "The curve through the points: the path of A.");
  CHECK(steps_with("engine", "paths: [S]", "path")[1] == "On tracing paper S goes with link 2 and marks a point.");
}

TEST_CASE("each vector and each link stands on a sheet once, wheels have a step of their own", "[scenes]") {
  const auto four_bar = exercise_of("four-bar"), slider_crank = exercise_of("slider-crank");
  const auto drawn = [](const Exercise& of, const std::string& sheet) {
    return of.draw(sheet, Givens(of.about().givens), {});
  };
  CHECK(labels_of(drawn(*four_bar, "velocity-polygon"), "v_B") == 1);
  CHECK(labels_of(drawn(*four_bar, "acceleration-polygon"), "a_B") == 1);
  CHECK(labels_of(drawn(*slider_crank, "velocities"), "4") == 1);
  CHECK(steps_of("planetary-gear", "instant-centres", Language::english)[0] ==
        "P_13 on OC, where the pitch circles of wheels 1 and 3 touch.");
}

TEST_CASE("what was left out or mistyped is named, with what to write", "[scenes]") {
  const std::string crank =
                        "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {along: [1, 0]}}\n  2: {O A: 0.1 m}\n"
                        "  3: {A B: 0.3 m}\n",
                    drive = "drive: {link: 2, angle: 30 deg}\n";
  CHECK(has(refusal(crank + drive),
            "link 3 is not held: a drive or joint is missing; nothing slides on g: say under slides:  B: g"));
  CHECK(has(refusal(crank + "  4: {B: [0, 0], b: {along: [1, 0]}}\n" + drive), "say under slides:  b: g"));
  CHECK(has(refusal("epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [0.4 m, 0]}\n  2: {A0 A: 0.1 m}\n"
                    "  3: {A C: 0.35 m}\n  4: {B0 B: 0.3 m}\n" +
                    drive),
            "; C (3) and B (4) stand on one link each (its number behind): links hang on each other where they have "
            "the same letter"));
}

// Where a chart's zero lies, and how far apart its numbers, by what a ruler reads of it now.
struct OnChart {
  double x_now, zero, per_mm;
};
OnChart on_chart(const DrawnSheet& drawn, const std::string& quantity) {
  for (const Measurement& each : drawn.measurements)
    if (each.quantity == quantity) return {each.to.x, each.from.y, each.per_mm};
  throw std::logic_error("nothing to read of " + quantity);
}
// The drawn curve there.
double read_off(const DrawnSheet& drawn, const std::string& curve, double x, const OnChart& scale) {
  const drawings::Line drawn_line = line(drawn, curve);
  drawings::Point nearest = drawn_line.path.start;
  for (const auto& piece : drawn_line.path.pieces)
    if (std::abs(piece.end.x - x) < std::abs(nearest.x - x)) nearest = piece.end;
  return (nearest.y - scale.zero) * scale.per_mm;
}

TEST_CASE("a chart shows a quantity in all places of the drive", "[scenes]") {
  const auto drawn_at = [](const std::string& angle) {
    const auto scene = std::make_shared<const scenes::Scene>(
        "f", four_bar("drive: {link: 2, angle: " + angle + ", speed: 60 rpm}") + "charts: [omega_4]\n");
    return scenes::scene_exercise(scene)->draw("chart-omega_4", Givens(scene->givens()), {});
  };
  // ω4 by 40-digit differentiation of the closure in mpmath, at 0°, 90°, 180°, 270°.
  constexpr double omega_4[] = {-2.69279370308, 2.46449658936, 1.44996584012, -1.42690635515};
  const DrawnSheet first = drawn_at("0 deg"), now = drawn_at("90 deg");
  const OnChart at_0 = on_chart(first, "omega_4"), at_90 = on_chart(now, "omega_4");
  constexpr double ruler = 0.02;  // rad/s: a fifth of a millimetre
  for (const int quarter : {0, 1, 2, 3}) {
    const double x = at_0.x_now + quarter * (at_90.x_now - at_0.x_now);
    CAPTURE(quarter);
    CHECK(std::abs(read_off(now, "omega_4", x, at_90) - omega_4[quarter]) < ruler);
  }
  CHECK_FALSE(tells(now, "does not close"));
  // A crank that cannot turn fully: the curve has an end on each side, and the sheet says so.
  const auto rocker = std::make_shared<const scenes::Scene>(
      "f",
      four_bar("drive: {link: 2, angle: 60 deg, speed: 60 rpm}", "assembly: {B: left of A B0}", "2: {A0 A: 300 mm}") +
          "charts: [[omega_3, omega_4], v_B]\n");
  const DrawnSheet both = scenes::scene_exercise(rocker)->draw("chart-omega_3-omega_4", Givens(rocker->givens()), {});
  CHECK(tells(both, "does not close"));
  const auto pieces = line(both, "omega_3").path.pieces.size();
  CHECK(pieces > 100);
  CHECK(pieces < 300);
}

TEST_CASE("the polodes of a trammel are Cardan's circles", "[scenes]") {
  // A and B of a rod of 1 m on two guides that cross in the origin, square to each other: the fixed polode is the
  // circle of 1 m about it, the moving one the circle over AB.
  const std::string trammel =
      "epure: 1\nid: f\nlinks:\n  1: {x: {along: [1, 0]}, y: {along: [0, 1]}}\n  2: {A B: 1 m}\nslides: {A: x, B: "
      "y}\n"
      "drive: {slide: A, on: x, at: 0.6 m, speed: 1 m/s}\nassembly: {B: ahead on y}\npolodes: [2]\n";
  const auto scene = std::make_shared<const scenes::Scene>("f", trammel);
  const DrawnSheet drawn = scenes::scene_exercise(scene)->draw("polodes", Givens(scene->givens()), {});
  Place origin{}, per_mm{};
  for (const Measurement& each : drawn.measurements) {
    if (each.quantity == "P12_x") origin.x = each.from.x, per_mm.x = each.per_mm;
    if (each.quantity == "P12_y") origin.y = each.from.y, per_mm.y = each.per_mm;
  }
  const double pen = 0.05 * per_mm.x;  // m: of a line's width on paper
  REQUIRE(pen > 0);
  const auto distances = [&](const std::string& name, const Place& from) {
    std::vector<double> all;
    for (const drawings::Line& each : all_of<drawings::Line>(drawn))
      if (each.name == name)
        for (const auto& piece : each.path.pieces)
          all.push_back(distance(from, {(piece.end.x - origin.x) * per_mm.x, (piece.end.y - origin.y) * per_mm.y}));
    return all;
  };
  const std::vector<double> fixed = distances("fixed_polode", {0, 0}),
                            moving = distances("moving_polode", {0.3, 0.4});
  CHECK(fixed.size() > 4);
  CHECK(moving.size() > 4);
  for (const double each : fixed) CHECK(std::abs(each - 1) < pen);
  for (const double each : moving) CHECK(std::abs(each - 0.5) < pen);
}

// Attacked: the rim of a wheel that rolls along was traced for as many turns as it makes on the way to infinity.
TEST_CASE("the moving polode of a wheel on a floor is its rim, traced for no more turns than its way is shown",
          "[scenes]") {
  const double radius = 0.002;  // m
  const std::string wheel =
      "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], g: {through: [0, 2 mm], along: [1, 0]}, f: {along: [1, 0]}}\n"
      "  2: {C: [0, 0], P: [20 mm, 5 mm]}\nslides: {C: g}\nrolls: [{wheel: 2, centre: C, on: f, radius: 2 mm}]\n"
      "drive: {slide: C, on: g, at: 300 mm, speed: 0.5 m/s}\npolodes: [2]\n";
  const auto scene = std::make_shared<const scenes::Scene>("f", wheel);
  const DrawnSheet drawn = scenes::scene_exercise(scene)->draw("polodes", Givens(scene->givens()), {});
  double per_mm = 0;
  for (const Measurement& each : drawn.measurements)
    if (each.quantity == "P12_x") per_mm = each.per_mm;
  std::size_t arcs = 0;
  double low = INFINITY, high = -INFINITY;
  for (const drawings::Line& each : all_of<drawings::Line>(drawn))
    if (each.name == "moving_polode")
      for (const auto& piece : each.path.pieces) {
        ++arcs;
        low = std::min(low, piece.end.y);
        high = std::max(high, piece.end.y);
      }
  CHECK(arcs > 20);
  CHECK(arcs < 1000);
  CHECK(std::abs((high - low) * per_mm - 2 * radius) < 0.3 * per_mm);
}

TEST_CASE("polodes are those of a link that neither turns about the frame nor is led along it", "[scenes]") {
  CHECK(refusal(four_bar() + "polodes: [3]\n").empty());
  CHECK(refusal(four_bar() + "polodes: [2]\n") == "10:11: link 2 turns about A0: both of its polodes are that point");
  CHECK(refusal(four_bar() + "polodes: [5]\n") == "10:11: there is no moving link 5");
  CHECK(refusal(four_bar() + "polodes: [1]\n") == "10:11: there is no moving link 1");
  CHECK(refusal(four_bar() + "polodes: [3, 3]\n") == "10:14: 3 stands here twice");
  // Oldham's disc without its point.
  CHECK(refusal("epure: 1\nid: f\nlinks:\n  1: {A: [0, 0], B: [1 m, 0]}\n  2: {A: [0, 0], p: {along: [1, 0]}}\n"
                "  3: {q: {along: [1, 0]}, s: {along: [0, 1]}}\n  4: {B: [0, 0], t: {along: [0, 1]}}\nslides: {q: p, "
                "s: t}\ndrive: {link: 2, angle: 25 deg}\npolodes: [3]\n") ==
        "10:11: link 3 has no point to be drawn by: give it one");
  CHECK(refusal(four_bar() + "polodes: 3\n") == "10:10: polodes: [3], the links whose polodes are asked for");
  const auto ferguson = [](const std::string& teeth) {
    return refusal(
        "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O: [0, 0], C: [0.08, 0], D: [0.16, 0]}\n  3: {C Q: 0.03}\n"
        "  4: {D P: 0.03}\ngears: [{wheels: 1 3, on: 2, teeth: [40, 20]}, {wheels: 3 4, on: 2, teeth: [20, " +
        teeth + "]}]\ndrive: {link: 2, angle: 50 deg}\npolodes: [4]\n");
  };
  CHECK(ferguson("80").empty());
  CHECK(ferguson("40") ==
        "10:10: the gears keep link 4 from turning: its instant centre is at infinity in every place, and it has no "
        "polodes");
}

TEST_CASE("what a chart is asked for is one unit, and there", "[scenes]") {
  const auto why = [](const std::string& asked) -> std::string {
    try {
      scenes::scene_exercise(std::make_shared<const scenes::Scene>("f", four_bar() + asked));
    } catch (const scenes::BadScene& bad) {
      return bad.what();
    }
    return {};
  };
  CHECK(why("charts: [omega_4, [v_A, v_B]]").empty());
  CHECK(why("charts: [omega_5]").starts_with("f:10:10: this mechanism has no quantity \"omega_5\"; did you mean"));
  CHECK(why("charts: [[omega_4, v_B]]")
            .starts_with("f:10:10: one chart has one unit, and v_B is in m/s, not in rad/s"));
  // One that does not close says that when it is solved: other givens may close it.
  const auto open = [] {
    const auto scene = std::make_shared<const scenes::Scene>(
        "f", four_bar("drive: {link: 2, angle: 60 deg}", "assembly: {B: left of A B0}", "2: {A0 A: 9 m}") +
                 "charts: [omega_4]\n");
    const auto exercise = scenes::scene_exercise(scene);
    check(*exercise, Givens(exercise->about().givens), Rung::climb);
  };
  CHECK_THROWS_WITH(open(), Contains("the mechanism does not close: B:"));
  CHECK(why("charts: [v_B, v_B]") == "f:10:15: this chart stands here twice");
  CHECK(why("charts: [[v_B, v_B]]") == "f:10:10: v_B stands here twice");
  CHECK(why("charts: omega_4").starts_with("f:10:9: charts: [omega_4, [v_B, v_C]]"));
  CHECK(refusal("epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O A: 1 m}\n  3: {A B: 1 m}\ndrive: [{link: 2}, "
                "{link: 3}]\ncharts: [v_B]\n") == "8:9: with 2 drives there is no one way to chart over");
}

TEST_CASE("gears are told by wheels, carrier and teeth; what cannot mesh is refused", "[scenes]") {
  const auto gears = [](const std::string& gear, const std::string& drive = "{link: 2, angle: 20 deg}") {
    return "epure: 1\nid: f\ngivens: {z: 30, r: 20 mm}\nlinks:\n  1: {O: [0, 0], Q: [90 mm, 0]}\n  2: {O A: 30 mm}\n "
           " 3: {Q B: 30 mm}\ngears: [{" +
           gear + "}]\ndrive: " + drive + "\n";
  };
  const auto omega_3 = [&](const std::string& gear) {
    return value_in(gears(gear, "{link: 2, angle: 20 deg, speed: 6 rad/s}"), "omega_3");
  };
  CHECK(omega_3("wheels: 2 3, on: 1, teeth: [z, 2*z]") == -3);
  CHECK(omega_3("wheels: 3 2, on: 1, teeth: [z, 2*z]") == -12);
  CHECK(omega_3("wheels: 2 3, on: 1, teeth: [r, 3*r], inside: yes") == 2);
  CHECK(omega_3("wheels: 2 3, on: 1, teeth: [z, 2*z], inside: no, phase: 40 deg") == -3);
  CHECK(value_in(gears("wheels: 2 3, on: 1, teeth: [z, z], phase: 20 deg"), "B_y") == 0);
  const auto why = [&](const std::string& gear) { return refusal(gears(gear)); };
  CHECK(why("wheels: 2, on: 1, teeth: [z, z]") == "8:18: two links mesh, as in  wheels: 2 4");
  CHECK(why("wheels: 2 7, on: 1, teeth: [z, z]") == "8:18: there is no link 7");
  CHECK(why("wheels: 2 3, on: 2, teeth: [z, z]") ==
        "8:18: two wheels and the link that carries them are three links");
  CHECK(why("wheels: 1 3, on: 2, teeth: [z, z]").starts_with("8:27: links 3 and 2 have no hinge"));
  CHECK(why("wheels: 2 3, on: 1, teeth: [z, z], inside: yes").starts_with("8:37: of two wheels as large"));
  CHECK(why("wheels: 2 3, on: 1, teeth: [z, 0]") == "8:41: a wheel has more than no teeth");
  CHECK(why("wheels: 2 3, on: 1, teeth: [z, 20.5]") ==
        "8:41: a wheel has a whole number of teeth; radii have a unit, such as 20.5 mm");
  CHECK(why("wheels: 2 3, on: 1, teeth: [z, r]").starts_with("8:41: \"r\" is a length where a pure number"));
  CHECK(why("wheels: 2 3, on: 1, teeth: z") ==
        "8:37: two numbers of teeth are asked, such as [20, 40], or two radii");
  CHECK(why("wheels: 2 3, on: 1, teeth: [z, z], inside: perhaps") == "8:53: inside: yes or no");
  CHECK(why("wheels: 2 3, on: 1, tooth: [z, z]").starts_with("8:30: \"tooth\" has no meaning here"));
  CHECK(refusal(gears("wheels: 2 3, on: 1, teeth: [31, 37]") + "paths: [B]\n") ==
        "10:8: the gears come back to where they were after more than 12 turns of the drive only");
  CHECK(refusal(gears("wheels: 2 3, on: 1, teeth: [2020, 20]") + "paths: [B]\n") ==
        "10:8: a wheel turns more than 100 times before the gears come back to where they were");
  CHECK(refusal(gears("wheels: 2 3, on: 1, teeth: [2000, 20]") + "paths: [B]\n").empty());
}

TEST_CASE("a side names what the links hang on", "[scenes]") {
  const auto lever = [](const std::string& side) {
    return refusal(
        "epure: 1\nid: f\nlinks:\n  1: {O2: [0, 0], O3: [-0.2 m, 0]}\n  2: {O2 A: 0.1 m}\n  3: {O3: [0, 0], s: "
        "{along: [1, 0]}}\nslides: {A: s}\ndrive: {link: 2, angle: 150 deg}\nassembly: {s: " +
        side + "}\n");
  };
  CHECK(lever("from O3 towards A").empty());
  CHECK(lever("from O3 away from A").empty());
  const std::string open =
      ": s may point from O3 towards A or away: say under assembly:  s: from O3 towards A  or  s: from O3 away from "
      "A";
  CHECK(lever("from O2 towards A") == "9:11" + open);
  CHECK(lever("from O3 towards O2") == "9:11" + open);
  CHECK(lever("from O3 towards X").starts_with("9:15: no link has a point X"));
}

TEST_CASE("a file chooses among its sheets", "[scenes]") {
  const auto sheets = [](const std::string& asked) {
    return sheets_of(*scenes::scene_exercise(std::make_shared<const scenes::Scene>("f", four_bar() + asked)));
  };
  CHECK(sheets("sheets: [instant-centres, velocities]") == std::vector<std::string>{"instant-centres", "velocities"});
  const auto why = [&](const std::string& asked) -> std::string {
    try {
      sheets(asked);
    } catch (const scenes::BadScene& bad) {
      return bad.what();
    }
    return {};
  };
  CHECK(why("sheets: [velocity]") ==
        "f:10:10: this mechanism has no sheet \"velocity\"; did you mean velocity-polygon or velocities?");
  CHECK(why("sheets: [velocities, velocities]") == "f:10:22: the sheet \"velocities\" stands here twice");
  CHECK(why("sheets: []") == "f:10:9: no sheet is asked for");
}

TEST_CASE("a file that may not be looked at is not said to be missing", "[scenes]") {
  CHECK_THROWS_WITH(scenes::bytes_of("no/such/file.yaml"), Contains("there is no such file"));
  CHECK_THROWS_WITH(scenes::bytes_of(std::string(300, 'x') + ".yaml"),
                    Contains("cannot be read"));  // too long a name
}

TEST_CASE("what is odd of a scene is said beside what was asked; a wrong sheet in the name of the file", "[scenes]") {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "epure-test-coincidence.yaml";
  std::ofstream(file)
      << "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], Q: [1 m, 0], R: [1 m, 1 m]}\n  2: {O A: 1 m}\n  3: {O B: 2 "
         "m}\ndrive: [{link: 2, angle: 0 deg, speed: 1 rad/s}, {link: 3, angle: 45 deg}]\n";
  const auto said = [&](const std::vector<std::string>& arguments) {
    std::ostringstream out, err;
    const int exit = run_cli(catalogue(), arguments, out, err);
    return std::to_string(exit) + " " + err.str();
  };
  CHECK(said({"check", file}) ==
        "0 epure: f: Q and A lie in one place here. (Where they are a hinge, one letter says so.)\n");
  CHECK(said({"draw", file.string() + "/velocity"}) ==
        "2 epure: " + file.string() + " has no sheet \"velocity\"; did you mean velocities?\n");
  std::filesystem::remove(file);
}

TEST_CASE("list has no heading of givens for a mechanism without any", "[scenes]") {
  const auto listed = [](const std::string& file) {
    std::ostringstream out, err;
    run_cli(catalogue(), {"list", file}, out, err);
    return out.str();
  };
  const auto file = std::filesystem::temp_directory_path() / "epure_test_without_givens.yaml";
  std::ofstream(file)
      << "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0]}\n  2: {O A: 1 m}\ndrive: {link: 2, angle: 40 deg, "
         "speed: 1 rad/s}\n";
  CHECK(listed(file).find("Quantities") != std::string::npos);
  CHECK(listed(file).find("Givens") == std::string::npos);
  std::filesystem::remove(file);
  CHECK(listed(EPURE_SCENES "/four-bar.yaml").find("Givens") != std::string::npos);
}

// No enclosure proves that a link does not turn; what was constructed, put into the equations of all joints, does.
TEST_CASE("a link that only translates has its centre at infinity by every route, whatever turns it", "[scenes]") {
  for (const char* drive : {"{link: 2, angle: 50 deg, speed: 30 rpm}", "{link: 2, angle: 23.4 deg, speed: 2 rad/s}",
                            "{link: 2, angle: 1/3 rad, speed: 30 rpm, acceleration: 2 rad/s^2}"}) {
    const std::string text =
        "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0], B0: [1/2 m, 0]}\n  2: {A0 A: 1/5 m}\n  3: {A B: 1/2 m}\n  4: {B0 "
        "B: 1/5 m}\nassembly: {B: left of A B0}\ndrive: " +
        std::string(drive) + "\n";
    const CheckedExercise checked = checked_text(text);
    CAPTURE(drive, complaints(checked));
    CHECK(checked.passed());
    CHECK(find(checked, "omega_3").settled.enclosure.upper == 0);
    CHECK(find(checked, "alpha_3").settled.enclosure.upper == 0);
    for (const char* centre : {"P13_x", "P24_y"})
      for (const RouteValue& route : find(checked, centre).routes)
        CHECK(route.settled.kind == geometry::Settled::Kind::absent);
    CHECK(find(checked, "P13_x").settled.reason.english ==
          "it is at infinity, square to the velocity of A: link 3 does not turn");
  }
}

// On which side of -x a link lies decides whether its angle is near 180 or near -180 degrees.
TEST_CASE("links that miss 180 degrees by little have one angle by both routes", "[scenes]") {
  const auto passing = [](const std::string& links, const std::string& angle, const std::string& side) {
    const std::string text = "epure: 1\nid: f\nlinks:\n" + links + "drive: {link: 2, angle: " + angle +
                             ", speed: 10 rpm}\nassembly: {B: " + side + " of A B0}\n";
    const CheckedExercise checked = checked_text(text);
    CAPTURE(text, complaints(checked));
    CHECK(checked.passed());
    return checked;
  };
  const std::string kite =
      "  1: {A0: [0, 0], B0: [0.0001, 0]}\n  2: {A0 A: 0.0001}\n  3: {A B: 0.00035}\n  4: {B0 B: 0.00035}\n";
  for (const char* angle :
       {"0.00000000000000001 deg", "-0.00000000000000001 deg", "0.00000000000000000000000000001 deg"})
    for (const char* side : {"right", "left"}) passing(kite, angle, side);
  const auto rhomboid = [](const std::string& AB) {
    return "  1: {A0: [0, 0], B0: [0.63, 0]}\n  2: {A0 A: 0.39}\n  3: {A B: " + AB + "}\n  4: {B0 B: 0.63}\n";
  };
  const double beyond = value(passing(rhomboid("0.39000000000000000001"), "135 deg", "right"), "theta_4"),
               before = value(passing(rhomboid("0.38999999999999999999"), "135 deg", "right"), "theta_4"),
               along = value(passing(rhomboid("0.39"), "135 deg", "right"), "theta_4");
  CHECK(std::abs(along) == 180);
  CHECK(std::abs(beyond) == 180);
  CHECK(std::abs(before) == 180);
}

TEST_CASE("a block alone on its guide has no extent, and is drawn all the same", "[scenes]") {
  passes(
      "epure: 1\nid: f\nlinks:\n  1: {e: {through: [400 mm, 300 mm], along: 90 deg}}\n  2: {F: [0, 0], f: {through: "
      "[0, 0], along: 0 deg}}\nslides: {f: e}\ndrive: {slide: F, on: e, at: 118 mm, speed: -20 cm/s}\n");
}

TEST_CASE("where a rocker rests its point has no curvature, though its hinge is known", "[scenes]") {
  const CheckedExercise dead = checked_text(R"yaml(epure: 1
id: f
points: {A0: [0, 0], B0: [0.6, 0], A: [0.12, 0.16], B: [0.3, 0.4]}
links:
  1: A0 B0
  2: A0 A
  3: A B
  4: B0 B
drive: {link: 2, speed: 10 rpm}
paths: [B]
)yaml");
  CAPTURE(complaints(dead));
  CHECK(dead.passed());
  for (const std::string name : {"curvature_centre_B_x", "curvature_centre_B_y"})
    for (const RouteValue& route : find(dead, name).routes)
      CHECK(route.settled.kind == geometry::Settled::Kind::absent);
}

TEST_CASE("charts begin where a cylinder has no length", "[scenes]") {
  passes(R"yaml(epure: 1
id: f
links:
  1: {O: [0, 0], g: {along: [1, 0]}}
  2: {B: [0, 0], b: {along: [1, 0]}}
slides: {b: g}
drive: {length: O B, is: 300 mm, speed: 0.1 m/s}
assembly: {B: ahead on g}
charts: [B_x, v_B_x]
)yaml");
}

// Two links that turn alike, or lie in each other, whatever numbers say of them.
TEST_CASE("what hangs on one body is a part of it, and a block turns as its guide", "[scenes]") {
  const auto absent_by_every_route = [](const CheckedExercise& checked, const std::string& quantity) {
    for (const RouteValue& route : find(checked, quantity).routes)
      CHECK(route.settled.kind == geometry::Settled::Kind::absent);
    return find(checked, quantity).settled.reason.english;
  };
  const auto passing = [](const std::string& text) {
    CheckedExercise checked = checked_text(text);
    CAPTURE(complaints(checked));
    CHECK(checked.passed());
    CHECK(checked.undecided.empty());
    return checked;
  };
  // Link 3 hinged where the crank is, its pin in the crank's slot; 4 a block on the crank, its pin in a slot of 3.
  const CheckedExercise one_body = passing(R"yaml(epure: 1
id: f
givens: {p0: 211.6 mm, p1: 0.1302 m, p2: 0.1785 m, theta: 30 deg}
links:
  1: {X: [0, 0]}
  2: {X: [0, 0], Y: [250 mm, 0], e: {through: [371.4 mm, -156.7 mm], along: -152 deg}, f: {through: [-166.5 mm, p0], along: -104 deg}}
  3: {X: [0, 0], W: [400 mm, 0], g: {through: [-235.7 mm, p1], along: 40 deg}}
  4: {Z: [0, 0], B: [10.32 cm, p2], h: {through: [0, 0], along: 0 deg}}
slides: {W: e, h: f, Z: g}
drive: {link: 2, angle: theta, speed: 60 rpm, acceleration: -7 rad/s^2}
assembly: {W: behind on e}
)yaml");
  CHECK(absent_by_every_route(one_body, "P34_x") == "links 3 and 4 do not move against each other");
  // 5 and 6 are blocks on 2.
  const CheckedExercise blocks = passing(R"yaml(epure: 1
id: f
givens: {p0: 39.14 cm, p1: 36.52 cm, p2: 284.9 mm, p3: 41.14 cm, p4: 0.2545 m, p5: 360 mm, p6: 0.35 m, p7: 558.7 mm}
links:
  1: {A: [5 cm, 400 mm], e: {through: [300 mm, 50 mm], along: 90 deg}, f: {through: [0.5853 m, p0], along: 180 deg}}
  2: {E: [0, 0], D: [340 mm, 0], S: [-0.3712 m, -p1], B: [-p2, 411.1 mm], g: {through: [-p3, -32.2 mm], along: 14 deg}, j: {through: [p4, 4.84 cm], along: 0 deg}}
  3: {A: [0, 0], Q: [p5, 0], h: {through: [638.7 mm, -130.5 mm], along: 90 deg}}
  4: {B: [0, 0], Q: [p6, 0], k: {through: [p7, 332.3 mm], along: 79 deg}}
  5: {H: [0, 0], V: [0.5462 m, 40.51 cm], i: {through: [0, 0], along: 0 deg}}
  6: {X: [0, 0], J: [-1025.1 mm, 0.2814 m], l: {through: [0, 0], along: 0 deg}}
slides: {E: e, D: f, i: g, H: h, l: j, X: k}
drive: {slide: E, on: e, at: 6.1 cm, speed: -20 cm/s, acceleration: 2 m/s^2}
assembly: {D: behind on f, Q: left of A B}
)yaml");
  CHECK(absent_by_every_route(blocks, "P56_x") == "it is at infinity: links 5 and 6 turn alike");
  // 6 is a block on 5, and 5 one on 4.
  const CheckedExercise chain = passing(R"yaml(epure: 1
id: f
givens: {p0: 316.017 mm, p1: 115.596 mm, p2: 0.2326 m, p3: 469.3 mm, p4: 0.215133 m, p5: 0.653144 m, theta: -101.6 deg}
links:
  1: {M: [0, 0], Z: [0.457286 m, p0], e: {through: [-7.436 mm, p1], along: 90 deg}}
  2: {M: [0, 0], V: [p2, 0], X: [-24.5142 cm, 357.014 mm]}
  3: {X: [0, 0], D: [p3, 0], H: [117.806 mm, -0.105514 m]}
  4: {M: [0, 0], f: {through: [0, 0], along: 0 deg}, i: {through: [-6.5609 cm, 0.267011 m], along: -152 deg}}
  5: {H: [0, 0], U: [-227.628 mm, -0.24343 m], g: {through: [0, 0], along: 0 deg}, h: {through: [-381.823 mm, 267.011 mm], along: 68 deg}}
  6: {W: [0, 0], R: [-p4, -p5], j: {through: [0, 0], along: 0 deg}}
slides: {D: e, g: f, j: h, W: i}
drive: {link: 2, angle: theta, speed: -3 rad/s}
assembly: {D: behind on e, f: from M towards H}
)yaml");
  CHECK(absent_by_every_route(chain, "P46_y") == "it is at infinity: links 4 and 6 turn alike");
  // 3 and 4 are held by the frame, on which 8 slides.
  const CheckedExercise held = passing(R"yaml(epure: 1
id: f
givens: {p0: 297.002 mm, p1: 123.638 mm, p2: 198.342 mm, p3: 28.2452 cm, p4: 0.50406 m, p5: 99.594 mm, p6: 0.445357 m, p7: 0.016517 m, theta: 174 deg}
links:
  1: {T: [0, 0], M: [-4.496 mm, 95.756 mm], h: {through: [-p0, -p1], along: 90 deg}, j: {through: [p2, 228.652 mm], along: 0 deg}}
  2: {T: [0, 0], X: [0.2398 m, 0], g: {through: [p3, 154.006 mm], along: -50 deg}}
  3: {M: [0, 0], e: {through: [0, 0], along: 0 deg}}
  4: {T: [0, 0], E: [-6.0824 cm, -0.116318 m], A: [-488.881 mm, 147.146 mm], f: {through: [0, 0], along: 0 deg}}
  5: {W: [0, 0], J: [-0.210583 m, -0.462226 m], i: {through: [0, 0], along: 0 deg}}
  6: {A: [0, 0], V: [0.1422 m, 0]}
  7: {J: [0, 0], V: [537.9 mm, 0], S: [-3.733 cm, p4], F: [41.1569 cm, 312.14 mm]}
  8: {G: [-491.203 mm, p5], k: {through: [0, 0], along: 0 deg}, l: {through: [-p6, -p7], along: 51 deg}}
slides: {f: e, i: g, W: h, k: j, F: l}
drive: {link: 2, angle: theta, speed: 30 rpm, acceleration: -7 rad/s^2}
assembly: {e: from M towards T, V: right of A J}
)yaml");
  CHECK(absent_by_every_route(held, "P38_x") == "it is at infinity: links 3 and 8 turn alike");
}

// A report draws each sheet at several sizes, a class each variant: the curve is found once.
TEST_CASE("a chart's curve is found once for the same givens, and anew for others", "[scenes]") {
  const auto scene = std::make_shared<const scenes::Scene>(
      "f",
      "epure: 1\nid: f\ngivens: {r: 0.2 m}\nlinks:\n  1: {A0: [0, 0], B0: [0.4, 0]}\n  2: {A0 A: r}\n  3: {A B: "
      "0.5 m}\n  4: {B0 B: 0.45 m}\nassembly: {B: left of A B0}\ndrive: {link: 2, angle: 60 deg, speed: 60 "
      "rpm}\ncharts: [omega_4]\n");
  const auto exercise = scenes::scene_exercise(scene);
  const auto drawn = [&](const std::string& radius) {
    Givens givens(scene->givens());
    givens.set("r=" + radius);
    return exercise->solution(givens);
  };
  const Solution stated = drawn("0.2"), other = drawn("0.1");
  const auto curve = [&](const Solution& solution) {
    const std::clock_t begin = std::clock();
    const auto drawn_line = line(exercise->draw("chart-omega_4", solution, {}), "omega_4");
    return std::pair(drawn_line.path.pieces.back().end.y - drawn_line.path.pieces[90].end.y, std::clock() - begin);
  };
  const auto [first, time_of_first] = curve(stated);
  const auto [again, time_again] = curve(stated);
  const auto [of_other, time_of_other] = curve(other);
  CHECK(again == first);
  CHECK(of_other != first);
  CHECK(time_again < time_of_first / 3);
  CHECK(curve(stated).first == first);
}

TEST_CASE("a chart of a direction parts where it goes over the end of its turn", "[scenes]") {
  const auto scene = std::make_shared<const scenes::Scene>("f", four_bar() + "charts: [theta_2]\n");
  const DrawnSheet drawn = scenes::scene_exercise(scene)->draw("chart-theta_2", Givens(scene->givens()), {});
  std::vector<double> lowest, highest;  // of each piece of the curve, in mm
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->name.starts_with("theta_2")) {
      auto low = line->path.start.y, high = low;
      for (const drawings::Piece& piece : line->path.pieces)
        low = std::min(low, piece.end.y), high = std::max(high, piece.end.y);
      lowest.push_back(low);
      highest.push_back(high);
    }
  REQUIRE(lowest.size() == 2);
  CHECK(highest[1] < lowest[0] + 1);  // from 0 to 180, from -180 to 0
}
