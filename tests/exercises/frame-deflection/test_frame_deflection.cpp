// The frame loaded across its plane: every route holds against a corpus that knows no series of tanh, no elastic
// weights and no stiffness; what is refused; what the source took; and what a ruler reads off the sheets.
#include "exercises/kit/proof/verdict.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& frame() {
  static const Tried tried("frame-deflection");
  return tried;
}

const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/frame.txt");
  return cases;
}

std::set<std::string> routes_of(const CheckedQuantity& quantity) {
  std::set<std::string> routes;
  for (const RouteValue& route : quantity.routes) routes.insert(route.route);
  return routes;
}

std::string refusal(const Assignments& assignments) {
  try {
    frame().checked(assignments);
  } catch (const BadGivens& refused) {
    return refused.what();
  }
  return {};
}

}  // namespace

TEST_CASE("its values are the corpus', to the last bit of a double, by every route", "[frame-deflection]") {
  CHECK(corpus().size() == 14);
  holds_against(frame(), corpus());
  const CheckedExercise stated = frame().checked({});
  CHECK(stated.quantities.size() == 42);
  CHECK(routes_of(find(stated, "w_A")) ==
        std::set<std::string>{"construction", "second polygon", "virtual work", "stiffness matrix"});
  CHECK(routes_of(find(stated, "J_t1")) == std::set<std::string>{"construction", "analytic"});
}

// The corpus has C 1e-9 and 1e-30 from its level; here it is as far on the other side.
TEST_CASE("which way C moves is told however little it does", "[frame-deflection]") {
  const auto w_C = [](const std::string& L_2) { return value(frame().checked({"L_2=" + L_2}), "w_C"); };
  CHECK(w_C("12678.42367263998878424325653528") < 0);
  CHECK(w_C("12678.42367263998878424325653530") > 0);
  CHECK(std::abs(w_C("12678.42367263998878424325653530")) < 1e-27);
}

TEST_CASE("zeros are exact, by every route that finds them", "[frame-deflection]") {
  for (const Assignments& given : {Assignments{}, {"L_1=1/3", "L_2=1/7", "P=0.1"}}) {
    const CheckedExercise result = frame().checked(given);
    for (const char* name : {"M_O_y", "M_x_O", "M_x_C_bar_2", "M_x_A", "M_z_bar_3"})
      for (const RouteValue& route : find(result, name).routes) {
        CAPTURE(name, route.route);
        CHECK(route.settled.kind == geometry::Settled::Kind::certain);
        CHECK(route.settled.enclosure.value == 0);
      }
  }
}

TEST_CASE("the source's deflection is that of the polar moment", "[frame-deflection]") {
  const CheckedExercise result = frame().checked({});
  int rounded = 0, explained = 0;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& printed : quantity.printed) {
      CAPTURE(quantity.spec.name, printed.text);
      if (printed.verdict == Verdict::rounding) ++rounded;
      if (printed.verdict != Verdict::disagrees) continue;
      ++explained;
      CHECK(printed.explanation_holds);
      CHECK(printed.explanation->english.find("J_p1") != std::string::npos);
    }
  CHECK(rounded == 5);
  CHECK(explained == 2);
}

TEST_CASE("a frame that cannot be is refused with the value and the condition", "[frame-deflection]") {
  const auto tells = [](const Assignments& given, const std::vector<std::string>& parts) {
    const std::string text = refusal(given);
    CAPTURE(given, text);
    for (const std::string& part : parts) CHECK(text.find(part) != std::string::npos);
  };
  tells({"nu=-1"}, {"nu = -1", "above -1"});
  tells({"nu=0.500000001"}, {"nu = 0.5", "at most 1/2"});
  tells({"s_r=0.01"}, {"H_r = 50 mm", "5000 times", "s_r = 0.01 mm"});
  tells({"s_r=50.00001m"}, {"H_r = 50 mm", "times each other"});
  for (const char* wrong :
       {"L_1=0", "L_2=-800", "phi=0", "s_r=-10", "H_r=0", "P=0", "E=0", "E=210000mm", "P=300kg"}) {
    CAPTURE(wrong);
    CHECK_FALSE(refusal({wrong}).empty());
  }
  for (const Assignments& possible : {Assignments{"nu=1/2"}, {"s_r=50m"}, {"nu=-0.999999999"}}) {
    CAPTURE(possible);
    CHECK(refusal(possible).empty());
  }
}

TEST_CASE("every sheet is drawn, whatever is given", "[frame-deflection][sheets]") {
  draws_every_sheet(frame(), corpus());
}

TEST_CASE("letters find room on all sheets", "[frame-deflection][sheets]") {
  letters_find_room(frame(), {{},
                              {"L_1=400", "L_2=1500", "phi=20"},
                              {"s_r=80", "H_r=20", "P=5000"},
                              {"L_1=2000", "L_2=200", "phi=12"},
                              {"L_1=800"}});
}

TEST_CASE("a ruler on the sheets reads moments, displacements and shares", "[frame-deflection][sheets]") {
  const std::vector<std::pair<std::string, std::vector<std::string>>> shown{
      {"moments",
       {"M_x_O", "M_x_mid_bar_1", "M_x_B_bar_1", "M_x_B_bar_2", "M_x_mid_bar_2", "M_x_C_bar_2", "M_x_C_bar_3",
        "M_x_mid_bar_3", "M_x_A", "M_z_bar_1", "M_z_bar_2"}},
      {"second-polygon", {"w_B", "delta_bending_2", "delta_bending_3"}},
      {"displacement-plan", {"w_B", "w_C", "w_A", "delta_bending_2", "delta_bending_3"}},
      {"shares",
       {"delta_bending_1", "delta_torsion_1", "delta_bending_2", "delta_torsion_2", "delta_bending_3", "delta_A"}}};
  for (const Assignments& given : {Assignments{}, {"s_r=80", "H_r=20", "P=5000"}}) {
    const CheckedExercise numbers = frame().checked(given);
    for (const auto& [sheet, names] : shown) {
      const DrawnSheet drawn = frame().draw(sheet, given);
      for (const std::string& name : names) {
        CAPTURE(given, sheet, name);
        const auto found = std::find_if(drawn.measurements.begin(), drawn.measurements.end(),
                                        [&](const Measurement& each) { return each.quantity == name; });
        REQUIRE(found != drawn.measurements.end());
        const drawings::Point from = drawings::as_filed(found->from, drawings::Paper::a4),
                              to = drawings::as_filed(found->to, drawings::Paper::a4);
        const double read = (found->kind == Measurement::along_y ? to.y - from.y : to.x - from.x) * found->per_mm;
        CHECK(std::abs(read - value(numbers, name)) <= 1.001 * drawings::file_resolution * found->per_mm);
      }
    }
  }
}

// The lower bar is 6 mm long on the paper: to the right of B its displacement would stand beyond C.
TEST_CASE("a displacement stands at its own end, however near the next one is", "[frame-deflection][sheets]") {
  const auto to_the_right = [](const Assignments& given) {
    const DrawnSheet drawn = frame().draw("displacement-plan", given);
    const auto place = [&](const std::string& letters) {
      for (const drawings::Label& each : drawn.sheet.figure.labels)
        if (each.text.starts_with(letters)) return each.at.x;
      throw std::logic_error("no letters " + letters);
    };
    return std::pair(place("$w_{B}$") - place("$B$"), place("$C$") - place("$B$"));
  };
  const auto [wide, far] = to_the_right({});
  CHECK(wide > 0);
  CHECK(wide < far);
  const auto [narrow, near] = to_the_right({"L_1=300", "L_2=1500", "s_r=50", "H_r=20"});
  CHECK(narrow < near);
}
