// The sheets of Rivals' theorem: a step a picture, all at one scale, whatever is given.
#include <algorithm>

#include "tests/exercises/rivals-polygons/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Diagram> diagrams{{"velocity-of-B", {"v_A", "v_BA", "v_B"}},
                                    {"velocity-of-G", {"v_A", "v_GA", "v_G"}},
                                    {"acceleration-of-B", {"a_A_n", "a_BA_n", "a_BA_t", "a_B"}},
                                    {"acceleration-of-G", {"a_A_n", "a_GA_n", "a_GA_t", "a_G"}}};

const std::vector<Assignments> usual{{},          {"phi=0"},  {"phi=90"}, {"phi=135"}, {"phi=200"},
                                     {"phi=300"}, {"n=-100"}, {"AG=0"},   {"AG=0.5"},  {"AG=-0.2", "alpha_2=900"}};

template <class Mark>
std::vector<Mark> marks(const DrawnSheet& drawn) {
  std::vector<Mark> all;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* one = std::get_if<Mark>(&mark)) all.push_back(*one);
  return all;
}

// The captions of the pictures, as they stand in the file's order.
std::vector<std::string> captions(const DrawnSheet& drawn) {
  std::vector<std::string> all;
  for (const auto& writing : marks<drawings::Writing>(drawn)) all.push_back(writing.text);
  return all;
}

}  // namespace

TEST_CASE("Rivals: every sheet is drawn, whatever is given", "[rivals][sheets]") {
  draws_every_sheet(rivals(), read_corpus(EPURE_CORPUS "/rivals.txt"));
}

TEST_CASE("Rivals: letters find room", "[rivals][sheets]") { letters_find_room(rivals(), usual); }

TEST_CASE("Rivals: a ruler on the file reads the value of every vector", "[rivals][sheets]") {
  for (const Assignments& assignments : {Assignments{}, {"phi=135"}, {"n=-100", "phi=200"}})
    for (const Diagram& diagram : diagrams) ruler_reads(rivals(), diagram, assignments);
}

TEST_CASE("Rivals: the polygons close", "[rivals][sheets]") {
  for (const Assignments& assignments : usual)
    if (assignments.size() < 2)  // else a_A^t is a side too
      for (const Diagram& diagram : diagrams) polygon_closes(rivals(), diagram, assignments);
  polygon_closes(rivals(), {"acceleration-of-B", {"a_A_n", "a_A_t", "a_BA_n", "a_BA_t", "a_B"}}, {"alpha_2=-900"});
  polygon_closes(rivals(), {"acceleration-of-G", {"a_A_n", "a_A_t", "a_GA_n", "a_GA_t", "a_G"}}, {"alpha_2=-900"});
}

TEST_CASE("Rivals: the table of knowns and unknowns is the source's", "[rivals][sheets]") {
  const auto table = [](const DrawnSheet& drawn) {
    std::string text;
    for (const drawings::Block& block : drawn.sheet.column)
      if (const auto* equation = std::get_if<drawings::VectorEquation>(&block))
        for (const auto& term : equation->terms)
          text += term.before + " " + term.vector + " " + term.direction + " " + term.magnitude + "; ";
    return text;
  };
  CHECK(table(rivals().draw("velocity-of-B", {})) ==
        " $\\vec{v}_{B}$ ∥ $A_{0}B$ ?; = $\\vec{v}_{A}$ ⊥ $A_{0}A$ |$ω_{2}$|·$A_{0}A$; + $\\vec{v}_{BA}$ ⊥ $BA$ ?; ");
  CHECK(table(rivals().draw("acceleration-of-B", {})) ==
        " $\\vec{a}_{B}$ ∥ $A_{0}B$ ?; = $\\vec{a}^{n}_{A}$ ∥ $AA_{0}$ $ω^{2}_{2}$·$A_{0}A$; + $\\vec{a}^{t}_{A}$ – "
        "0; + "
        "$\\vec{a}^{n}_{BA}$ ∥ $BA$ $ω^{2}_{3}$·$AB$; + $\\vec{a}^{t}_{BA}$ ⊥ $BA$ ?; ");
}

TEST_CASE("Rivals: the pictures are the source's figures, a step each", "[rivals][sheets]") {
  const DrawnSheet drawn = rivals().draw("velocity-of-B", {});
  CHECK(captions(drawn) ==
        std::vector<std::string>{"a)  $\\vec{v}_{A}$ known (source, fig. 2)",
                                 "b)  directions of $\\vec{v}_{BA}$ and $\\vec{v}_{B}$ (source, fig. 3)",
                                 "c)  the polygon, closed (source, fig. 4)"});
  // v_A in all three; the unknown ones in the last only.
  const auto arrows = marks<drawings::Arrow>(drawn);
  CHECK(arrows.size() == 5);
  CHECK(std::count_if(arrows.begin(), arrows.end(), [](const auto& arrow) { return !arrow.name.empty(); }) == 3);
  // Only the whole polygon is measured.
  CHECK(drawn.measurements.size() == 3);
  // The step that is new has its number; none on the last picture.
  std::vector<int> numbers;
  for (const drawings::StepNumber& step : drawn.sheet.figure.steps) numbers.push_back(step.number);
  CHECK(numbers == std::vector<int>{1, 2, 3});

  CHECK(captions(rivals().draw("velocity-of-G", {})).size() == 4);
  CHECK(captions(rivals().draw("acceleration-of-B", {}))[2].ends_with("(source, fig. 9)"));
  CHECK(captions(rivals().draw("acceleration-of-B", {}))[3].ends_with("(source, fig. 10)"));
  CHECK(captions(rivals().draw("acceleration-of-B", {"alpha_2=100"})).size() == 5);
}

TEST_CASE("Rivals: all pictures of a sheet are drawn at one scale", "[rivals][sheets]") {
  for (const char* sheet : {"velocity-of-B", "velocity-of-G", "acceleration-of-B", "acceleration-of-G"})
    for (const Assignments& assignments : usual) {
      const auto arrows = marks<drawings::Arrow>(rivals().draw(sheet, assignments));
      CAPTURE(sheet, assignments);
      REQUIRE(arrows.size() >= 5);
      // The first vector begins every picture.
      const drawings::Arrow& first = arrows.front();
      const auto same = [&](const drawings::Arrow& arrow) {
        return std::abs((arrow.to.x - arrow.from.x) - (first.to.x - first.from.x)) < 1e-9 &&
               std::abs((arrow.to.y - arrow.from.y) - (first.to.y - first.from.y)) < 1e-9;
      };
      const auto pictures = captions(rivals().draw(sheet, assignments)).size();
      CHECK(static_cast<std::size_t>(std::count_if(arrows.begin(), arrows.end(), same)) >= pictures);
    }
}

TEST_CASE("Rivals: a scale that is asked for is the mechanism's", "[rivals][sheets]") {
  const DrawnSheet drawn = rivals().draw("velocity-of-B", {}, {.scale = Rational(1, 20)});
  CHECK(drawn.sheet.title_block.scales[0] == "1 : 20");
  CHECK_THROWS_WITH(rivals().draw("velocity-of-B", {}, {.scale = Rational(1)}), Contains("would fit"));
}

TEST_CASE("Rivals: the sheet says what the source's equation would give", "[rivals][sheets]") {
  const DrawnSheet drawn = rivals().draw("acceleration-of-B", {});
  const auto says = [](const drawings::Block& block) {
    const auto* remark = std::get_if<drawings::Paragraph>(&block);
    return remark &&
           remark->text.find("$a^{(1)}_{B}$ = 525.0 m/s² instead of $a_{B}$ = 307.8 m/s²") != std::string::npos;
  };
  CHECK(std::any_of(drawn.sheet.column.begin(), drawn.sheet.column.end(), says));
}
