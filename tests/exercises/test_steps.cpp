// Each step that a sheet lists has its number on the picture, or is named as off the sheet; and nothing is numbered
// on the picture that is not listed.
#include <map>

#include "drawings/paths/vectors.h"
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

}  // namespace

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
