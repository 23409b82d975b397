// The cases of the four-bar corpus whose frame lies on +x, as givens of exercises N.10 and N.11.
#pragma once

#include <string>
#include <vector>

#include "drawings/output.h"
#include "exercises/cli/catalogue.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/checked.h"
#include "geometry/numbers/given.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

namespace epure::tests {

using Assignments = std::vector<std::string>;

inline Givens givens_of(const std::string& id, const Assignments& assignments) {
  Givens givens(find_exercise(catalogue(), id).about().givens);
  for (const std::string& assignment : assignments) givens.set(assignment);
  return givens;
}

inline CheckedExercise checked(const std::string& id, const Assignments& assignments) {
  return check(find_exercise(catalogue(), id), givens_of(id, assignments), Rung::climb);
}

inline DrawnSheet draw(const std::string& id, const std::string& sheet, const Assignments& assignments,
                       const SheetRequest& request = {}) {
  return find_exercise(catalogue(), id).draw(sheet, givens_of(id, assignments), request);
}

inline const CheckedQuantity& find(const CheckedExercise& in, const std::string& name) {
  for (const CheckedQuantity& quantity : in.quantities)
    if (quantity.spec.name == name) return quantity;
  throw std::logic_error("no quantity " + name);
}
inline double value(const CheckedExercise& in, const std::string& name) {
  const geometry::Settled& settled = find(in, name).settled;
  CAPTURE(name, settled.reason.english);
  REQUIRE(settled.kind == geometry::Settled::Kind::certain);
  return settled.enclosure.value;
}

inline std::vector<CorpusCase> cases_on_x() {
  std::vector<CorpusCase> found;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/four_bar.txt")) {
    const bool on_x = c.givens.at("y_B0") == 0 && c.givens.at("x_B0") > 0;
    if (on_x && c.choices.at("crank_at") == "turn") found.push_back(c);
  }
  return found;
}

inline Assignments assignments_of(const CorpusCase& c) {
  const auto text = [&](const char* name) { return geometry::to_text(c.givens.at(name)); };
  return {"A0B0=" + text("x_B0"),
          "A0A=" + text("A0A"),
          "AB=" + text("AB"),
          "B0B=" + text("B0B"),
          "n=" + text("n"),
          "alpha_2=" + text("alpha_2"),
          "theta_2=" + geometry::to_text(360 * c.givens.at("turn"))};
}

// All that the case knows of the exercise's quantities, to the last bit, and by two routes or more.
inline int hold_against(const CheckedExercise& result, const CorpusCase& c) {
  int compared = 0;
  CAPTURE(c.name, c.why, complaints(result));
  CHECK(result.passed());
  for (const CheckedQuantity& quantity : result.quantities) {
    const std::string reference = c.reference(quantity.spec.name);
    if (reference.empty()) continue;
    CAPTURE(quantity.spec.name, reference, quantity.settled.reason.english);
    CHECK(quantity.routes.size() >= 2);
    ++compared;
    if (reference == "infinite" || reference == "undefined") {
      CHECK(quantity.settled.kind == geometry::Settled::Kind::absent);
      continue;
    }
    CHECK(quantity.settled.kind == geometry::Settled::Kind::certain);
    CHECK(quantity.settled.enclosure.value == std::stod(reference));
  }
  return compared;
}

// What cannot be drawn would show as one of these words.
inline void has_only_numbers(const std::string& svg) {
  CHECK(svg.find("<svg") != std::string::npos);
  for (const char* word : {"-nan", "=\"nan", "=\"inf", " nan ", " inf "}) CHECK(svg.find(word) == std::string::npos);
}

inline void draws_every_sheet(const std::string& id, const std::vector<Assignments>& all) {
  for (const Assignments& assignments : all)
    for (const SheetSpec& sheet : find_exercise(catalogue(), id).about().sheets)
      for (const drawings::Paper paper : {drawings::Paper::a4, drawings::Paper::a3})
        for (const Language language : {Language::english, Language::italian}) {
          CAPTURE(assignments, sheet.name, paper == drawings::Paper::a4, language == Language::english);
          std::string bytes;
          CHECK_NOTHROW(
              bytes = drawings::svg(draw(id, sheet.name, assignments, {.paper = paper, .language = language}).sheet));
          has_only_numbers(bytes);
        }
}

inline void letters_find_room(const std::string& id, const std::vector<Assignments>& all) {
  for (const Assignments& assignments : all)
    for (const SheetSpec& sheet : find_exercise(catalogue(), id).about().sheets)
      for (const drawings::Paper paper : {drawings::Paper::a4, drawings::Paper::a3})
        for (const Language language : {Language::english, Language::italian}) {
          const auto crowded =
              drawings::overlaps(draw(id, sheet.name, assignments, {.paper = paper, .language = language}).sheet);
          CAPTURE(assignments, sheet.name, paper == drawings::Paper::a4, language == Language::english, crowded);
          CHECK(crowded.empty());
        }
}

}  // namespace epure::tests
