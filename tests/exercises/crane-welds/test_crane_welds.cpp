// The crane's welds: their numbers are those of a corpus that turns faces and differentiates the flange's force; what
// the source printed, computed with twice the mass it states; what cannot be; the sheets.
#include "exercises/kit/proof/verdict.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& welds() {
  static const Tried tried("crane-welds");
  return tried;
}

const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/crane_welds.txt");
  return cases;
}

const std::vector<Assignments> usual{
    {}, {"W_b=600"}, {"b=10mm", "s_1=12"}, {"f_1=0.5", "f_2=0.9"}, {"L=100mm", "H_1=900", "W_b=20t"}, {"W_b=40t"}};

std::string refusal(const Assignments& assignments) {
  try {
    welds().checked(assignments);
  } catch (const BadGivens& why) {
    return why.words().english;
  }
  return "";
}

std::set<std::string> shown(const std::string& sheet, const Assignments& assignments = {}) {
  std::set<std::string> names;
  for (const Measurement& m : welds().draw(sheet, assignments).measurements) names.insert(m.quantity);
  return names;
}

}  // namespace

TEST_CASE("crane welds: what is promised is reported, in its units", "[crane-welds]") {
  const CheckedExercise result = welds().checked({});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(result.quantities.size() == 45);
  for (const auto& [name, unit] : std::vector<std::pair<std::string, std::string>>{{"A_v1", "m^2"},
                                                                                   {"S_x1", "m^3"},
                                                                                   {"a", "m"},
                                                                                   {"q", "N/m"},
                                                                                   {"principal_direction", "rad"},
                                                                                   {"sigma_I", "Pa"}})
    CHECK(find(result, name).spec.unit == unit);
}

TEST_CASE("crane welds: values are the corpus', to the last bit of a double, by every route", "[crane-welds]") {
  CHECK(corpus().size() == 8);
  holds_against(welds(), corpus());
}

TEST_CASE("crane welds: all that is printed is right with 600 kg, and what hangs on the load wrong with 300",
          "[crane-welds]") {
  int right = 0, explained = 0;
  for (const CheckedQuantity& quantity : welds().checked({}).quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      CHECK(verdict.explanation_holds);
      if (verdict.verdict == Verdict::rounding) {
        ++right;
        continue;
      }
      CHECK(verdict.explanation.has_value());
      CHECK(std::abs(verdict.difference_percent.value()) == Approx(100).epsilon(1e-3));
      ++explained;
    }
  CHECK(right == 12);
  CHECK(explained == 5);
}

TEST_CASE("crane welds: what cannot be welded is refused in a sentence with the value", "[crane-welds]") {
  CHECK_THAT(refusal({"b=98"}), Contains("b = 98 mm") && Contains("97.5 mm"));
  CHECK(refusal({"b=97.5"}).empty());
  CHECK_THAT(refusal({"b_1=5"}), Contains("no room under the flange"));
  CHECK_THAT(refusal({"H_1=10"}), Contains("leaves no web"));
  for (const char* given : {"b=0", "f=0", "f_1=-1", "sigma_amm=0"})
    CHECK_THROWS_WITH(welds().givens({given}), Contains("must be positive"));
}

TEST_CASE("crane welds: every sheet is drawn, whatever is given", "[crane-welds][sheets]") {
  draws_every_sheet(welds(), corpus());
}

TEST_CASE("crane welds: letters find room", "[crane-welds][sheets]") { letters_find_room(welds(), usual); }

TEST_CASE("crane welds: the diagrams are measured back", "[crane-welds][sheets]") {
  using Names = std::set<std::string>;
  CHECK(shown("shear-flow") == Names{"q", "sigma_par_M", "tau_par_Jour"});
  CHECK(shown("throat") == Names{"a"});
  CHECK(shown("mohr") ==
        Names{"sigma_par_M", "tau_par_T", "sigma_I", "sigma_II", "Mohr_centre", "Mohr_radius", "sigma_eq"});
  CHECK(shown("sphere") ==
        Names{"fillet_allowable_1", "fillet_allowable_2", "tau_par_T", "mass_600kg.tau_par_T", "tau_fillet"});
  // A cut that does not reach the sphere is not drawn.
  CHECK_FALSE(shown("sphere", {"f_1=0.5", "f_2=0.9"}).contains("fillet_allowable_2"));
}

TEST_CASE("crane welds: each check says whether it holds", "[crane-welds][sheets]") {
  CHECK(tells(welds().draw("mohr", {}), "The check holds"));
  CHECK(tells(welds().draw("mohr", {"W_b=6000", "b=2"}), "The check does not hold"));
  CHECK(tells(welds().draw("throat", {}), "The check of the throats holds"));
  CHECK(tells(welds().draw("sphere", {"W_b=40t", "b=2"}), "The check of the throats does not hold"));
}

// In a close-up so far from its plane's origin that doubles no longer tell its points apart no length is read.
TEST_CASE("a fillet that is nothing beside its walls is not drawn, and does not fail the check") {
  const CheckedExercise none = welds().checked({"b=2.1e-12", "s_1=4.422"});
  CHECK(complaints(none).empty());
  REQUIRE(none.not_drawn.size() == 1);
  CHECK_THAT(none.not_drawn.front().sentence.english, Contains("throat") && Contains("too far off the paper"));
  CHECK(complaints(welds().checked({"b=2.1e-7", "s_1=4.422"})).empty());
  CHECK(shown("throat").contains("a"));
}
