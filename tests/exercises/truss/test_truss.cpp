// Trusses: both routes hold against a corpus of all shapes; zero bars hit, and missed by 1e-9 and 1e-30; what is
// refused; and what a ruler reads off the plan.
#include "tests/exercises/held_against_corpus.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& truss() {
  static const Tried tried("truss");
  return tried;
}

const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/truss.txt");
  return cases;
}

std::string refusal(const Assignments& assignments) {
  try {
    truss().checked(assignments);
  } catch (const BadGivens& refused) {
    return refused.what();
  }
  return {};
}

geometry::Settled settled(const Assignments& assignments, const std::string& name) {
  return find(truss().checked(assignments), name).settled;
}

}  // namespace

TEST_CASE("its values are the corpus', to the last bit of a double, by both routes", "[truss]") {
  CHECK(corpus().size() == 24);
  holds_against(truss(), corpus());
}

TEST_CASE("zero bars are proved, and told from what is almost zero", "[truss]") {
  const auto is_proved_zero = [](const Assignments& assignments, const std::string& bar) {
    const geometry::Settled found = settled(assignments, bar);
    return found.kind == geometry::Settled::Kind::certain && found.enclosure.lower == 0 && found.enclosure.upper == 0;
  };
  CHECK(is_proved_zero({"shape=pratt", "P=0", "W=100"}, "N_3"));
  CHECK(settled({"shape=pratt", "P=1e-9", "W=100"}, "N_3").enclosure.lower > 0);
  CHECK(is_proved_zero({"W=-2400"}, "N_1"));
  CHECK(settled({"W=-2399.9999999999999999999999999999"}, "N_1").enclosure.lower > 0);
  CHECK(settled({"W=-2400.0000000000000000000000000001"}, "N_1").enclosure.upper < 0);
  // With directions that no root says: by Calcium, or over all of them.
  CHECK(is_proved_zero({"shape=polonceau", "delta=7", "P=0", "W=10", "beta=23"}, "N_10"));
}

TEST_CASE("a truss that cannot be is refused with the value and the condition", "[truss]") {
  CHECK(refusal({"n=5"}) == "n = 5: this truss has an even number of panels from 2 to 8");
  CHECK(refusal({"n=10"}) == "n = 10: this truss has an even number of panels from 2 to 8");
  CHECK(refusal({"shape=warren", "n=9"}) == "n = 9: this truss has a whole number of panels from 2 to 8");
  CHECK(refusal({"shape=bracket", "n=2.5"}).starts_with("n = 5/2: "));
  CHECK(refusal({"P=0"}) == "P = 0 N, W = 0 N: nothing loads the truss");
  CHECK(refusal({"delta=90"}) ==
        "delta = 90°: the roller's line of action passes through the hinge, and the truss is not held");
  CHECK(refusal({"shape=bracket", "delta=-450"}).starts_with("delta = -450°: "));
  CHECK(refusal({"shape=polonceau", "h=9"}) ==
        "L = 12 m, h = 9 m: bars 6 (C F) and 9 (D G) cross or touch: the truss is not flat, and has no regions "
        "between its bars");
  for (const char* wrong : {"L=0", "h=-1", "n=0"}) {
    CAPTURE(wrong);
    CHECK_FALSE(refusal({wrong}).empty());
  }
  for (const Assignments& possible :
       {Assignments{"delta=89.9999999999"}, {"n=2"}, {"shape=crane", "n=77"}, {"P=-3"}}) {
    CAPTURE(possible);
    CHECK(refusal(possible).empty());
  }
}

TEST_CASE("a ruler reads every force off the plan", "[truss][sheets]") {
  for (const CorpusCase& c : corpus()) {
    const DrawnSheet drawn = truss().draw("plan", assignments_of(c));
    std::size_t bars = 0, read = 0;
    for (const Measurement& each : drawn.measurements) read += each.quantity.starts_with("N_") ? 1 : 0;
    for (int i = 1; !c.reference("N_" + std::to_string(i)).empty(); ++i) {
      const std::string force = c.reference("N_" + std::to_string(i));
      bars += force != "infinite" && force != "0" ? 1 : 0;
    }
    CAPTURE(c.name);
    CHECK(read == bars);
  }
}

TEST_CASE("a ruler reads the reactions off the polygon with the pole, and a roller that pulls is told",
          "[truss][sheets]") {
  for (const CorpusCase& c : corpus()) {
    const DrawnSheet drawn = truss().draw("reactions", assignments_of(c));
    std::set<std::string> read;
    for (const Measurement& each : drawn.measurements) read.insert(each.quantity);
    CAPTURE(c.name);
    for (const char* reaction : {"R_A", "R_B"}) CHECK((read.contains(reaction) || c.reference(reaction) == "0"));
  }
  const auto tells_of_pull = [](const Assignments& assignments) {
    return told_on(truss(), "reactions", assignments).find("must be held down") != std::string::npos;
  };
  CHECK(tells_of_pull({"shape=crane", "L=6", "h=4"}));
  CHECK_FALSE(tells_of_pull({}));
}

TEST_CASE("every sheet is drawn, whatever is given", "[truss][sheets]") { draws_every_sheet(truss(), corpus()); }

TEST_CASE("letters find room on all sheets", "[truss][sheets]") {
  letters_find_room(truss(), {{},
                              {"n=6"},
                              {"n=2"},
                              {"h=6", "W=700", "beta=-45"},
                              {"shape=polonceau"},
                              {"shape=warren"},
                              {"shape=warren", "n=6"},
                              {"shape=pratt", "n=6"},
                              {"shape=howe", "n=6"},
                              {"shape=howe", "n=8", "L=24", "W=300"},
                              {"shape=bracket", "L=3", "h=2"},
                              {"shape=crane", "L=6", "h=4"}});
}

// Else the numbers of the bars would cover the letters of the regions.
TEST_CASE("bars of small regions have numbers without signs, which the column says", "[truss][sheets]") {
  const auto is_written = [](const DrawnSheet& drawn, const std::string& text) {
    const auto& labels = drawn.sheet.figure.labels;
    return std::any_of(labels.begin(), labels.end(), [&](const auto& label) { return label.text == text; });
  };
  const Assignments small{"shape=howe", "n=8", "L=24", "W=300"};
  const DrawnSheet usual = truss().draw("plan", {}), crowded = truss().draw("plan", small);
  CHECK(is_written(usual, "1 +"));
  CHECK(is_written(crowded, "11"));
  CHECK_FALSE(is_written(crowded, "11 +"));
  CHECK(is_written(truss().draw("forces", small), "11 +"));
  CHECK_THAT(told_on(truss(), "plan", small), Contains("no room for + and −"));
  CHECK_THAT(told_on(truss(), "plan", {}), !Contains("no room for"));
  const Assignments in_part{"shape=polonceau", "W=800", "beta=-30", "delta=25"};  // beside its two struts
  CHECK(is_written(truss().draw("plan", in_part), "8 +"));
  CHECK(is_written(truss().draw("plan", in_part), "6"));
  CHECK_THAT(told_on(truss(), "plan", in_part), Contains("Beside some bars there is no room for + and −"));
}
