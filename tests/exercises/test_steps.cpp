// Each step that a sheet lists has its number on the picture, or is named as off the sheet; and nothing is numbered
// on the picture that is not listed.
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "drawings/labels/obstacles.h"
#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"
#include "tests/exercises/told_words.h"
#include "tests/exercises/tried_givens.h"

using namespace epure;
using namespace epure::tests;

namespace {

// The numbered lines of the column.
std::map<int, std::string> listed(const drawings::Sheet& sheet) {
  std::map<int, std::string> all;
  for (const drawings::Block& block : sheet.column) {
    const auto* steps = std::get_if<drawings::Steps>(&block);
    if (!steps) continue;
    for (std::size_t i = 0; i < steps->lines.size(); ++i)
      CHECK(all.try_emplace(steps->first + static_cast<int>(i), steps->lines[i]).second);
  }
  return all;
}

bool is_off_the_sheet(const std::string& line) {
  return line.ends_with("(Off the sheet.)") || line.ends_with("(Fuori del foglio.)");
}

// The letters that stand on the picture.
std::set<std::string> written_on(const drawings::Figure& figure) {
  std::set<std::string> all;
  for (const drawings::Label& label : figure.labels) all.insert(label.text);
  for (const drawings::Mark& mark : figure.marks)
    if (const auto* dimension = std::get_if<drawings::Dimension>(&mark)) all.insert(dimension->text);
  return all;
}

}  // namespace

TEST_CASE("angles and arms that the steps speak of are drawn, as stated") {
  const std::map<std::string, std::set<std::string>> constructed{{"friction-efficiency", {"$φ$", "$d$"}},
                                                                 {"ideal-statics", {"$d$"}},
                                                                 {"cam-dynamics", {"$d_{2}$", "$d_{32}$"}},
                                                                 {"spool-slip", {"$h_{i}$", "$φ_{a}$"}}};
  std::map<std::string, int> seen;
  for (const auto& [id, letters] : constructed)
    for (const Language language : {Language::english, Language::italian}) {
      const Exercise& exercise = find_exercise(catalogue(), id);
      const Solution solution = exercise.solution(Tried(id).givens({}));
      for (const SheetSpec& spec : exercise.about().sheets) {
        const drawings::Sheet sheet = exercise.draw(spec.name, solution, {.language = language}).sheet;
        const std::set<std::string> written = written_on(sheet.figure);
        for (const auto& [number, line] : listed(sheet))
          for (const std::string& letter : letters) {
            if (line.find(letter) == std::string::npos) continue;
            CAPTURE(id, spec.name, static_cast<int>(language), number, line, letter);
            CHECK(written.contains(letter));
            ++seen[id + " " + letter];
          }
      }
    }
  for (const auto& [id, letters] : constructed)
    for (const std::string& letter : letters) {
      CAPTURE(id, letter);
      CHECK(seen[id + " " + letter] > 0);
    }
}

TEST_CASE("numbers on the pictures of Italian sheets have decimal commas") {
  const std::regex with_point("[0-9]\\.[0-9]"), with_comma("[0-9],[0-9]");
  int commas = 0;
  for_each_tried_sheet([&](const TriedSolution& tried, const std::string& name) {
    for (const std::string& text :
         written_on(tried.exercise.draw(name, tried.solution, {.language = Language::italian}).sheet.figure)) {
      CAPTURE(text);
      CHECK_FALSE(std::regex_search(text, with_point));
      commas += std::regex_search(text, with_comma) ? 1 : 0;
    }
  });
  CHECK(commas > 0);
}

TEST_CASE("each step has its number on the picture, or is named as off the sheet") {
  int seen = 0, off = 0;
  for_each_tried_sheet([&](const TriedSolution& tried, const std::string& name) {
    for (const Language language : {Language::english, Language::italian}) {
      CAPTURE(static_cast<int>(language));
      const drawings::Sheet sheet = tried.exercise.draw(name, tried.solution, {.language = language}).sheet;
      std::map<int, std::string> lines = listed(sheet);
      int number = 0;
      for (const auto& [listed_number, line] : lines) {
        CAPTURE(line);
        CHECK(listed_number == ++number);
        CHECK_FALSE(line.ends_with(','));  // a full stop is no decimal point
      }
      for (const drawings::StepNumber& step : sheet.figure.steps) {
        CAPTURE(step.number);
        CHECK(drawings::contains(drawings::drawing_area(sheet.paper), step.at));
        REQUIRE(lines.contains(step.number));
        CHECK_FALSE(is_off_the_sheet(lines[step.number]));
        lines.erase(step.number);
        ++seen;
      }
      for (const auto& [without_mark, line] : lines) {
        CAPTURE(without_mark, line);
        CHECK(is_off_the_sheet(line));
        ++off;
      }
    }
  });
  CHECK(seen > 1000);
  CHECK(off > 0);
}

TEST_CASE("the number of a source's item stands on no line alone") {
  constexpr const char* no_break = "\u00a0";
  int numbered = 0;
  for_each_tried_sheet([&](const TriedSolution& tried, const std::string& name) {
    const std::string source = tried.exercise.draw(name, tried.solution, {}).sheet.title_block.source;
    CAPTURE(source);
    CHECK(source.find(", N.") == std::string::npos);
    numbered += source.find(std::string(no_break) + "N.") != std::string::npos ? 1 : 0;
  });
  CHECK(numbered > 50);
}

TEST_CASE("what is marked as a right angle is one") {
  int seen = 0;
  for_each_tried_sheet([&](const TriedSolution& tried, const std::string& name) {
    for (const drawings::Mark& mark : tried.exercise.draw(name, tried.solution, {}).sheet.figure.marks)
      if (const auto* corner = std::get_if<drawings::RightAngle>(&mark)) {
        CHECK(std::abs(std::cos(corner->second - corner->first)) < 1e-6);
        ++seen;
      }
  });
  CHECK(seen > 100);
}

namespace {

double off_all_curves(drawings::Point p, const drawings::Figure& figure) {
  double least = INFINITY;
  for (const drawings::Mark& mark : figure.marks) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    if (!line || line->name.empty()) continue;
    const std::vector<drawings::Point> chords = drawings::flatten(line->path);
    for (std::size_t i = 1; i < chords.size(); ++i)
      least = std::min(least, drawings::gap({p, p}, chords[i - 1], chords[i]));
  }
  return least;
}

}  // namespace

// But for what a table or a recursion has beside them, values told on an axis or along curves without a name, and
// errors that no curve joins.
TEST_CASE("points marked on charts lie on their curves") {
  const std::set<std::string> beside{"aircraft-landing/euler",           "boat-crane/buckling",
                                     "cycloid-involute/cycloid-travel",  "cycloid-involute/involute-travel",
                                     "four-bar-constraints/convergence", "friction-efficiency/efficiencies",
                                     "michell-thrust/coefficients",      "oscillator-pendulum/motion",
                                     "oscillator-pendulum/phase-plane"};
  int seen = 0;
  for_each_tried_sheet([&](const TriedSolution& tried, const std::string& name) {
    if (beside.contains(tried.id + "/" + name)) return;
    const drawings::Figure figure = tried.exercise.draw(name, tried.solution, {}).sheet.figure;
    for (const drawings::Mark& mark : figure.marks)
      if (const auto* point = std::get_if<drawings::DataPoint>(&mark)) {
        CAPTURE(point->name);
        CHECK(off_all_curves(point->at, figure) < 0.2);
        ++seen;
      }
  });
  CHECK(seen > 900);
}

namespace {

std::string text_of(const drawings::Sheet& sheet) {
  std::string text;
  for (const drawings::Block& block : sheet.column) {
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) text += paragraph->text + "\n";
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) text += line + "\n";
    if (const auto* equation = std::get_if<drawings::VectorEquation>(&block))
      for (const auto& term : equation->terms) text += term.vector + " " + term.magnitude + "\n";
  }
  return text;
}

}  // namespace

// What a stranger to these sheets missed.
TEST_CASE("what a sheet uses is defined on it, as stated") {
  struct Said {
    std::string id, sheet, text;
  };
  for (const auto& [id, sheet, text] : std::vector<Said>{
           {"four-bar", "slider-crank", "$r$ = $A_{0}A$, $λ$ = $AB$ / $r$, $ω_{2}$"},
           {"four-bar-constraints", "convergence", "$Δθ_{\\it{i}}$ = $θ^{\\it{k}}_{\\it{i}}$ − $θ_{\\it{i}}$"},
           {"slider-crank-velocity", "polar-diagram", "|$ω_{3}$| = $v_{BA}$ / $AB$"},
           {"slider-crank-velocity", "polar-diagram", "$\\vec{v}_{MA}$ |$ω_{3}$|·$MA$"},
           {"four-bar-analytic", "configurations", "$\\vec{r}_{G3}$ = $\\vec{r}_{2}$ + ½$\\vec{r}_{3}$"},
           {"gear-pair", "pitch-point", "$N'_{1}$, $N'_{2}$"},
           {"velocity-centre", "acceleration-pole", "$γ$ = −18"},
           {"velocity-centre", "acceleration-pole", "$KO$ = 0"},
           {"pin-in-slot", "forces", "$\\vec{a}_{A}$ = (0"}})
    for (const Language language : {Language::english, Language::italian}) {
      const Exercise& exercise = find_exercise(catalogue(), id);
      const Solution solution = exercise.solution(Tried(id).givens({}));
      const std::string all =
          with_plain_spaces(text_of(exercise.draw(sheet, solution, {.language = language}).sheet));
      CAPTURE(id, sheet, static_cast<int>(language), text, all);
      CHECK(all.find(text) != std::string::npos);
    }
}

TEST_CASE("no formula of both configurations is torn across lines") {
  constexpr double column = 74, letters = 3.2;  // mm: of A4, as wide and as large as it is set there
  const Exercise& exercise = find_exercise(catalogue(), "four-bar-analytic");
  const Solution solution = exercise.solution(Tried("four-bar-analytic").givens({}));
  int formulas = 0;
  for (const Language language : {Language::english, Language::italian})
    for (const drawings::Block& block :
         exercise.draw("configurations", solution, {.language = language}).sheet.column)
      if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block);
          paragraph && paragraph->text.find(" / (") != std::string::npos) {
        CAPTURE(paragraph->text);
        CHECK(drawings::measure(paragraph->text, letters).width <= column);
        ++formulas;
      }
  CHECK(formulas == 6);
}
