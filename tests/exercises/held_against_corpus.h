// An exercise of the catalogue held against its corpus, and what every sheet must stand: for exercises whose corpus
// names givens and quantities as the exercise does.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "drawings/output.h"
#include "drawings/paths/vectors.h"
#include "exercises/cli/catalogue.h"
#include "exercises/kit/proof/checked.h"
#include "geometry/numbers/given.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"
#include "tests/support/read_svg.h"

namespace epure::tests {

using Assignments = std::vector<std::string>;

class Tried {
 public:
  explicit Tried(const std::string& id) : exercise_(find_exercise(catalogue(), id)) {}

  const Description& about() const { return exercise_.about(); }
  Givens givens(const Assignments& assignments) const {
    Givens all(about().givens);
    for (const std::string& assignment : assignments) all.set(assignment);
    return all;
  }
  CheckedExercise checked(const Assignments& assignments) const {
    return check(exercise_, givens(assignments), Rung::climb);
  }
  DrawnSheet draw(const std::string& sheet, const Assignments& assignments, const SheetRequest& request = {}) const {
    return exercise_.draw(sheet, givens(assignments), request);
  }

 private:
  const Exercise& exercise_;
};

inline const CheckedQuantity& find(const CheckedExercise& checked, const std::string& name) {
  for (const CheckedQuantity& quantity : checked.quantities)
    if (quantity.spec.name == name) return quantity;
  throw std::logic_error("no quantity " + name);
}
inline double value(const CheckedExercise& checked, const std::string& name) {
  return find(checked, name).settled.enclosure.value;
}

// Refused with a sentence that says why.
inline void is_refused(const Tried& tried, const Assignments& assignments, const std::string& because) {
  CAPTURE(assignments, because);
  CHECK_THROWS_WITH(tried.checked(assignments), Contains(because));
}

// All is well, and one quantity does not exist, for a reason.
inline void is_absent(const Tried& tried, const Assignments& assignments, const std::string& name,
                      const std::string& because) {
  const CheckedExercise result = tried.checked(assignments);
  const geometry::Settled& settled = find(result, name).settled;
  CAPTURE(assignments, name, settled.reason.english);
  CHECK(result.passed());
  CHECK(settled.kind == geometry::Settled::Kind::absent);
  CHECK_THAT(settled.reason.english, Contains(because));
}

// How many of the numbers that the source printed are what.
struct Judged {
  int rounding = 0, reading = 0, explained = 0, unexplained = 0;
};
inline Judged judged(const CheckedExercise& checked) {
  Judged all;
  for (const CheckedQuantity& quantity : checked.quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      CHECK(verdict.explanation_holds);
      ++(verdict.verdict == Verdict::rounding  ? all.rounding
         : verdict.verdict == Verdict::reading ? all.reading
         : verdict.explanation                 ? all.explained
                                               : all.unexplained);
    }
  return all;
}

inline Assignments assignments_of(const CorpusCase& c) {
  Assignments all;
  for (const auto& [symbol, given] : c.givens) all.push_back(symbol + "=" + geometry::to_text(given));
  for (const auto& [symbol, word] : c.choices) all.push_back(symbol + "=" + word);
  return all;
}

inline double ulp(double x) {
  return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

// The value of the corpus to the last bit, by two routes at least, all of which enclose it.
inline void is_the_reference(const CheckedQuantity& quantity, const std::string& reference) {
  using geometry::Settled;
  std::set<std::string> routes;
  for (const RouteValue& route : quantity.routes) routes.insert(route.route);
  CHECK(routes.size() >= 2);
  if (reference == "infinite") {
    CHECK(quantity.settled.kind == Settled::Kind::absent);
    CHECK_FALSE(quantity.settled.reason.english.empty());
    return;
  }
  REQUIRE(quantity.settled.kind == Settled::Kind::certain);
  const double expected = std::stod(reference);
  CHECK(quantity.settled.enclosure.value == expected);
  CHECK(quantity.settled.enclosure.upper - quantity.settled.enclosure.lower <= 4 * ulp(expected));
  for (const RouteValue& route : quantity.routes) {
    CAPTURE(route.route, route.settled.reason.english);
    const auto& [lower, middle, upper] = route.settled.enclosure;
    CHECK(lower <= expected);
    CHECK(expected <= upper);
  }
}

inline void holds_against(const Tried& tried, const std::vector<CorpusCase>& corpus) {
  for (const CorpusCase& c : corpus) {
    const CheckedExercise result = tried.checked(assignments_of(c));
    CAPTURE(c.name, c.why, complaints(result));
    CHECK(result.passed());
    for (const CheckedQuantity& quantity : result.quantities) {
      const std::string reference = c.reference(quantity.spec.name);
      CAPTURE(quantity.spec.name, reference);
      REQUIRE_FALSE(reference.empty());
      is_the_reference(quantity, reference);
    }
  }
}

inline void draws_every_sheet(const Tried& tried, const std::vector<CorpusCase>& corpus) {
  for (const CorpusCase& c : corpus)
    for (const SheetSpec& sheet : tried.about().sheets)
      for (const bool bare : {false, true}) {
        CAPTURE(c.name, sheet.name, bare);
        const std::string bytes = drawings::svg(tried.draw(sheet.name, assignments_of(c), {.bare = bare}).sheet);
        CHECK(bytes.find("<svg") != std::string::npos);
        for (const char* word : {"-nan", "=\"nan", "=\"inf", " nan ", " inf "})
          CHECK(bytes.find(word) == std::string::npos);
      }
}

// Numbers on the figure that no step of the column has.
inline std::vector<int> untold_steps(const drawings::Sheet& sheet) {
  const auto is_told = [&](int number) {
    return std::any_of(sheet.column.begin(), sheet.column.end(), [&](const drawings::Block& block) {
      const auto* steps = std::get_if<drawings::Steps>(&block);
      return steps && number >= steps->first && number < steps->first + static_cast<int>(steps->lines.size());
    });
  };
  std::vector<int> untold;
  for (const drawings::StepNumber& step : sheet.figure.steps)
    if (!is_told(step.number)) untold.push_back(step.number);
  return untold;
}

inline void letters_find_room(const Tried& tried, const std::vector<Assignments>& all,
                              const std::set<std::string>& but_for = {}) {
  for (const Assignments& assignments : all)
    for (const SheetSpec& sheet : tried.about().sheets)
      if (!but_for.contains(sheet.name))
        for (const drawings::Paper paper : {drawings::Paper::a4, drawings::Paper::a3})
          for (const Language language : {Language::english, Language::italian}) {
            const DrawnSheet drawn = tried.draw(sheet.name, assignments, {.paper = paper, .language = language});
            const auto crowded = drawings::overlaps(drawn.sheet);
            CAPTURE(assignments, sheet.name, paper == drawings::Paper::a4, language == Language::english, crowded);
            CHECK(crowded.empty());
            CHECK(untold_steps(drawn.sheet) == std::vector<int>{});
          }
}

// "1 cm ≙ 2.5 m/s" of the title block, in units a millimetre.
inline double units_per_mm(const std::string& caption) {
  const auto equals = caption.find("≙");
  REQUIRE(equals != std::string::npos);
  return std::stod(caption.substr(equals + std::string("≙").size())) / 10;
}

struct Diagram {
  std::string sheet;
  std::vector<std::string> vectors;  // of a polygon: the right side's, then those of the left
};

inline drawings::Arrow arrow(const DrawnSheet& drawn, const std::string& name) {
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* found = std::get_if<drawings::Arrow>(&mark); found && found->name == name) return *found;
  throw std::logic_error("no arrow " + name);
}

// Whether a vector that ought to begin in a corner does: there, or on a track aside, where another lies on it
// (tracks.h).
inline bool begins_in(drawings::Point corner, const drawings::Arrow& vector) {
  constexpr double track = 1.5, most_tracks = 3, rounded = 1e-9;  // mm
  const drawings::Point along = drawings::unit(vector.from, vector.to), off = vector.from - corner;
  const double aside = dot(off, drawings::left_of(along)) / track;
  return std::abs(dot(off, along)) < rounded && std::abs(aside - std::round(aside)) < rounded &&
         std::abs(aside) <= most_tracks;
}
// Each vector of the right side begins where the one before ends; the sought one leads from the first corner to the
// last. The sides are rounded one by one, so the corners meet as doubles do.
inline void polygon_closes(const Tried& tried, const Diagram& diagram, const Assignments& assignments) {
  const DrawnSheet drawn = tried.draw(diagram.sheet, assignments);
  const drawings::Arrow sought = arrow(drawn, diagram.vectors.back());
  const drawings::Point first = arrow(drawn, diagram.vectors.front()).from;
  // The first side may stand aside too, of something else; then the sought one does not.
  const drawings::Point origin = begins_in(first, sought) ? first : sought.from;
  drawings::Point corner = origin;
  for (std::size_t i = 0; i + 1 < diagram.vectors.size(); ++i) {
    const drawings::Arrow side = arrow(drawn, diagram.vectors[i]);
    CAPTURE(diagram.sheet, assignments, side.name);
    CHECK(begins_in(corner, side));
    corner = corner + (side.to - side.from);
  }
  CAPTURE(diagram.sheet, assignments);
  CHECK(begins_in(origin, sought));
  const drawings::Point missed = corner - (origin + (sought.to - sought.from));
  CHECK(std::hypot(missed.x, missed.y) < 1e-9);
}

// From the tail of an arrow's shaft to the tip of its head, in the file, times the scale of vectors, the last in the
// title block, or that of a close-up. Both ends are moved to the file's grid.
inline void ruler_reads(const Tried& tried, const Diagram& diagram, const Assignments& assignments) {
  const CheckedExercise numbers = tried.checked(assignments);
  for (const drawings::Paper paper : {drawings::Paper::a4, drawings::Paper::a3}) {
    const DrawnSheet drawn = tried.draw(diagram.sheet, assignments, {.paper = paper});
    const drawings::SvgFile svg(drawings::svg(drawn.sheet));
    std::vector<double> units;
    for (const std::string& caption : drawn.sheet.title_block.scales)
      if (caption.starts_with("1 cm")) units.push_back(units_per_mm(caption));
    for (const std::string& name : diagram.vectors) {
      CAPTURE(diagram.sheet, assignments, name, paper == drawings::Paper::a4);
      const std::string id = drawn.sheet.id + "-" + name;
      const drawings::Point from = svg.points(id).front(), to = svg.points(id + "_head").front();
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      CHECK(length > 1);
      const bool is_read = std::any_of(units.begin(), units.end(), [&](double unit) {
        return std::abs(length * unit - std::abs(value(numbers, name))) <=
               1.001 * std::numbers::sqrt2 * drawings::file_resolution * unit;
      });
      CHECK(is_read);
    }
  }
}

}  // namespace epure::tests
