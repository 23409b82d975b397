// rolls: wheels that roll on lines of other links, held against values made apart (make_rolling.py); what it cannot
// be asked of is refused.
#include "exercises/scenes/file/file_head.h"
#include "tests/exercises/scenes/said.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::string ground_links =
    "links:\n  1: {O: [0, 0], g: {along: [1, 0]}, c: {through: [0, 50 mm], along: [1, 0]}}\n"
    "  2: {C: [0, 0], P: [30 mm, 0]}\n";
const std::string on_the_ground = "epure: 1\nid: f\n" + ground_links +
                                  "slides: {C: c}\nrolls: [{wheel: 2, centre: C, on: g, radius: 50 mm}]\n"
                                  "drive: {slide: C, on: c, at: 70 mm, speed: 0.3 m/s, acceleration: 0.5 m/s^2}\n";

const std::map<std::string, std::string>& cases_of_rolling() {
  static const std::map<std::string, std::string> all{
      {"rack-and-pinion",
       "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], C: [330 mm, 40 mm], g: {along: [1, 0]}}\n  2: {O A: 60 mm}\n"
       "  3: {A B: 200 mm}\n  4: {B: [0, 0], p: {along: [1, 0]}}\n  5: {C: [0, 0]}\nslides: {p: g}\n"
       "rolls: [{wheel: 5, centre: C, on: p, radius: 40 mm}]\ndrive: {link: 2, angle: 60 deg, speed: 60 rpm}\n"
       "assembly: {B: ahead on g}\n"},
      {"on-the-ground", on_the_ground},
      {"with-a-rod",
       "epure: 1\nid: f\n" + ground_links +
           "  3: {P Q: 200 mm}\nslides: {C: c, Q: g}\nrolls: [{wheel: 2, centre: C, on: g, radius: 50 mm}]\n"
           "drive: {slide: C, on: c, at: 70 mm, speed: 0.3 m/s}\nassembly: {Q: ahead on g}\n"},
      {"on-a-lever",
       "epure: 1\nid: f\nlinks:\n  1: {O: [0, 0], Q: [0, 300 mm]}\n"
       "  2: {O: [0, 0], g: {along: [1, 0]}, c: {through: [0, -20 mm], along: [1, 0]}}\n  3: {Q C: 120 mm}\n"
       "  4: {C: [0, 0]}\nslides: {C: c}\n"
       "rolls: [{wheel: 4, centre: C, on: g, radius: 20 mm, at: 100 mm, phase: 15 deg}]\n"
       "drive: {link: 3, angle: 40 deg, speed: 30 rpm}\nassembly: {c: from O towards C}\n"}};
  return all;
}

std::string with_words(std::string text, const std::string& old, const std::string& other) {
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), other);
}
std::string refused_rolling(const std::string& text) {
  try {
    checked_text(text);
  } catch (const scenes::BadScene& bad) {
    return bad.what();
  }
  return {};
}

}  // namespace

TEST_CASE("wheels that roll on lines hold against the corpus, to the last bit, by both routes", "[scenes]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/rolling.txt");
  CHECK(corpus.size() == cases_of_rolling().size());
  for (const CorpusCase& c : corpus) {
    const CheckedExercise found = checked_text(cases_of_rolling().at(c.name));
    CAPTURE(c.name, complaints(found));
    CHECK(found.passed());
    CHECK(found.undecided.empty());
    for (const auto& [name, reference] : c.references) {
      CAPTURE(name, reference);
      is_the_reference(find(found, name), reference);
    }
  }
}

TEST_CASE("a wheel rolls about where it touches", "[scenes]") {
  const CheckedExercise found = checked_text(cases_of_rolling().at("rack-and-pinion"));
  CHECK(value(found, "P45_x") == 0.33);
  CHECK(value(found, "P45_y") == 0);
  CHECK(find(found, "P45_x").routes.size() == 3);
  const auto exercise = exercise_said(cases_of_rolling().at("rack-and-pinion"));
  std::string words;
  for (const SheetSpec& sheet : exercise->about().sheets)
    words += words_of(exercise->draw(sheet.name, Givens(exercise->about().givens), {}));
  CHECK_THAT(words, Contains("$P_{45}$ where wheel 5 touches $p$: at the foot of $C$."));
}

TEST_CASE("what cannot roll is refused, and told how it could", "[scenes]") {
  const auto radius = [](const std::string& r) { return with_words(on_the_ground, "radius: 50 mm", "radius: " + r); };
  CHECK_THAT(refused_rolling(radius("40 mm")), Contains("C is kept 0.05 m from g, and the radius is 0.04 m"));
  CHECK_THAT(refused_rolling(radius("0 mm")), Contains("a wheel has a radius above zero"));
  CHECK_THAT(refused_rolling(with_words(on_the_ground, "c: {through: [0, 50 mm], along: [1, 0]}",
                                        "c: {through: [0, 50 mm], along: [1, 1/10]}")),
             Contains("nothing keeps C beside g: let it slide on a line of the same link, parallel to g"));
  CHECK_THAT(refused_rolling(with_words(on_the_ground, "centre: C", "centre: O")),
             Contains("O is no point of link 2: a wheel turns about its centre"));
  CHECK_THAT(refused_rolling(with_words(on_the_ground, "wheel: 2", "wheel: 1")), Contains("no moving link 1"));
  CHECK_THAT(refused_rolling(on_the_ground + "loads: [{at: P, force: 2 N, direction: 0 deg}]\n"),
             Contains("forces where a wheel rolls are not found yet: leave out loads or rolls"));
  // Driven by its own angle.
  CHECK_THAT(refused_rolling(with_words(
                 on_the_ground, "drive: {slide: C, on: c, at: 70 mm, speed: 0.3 m/s, acceleration: 0.5 m/s^2}",
                 "drive: {link: 2, angle: 30 deg, speed: 10 rpm}")),
             Contains("a wheel follows what it rolls on: drive its centre, or the rack"));
}

// The crank's angle is no number there, but its sine and cosine are.
TEST_CASE("where the crank's dead centres let the rack rest, both routes have it that nothing moves", "[scenes]") {
  const std::string text = scenes::bytes_of(EPURE_SCENES "/rack-pinion.yaml");
  for (const char* place : {"0", "180deg", "-180deg", "360deg", "540deg"}) {
    const CheckedExercise result = checked_text(text, {std::string("phi=") + place});
    CAPTURE(place, complaints(result));
    CHECK(result.passed());
    CHECK(result.undecided.empty());
    CHECK(value(result, "omega_5") == 0);
    // The pinion touches the rack then too, and where it does stays their centre.
    CHECK(value(result, "P45_x") == 0.33);
    CHECK(value(result, "P45_y") == 0);
    CHECK(find(result, "P45_x").routes.size() == 3);
  }
}
