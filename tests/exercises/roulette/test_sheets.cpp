// The sheets of the roulettes, whatever rolls on whatever.
#include "tests/exercises/roulette/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments> usual{{},
                                     {"how=circle_on_line", "phi=140"},
                                     {"how=circle_on_line", "d=0.3", "alpha=3"},
                                     {"how=circle_on_line", "d=0.05", "phi=-200"},
                                     {"how=circle_inside_circle", "R=0.6"},
                                     {"how=circle_inside_circle", "R=0.3"},
                                     {"how=line_on_circle", "d=0"},
                                     {"how=line_on_circle", "d=-0.2", "phi=-100", "omega=-2"},
                                     {"phi=480"}};

bool draws(const DrawnSheet& drawn) {
  const std::string bytes = drawings::svg(drawn.sheet);
  for (const char* word : {"-nan", "=\"nan", "=\"inf", " nan ", " inf "})
    if (bytes.find(word) != std::string::npos) return false;
  return bytes.find("<svg") != std::string::npos;
}

std::string words_of(const DrawnSheet& drawn) {
  std::string text;
  for (const drawings::Block& block : drawn.sheet.column) {
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) text += line + "\n";
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) text += paragraph->text + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("roulette: letters find room", "[roulette][sheets]") { letters_find_room(roulette(), usual); }

TEST_CASE("roulette: every sheet is drawn, whatever is given", "[roulette][sheets]") {
  std::vector<Assignments> hard{{"omega=0"},
                                {"omega=0", "alpha=0", "phi=0"},
                                {"d=0"},
                                {"r=1e-6", "d=1e-6"},
                                {"r=1e6", "d=1e6"},
                                {"phi=1e9"},
                                {"d=1000"},
                                {"r=0.449", "d=0.449"},
                                {"R=0.000001"},
                                {"phi=0"},
                                {"phi_rad=1e-12", "phi=0"},
                                {"omega=1e6", "alpha=-1e9"}};
  for (const char* how : {"circle_on_line", "circle_outside_circle", "circle_inside_circle", "line_on_circle"})
    for (Assignments assignments : hard) {
      assignments.push_back(std::string("how=") + how);
      CAPTURE(assignments);
      for (const SheetSpec& sheet : roulette().about().sheets) {
        CAPTURE(sheet.name);
        const Givens givens = roulette().givens(assignments);
        if (std::string(how) == "circle_inside_circle" && givens["r"] >= givens["R"])
          CHECK_THROWS_AS(roulette().draw(sheet.name, assignments), BadGivens);
        else
          CHECK(draws(roulette().draw(sheet.name, assignments)));
      }
    }
}

TEST_CASE("roulette: a ruler on the file reads speed, acceleration and its normal part", "[roulette][sheets]") {
  for (const Assignments& assignments :
       {Assignments{}, {"how=circle_on_line", "d=0.3", "alpha=3"}, {"how=line_on_circle", "d=-0.2"}}) {
    ruler_reads(roulette(), {"instant", {"a_M", "a_M_n"}}, assignments);
    const CheckedExercise numbers = roulette().checked(assignments);
    for (const char* name : {"v_M", "inflection_diameter", "rho_M", "Mprime_M", "P0M"})
      CHECK_FALSE(find(numbers, name).on_sheets.empty());
  }
}

TEST_CASE("roulette: the sheets say what is special", "[roulette][sheets]") {
  CHECK_THAT(words_of(roulette().draw("instant", {"phi=480"})),
             Catch::Contains("has a cusp") && Catch::Contains("before"));
  CHECK_THAT(words_of(roulette().draw("instant", {"how=circle_inside_circle", "R=0.3"})),
             Catch::Contains("a diameter"));
  CHECK_THAT(words_of(roulette().draw("instant", {"how=circle_on_line", "d=0.075", "phi=60"})),
             Catch::Contains("at infinity"));
  CHECK_THAT(words_of(roulette().draw("path", {"d=0.1"})), Catch::Contains("curtate epicycloid"));
  CHECK_THAT(words_of(roulette().draw("path", {"d=0.2"}, {.language = Language::italian})),
             Catch::Contains("epicicloide allungata"));
}
