// The pump: its numbers are those of a corpus that samples the turn, the source's numbers, bad givens, sheets.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/cli/catalogue.h"
#include "exercises/pump-flywheel/drawn_pump.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& pump() {
  static const Tried tried("pump-flywheel");
  return tried;
}
const std::vector<CorpusCase>& corpus() {
  static const auto read = read_corpus(EPURE_CORPUS "/pump.txt");
  return read;
}

}  // namespace

TEST_CASE("pump: values are the corpus', to the last bit of a double, by every route", "[pump]") {
  CHECK(corpus().size() == 9);
  holds_against(pump(), corpus());
}

TEST_CASE("pump: what the source printed, and why it is wrong where it is", "[pump]") {
  const CheckedExercise result = pump().checked({});
  CHECK(result.passed());
  const Judged prints = judged(result);
  CHECK(prints.rounding == 10);
  CHECK(prints.explained == 10);
  CHECK(prints.unexplained == 0);
}

TEST_CASE("pump: the mass moves the extremes, and Wittenbauer's inertia lies beside the approximate one", "[pump]") {
  const CheckedExercise result = pump().checked({});
  CHECK(value(result, "reciprocating_mass.alpha_1") < value(result, "alpha_1"));
  CHECK(value(result, "wittenbauer.J_crank") == Approx(value(result, "reciprocating_mass.J_crank")).epsilon(0.01));
  const CheckedExercise without = pump().checked({"m=0"});
  for (const char* name : {"J_crank", "J_flywheel", "n_t_flywheel"})
    CHECK(value(without, std::string("wittenbauer.") + name) == value(without, name));
}

TEST_CASE("pump: the motor alone is no error", "[pump]") {
  const CheckedExercise result = pump().checked({"J_m=1"});
  CHECK(result.passed());
  CHECK(value(result, "J_flywheel") < 0);
  const auto column = pump().draw("energy", {"J_m=1"}).sheet.column;
  CHECK(std::any_of(column.begin(), column.end(), [](const drawings::Block& block) {
    const auto* words = std::get_if<drawings::Paragraph>(&block);
    return words && words->text.find("the motor alone suffices") != std::string::npos;
  }));
}

TEST_CASE("pump: givens that cannot be, each in one sentence", "[pump]") {
  is_refused(pump(), {"n_m=3000"}, "below its synchronous speed");
  is_refused(pump(), {"n_m=3000.000000000000000000000000000001"}, "below its synchronous speed");
  is_refused(pump(), {"i=2"}, "must be less than 2");
  is_refused(pump(), {"i=0"}, "must be positive");
  is_refused(pump(), {"m=-1"}, "must not be negative");
  is_refused(pump(), {"p_a=5.000000000000000000000000000001"}, "must not be greater");
  CHECK(pump().checked({"n_m=2999.999999999999999999999999999999"}).passed());
  CHECK(pump().checked({"p_a=4.999999999999999999999999999999"}).passed());
  CHECK(pump().checked({"i=1.999999999"}).passed());
}

TEST_CASE("pump: what exceeds the mean torque is filled as such, in suction too", "[pump][sheets]") {
  const auto areas = [](const Assignments& given) {
    int above = 0, below = 0;
    for (const drawings::Mark& mark : pump().draw("torque", given).sheet.figure.marks)
      if (const auto* area = std::get_if<drawings::Area>(&mark)) {
        above += area->meaning == drawings::Meaning::force;
        below += area->meaning == drawings::Meaning::velocity;
      }
    return std::pair(above, below);
  };
  CHECK(areas({}) == std::pair(1, 2));
  CHECK(areas({"p_a=3"}) == std::pair(2, 3));
  CHECK_THAT(told_on(pump(), "torque", {"p_a=3"}), Contains("In suction too"));
  CHECK_THAT(told_on(pump(), "torque", {}), !Contains("In suction too"));
}

TEST_CASE("pump: what is integrated with the mass is named with it, and each crank by its angles", "[pump][sheets]") {
  const auto named = [](const std::string& sheet, Language language) {
    std::string all;
    for (const auto& title : all_of<drawings::Writing>(pump().draw(sheet, {}, {.language = language})))
      all += title.text + "\n";
    return all;
  };
  const std::string mass = "$\\it{M}_{m}$ − $\\it{M}_{r}$ − $\\it{M}_{s}$ ";
  CHECK_THAT(named("energy-with-mass", Language::english), Contains(mass + "sin 2$α$ (N m)"));
  CHECK_THAT(named("energy-with-mass", Language::italian), Contains(mass + "sen 2$α$ (N m)"));
  CHECK_THAT(named("energy", Language::english), !Contains("sin"));
  CHECK_THAT(words_of(pump().draw("energy-with-mass", {})), Contains(mass + "sin 2$α$: the ordinate"));
  std::string labels;
  for (const drawings::Label& each : pump().draw("torque", {}).sheet.figure.labels) labels += each.text + "\n";
  CHECK_THAT(labels, Contains("225°, 315°"));
}

TEST_CASE("pump: no flywheel is told of where none is needed", "[pump][sheets]") {
  for (const auto& [language, none, some] : {std::tuple(Language::english, "no flywheel", "With the flywheel"),
                                             {Language::italian, "non richiede volano", "Con il volano"}}) {
    CHECK_THAT(told_on(pump(), "harmonics", {}, language), Contains(some) && Contains("n'_{t}") && !Contains(none));
    CHECK_THAT(told_on(pump(), "harmonics", {"J_m=10"}, language),
               Contains(none) && !Contains("n'_{t}") && !Contains(some));
  }
}

TEST_CASE("pump: every sheet is drawn, whatever is given", "[pump][sheets]") { draws_every_sheet(pump(), corpus()); }

// Of a hair-thin piston the mass is all: where the torque is zero doubles cannot tell from where the delivery begins.
TEST_CASE("pump: two ends of a strip in one double are one", "[pump][sheets]") {
  for (const char* bore : {"D=0.4", "D=0.05"})
    for (const char* sheet : {"energy", "energy-with-mass", "wittenbauer", "torque"}) {
      CAPTURE(bore, sheet);
      CHECK_NOTHROW(pump().draw(sheet, {bore}));
    }
}

TEST_CASE("pump: letters find room", "[pump][sheets]") {
  letters_find_room(pump(), {{}, {"m=0"}, {"m=300"}, {"p_a=4", "i=0.2"}});
}

TEST_CASE("pump: the polygon of energy is off by no more than is told, and not by much less", "[pump]") {
  for (const auto& [sheet, of, mass] :
       {std::tuple("energy", "", ""), {"energy-with-mass", "reciprocating_mass.", "M_inertia_max"}}) {
    const Solution s = find_exercise(catalogue(), "pump-flywheel").solution(pump().givens({}));
    const pump_flywheel::DrawnPump drawn(s, *mass ? s[mass] : 0);
    const std::string prefix = of;
    const double pi = std::numbers::pi, first = s[prefix + "alpha_1"], second = s[prefix + "alpha_2"],
                 quarter = (second - first) / 4;
    std::vector<double> ends;
    for (int i = 0; i <= 6; ++i) ends.push_back(i * pi / 6);
    for (const double late : {first, first + quarter, first + 2 * quarter, second - quarter, second, pi})
      ends.push_back(pi + late);
    double most = 0;
    for (std::size_t i = 1; i < ends.size(); ++i)
      for (int k = 0; k <= 100; ++k) {
        const double low = drawn.energy(ends[i - 1]), high = drawn.energy(ends[i]),
                     there = drawn.energy(ends[i - 1] + (ends[i] - ends[i - 1]) * k / 100);
        most = std::max(most, std::abs(low + (high - low) * k / 100 - there));
      }
    const double told = s[prefix + "polygon_off_at_most"];
    CAPTURE(sheet, most, told);
    CHECK(most <= told);
    CHECK(most > 0.6 * told);
    CHECK_THAT(told_on(pump(), sheet, {}), Contains("$δ_{T}$ = "));
  }
}
