// Mechanisms from files: those of docs/scenes hold against values made apart; files that are wrong are refused with
// their place and a sentence; the format says what it says.
#include <filesystem>
#include <fstream>

#include "exercises/scenes/scene.h"
#include "exercises/scenes/scene_exercise.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

std::string scene_file(const std::string& name) { return EPURE_SCENES "/" + name + ".yaml"; }

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

double value_in(const std::string& text, const std::string& quantity) {
  const auto scene = std::make_shared<const scenes::Scene>("f", text);
  return value(check(*scenes::scene_exercise(scene), Givens(scene->givens()), Rung::climb), quantity);
}

}  // namespace

TEST_CASE("every scene of the docs holds against the corpus, to the last bit, by both routes", "[scenes]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/linkages.txt");
  CHECK(corpus.size() == 9);
  for (const CorpusCase& c : corpus) {
    const auto exercise = scenes::scene_exercise(scene_file(c.name));
    const CheckedExercise checked = check(*exercise, Givens(exercise->about().givens), Rung::climb);
    CAPTURE(c.name, complaints(checked));
    CHECK(checked.passed());
    for (const CheckedQuantity& quantity : checked.quantities) {
      const std::string reference = c.reference(quantity.spec.name);
      CAPTURE(quantity.spec.name, reference);
      REQUIRE_FALSE(reference.empty());
      is_the_reference(quantity, reference);
    }
  }
}

TEST_CASE("a scene's sheets find room for their letters", "[scenes]") {
  for (const auto& entry : std::filesystem::directory_iterator(EPURE_SCENES)) {
    const auto exercise = scenes::scene_exercise(entry.path());
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
  CHECK(begins(refusal("a: [" +
                       std::string(60'000, ',')
                           .replace(0, 60'000,
                                    [] {
                                      std::string many;
                                      for (int i = 0; i < 30'000; ++i) many += "1,";
                                      return many;
                                    }()) +
                       "]"),
               "1:39999: more than 20000 entries"));
  CHECK(begins(refusal("epure: 2\nid: f\n"), "1:8: a scene begins with  epure: 1"));
  CHECK(begins(refusal("epure: 1\nid: ../f\n"), "2:5: \"../f\" is no id"));
  CHECK(begins(refusal(four_bar() + "link: 3\n"), "10:1: \"link\" has no meaning here; did you mean links?"));
  // Numbers.
  CHECK(begins(refusal(four_bar("drive: {link: 2, angle: 60 parsec}")), "8:25: \"parsec\" is no unit"));
  CHECK(begins(refusal(four_bar("drive: {link: 2, angle: 60}")), "8:25: \"60\" has no unit where an angle is asked"));
  CHECK(begins(refusal(four_bar("drive: {link: 2, angle: 60 mm}")), "8:25: \"60 mm\" is a length where an angle"));
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
  CHECK(begins(refusal(four_bar("drive: []")), "8:8: links 2, 3, 4 are not held: 1 more"));
  CHECK(begins(refusal(four_bar("drive: [{link: 2}, {link: 4}]")), "4:3: link 3 hangs on more"));
  CHECK(begins(refusal(four_bar("drive: {link: 2}", "assembly: {B: left of A B0}",
                                "2: {A0 A: 120 mm}\n  5: {A: [0, 0], B0: [1 m, 0]}")),
               "4:3: link 5 hangs on more than it can follow"));
}
