// Each step that a sheet lists has its number on the picture, or is named as off the sheet; and nothing is numbered
// on the picture that is not listed. And what is drawn is given, or some step drew it.
#include <algorithm>
#include <map>
#include <set>

#include "drawings/paths/vectors.h"
#include "drawings/sheet/steps_of_marks.h"
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

TEST_CASE("each step has its number on the picture, or is named as off the sheet") {
  int seen = 0, off = 0;
  for (const auto& [id, sets] : tried_givens())
    for (const Assignments& assignments : sets)
      for (const Language language : {Language::english, Language::italian}) {
        const Exercise& exercise = find_exercise(catalogue(), id);
        const Solution solution = exercise.solution(Tried(id).givens(assignments));
        for (const SheetSpec& spec : exercise.about().sheets) {
          CAPTURE(id, assignments, spec.name, static_cast<int>(language));
          const drawings::Sheet sheet = exercise.draw(spec.name, solution, {.language = language}).sheet;
          std::map<int, std::string> lines = listed(sheet);
          int number = 0;
          for (const auto& [listed_number, line] : lines) CHECK(listed_number == ++number);
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
      }
  CHECK(seen > 1000);
  CHECK(off > 0);
}

namespace {

// The first line that has these letters, with their dollar signs; 0: none has.
int first_to_name(const std::string& letters, const std::map<int, std::string>& lines) {
  for (const auto& [number, line] : lines)
    if (line.find(letters) != std::string::npos) return number;
  return 0;
}

struct SteppedSheet {
  drawings::Sheet solved, blank;
  std::map<int, std::string> lines;
  drawings::StepsOfMarks found;

  SteppedSheet(const Exercise& exercise, const std::string& sheet, const Solution& solution)
      : solved(exercise.draw(sheet, solution, {}).sheet),
        blank(exercise.draw(sheet, solution, {.blank = true}).sheet),
        lines(listed(solved)),
        found(drawings::steps_of_marks(solved.figure, solved.column, blank.figure)) {}

  // What is shown before the first step is given: no vector that was found, no pole, no curve.
  void check_given() const {
    const auto stands_on = [](const auto& of, const drawings::Label& label) {
      return std::any_of(of.begin(), of.end(), [&](const drawings::Label& each) {
        return each.text == label.text && each.at.x == label.at.x && each.at.y == label.at.y;
      });
    };
    for (std::size_t i = 0; i < solved.figure.labels.size(); ++i)
      if (const drawings::Label& label = solved.figure.labels[i]; found.labels[i] == 0) {
        CAPTURE(label.text);
        CHECK(stands_on(blank.figure.labels, label));
      }
    CHECK(vectors_at_first(solved.figure, &found) == vectors_at_first(blank.figure, nullptr));
  }
  static std::multiset<std::string> vectors_at_first(const drawings::Figure& figure,
                                                     const drawings::StepsOfMarks* found) {
    std::multiset<std::string> named;
    for (std::size_t i = 0; i < figure.marks.size(); ++i)
      if (const auto* arrow = std::get_if<drawings::Arrow>(&figure.marks[i]);
          arrow && (!found || found->marks[i] == 0))
        named.insert(arrow->name);
    return named;
  }

  // Letters are not shown before the words that name them first.
  void check_letters() const {
    for (std::size_t i = 0; i < solved.figure.labels.size(); ++i) {
      const std::string& text = solved.figure.labels[i].text;
      CAPTURE(text);
      if (found.labels[i] > 0) CHECK(first_to_name(text, lines) <= found.labels[i]);
    }
  }
};

}  // namespace

TEST_CASE("every mark is given or belongs to a step, and none comes before the step that names it") {
  for (const auto& [id, sets] : tried_givens())
    for (const Assignments& assignments : sets) {
      const Exercise& exercise = find_exercise(catalogue(), id);
      const Solution solution = exercise.solution(Tried(id).givens(assignments));
      for (const SheetSpec& spec : exercise.about().sheets) {
        CAPTURE(id, assignments, spec.name);
        const SteppedSheet sheet(exercise, spec.name, solution);
        if (sheet.lines.empty()) continue;
        sheet.check_given();
        sheet.check_letters();
      }
    }
}
