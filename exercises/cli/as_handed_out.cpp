#include "exercises/cli/as_handed_out.h"

#include <optional>

#include "exercises/kit/panels/fit.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace {

// On the smallest paper that has room for it, as the key does not say on which it was.
struct OnPaper {
  drawings::Paper paper;
  std::vector<Measurement> measurements;
};
std::optional<OnPaper> drawn_at(const Rational& scale, const Exercise& exercise, const std::string& sheet,
                                const Solution& solution) {
  for (const drawings::Paper paper : {drawings::Paper::a4, drawings::Paper::a3}) {
    try {
      SheetRequest request;
      request.paper = paper;
      request.scale = scale;
      return OnPaper{paper, exercise.draw(sheet, solution, request).measurements};
    } catch (const DoesNotFit&) {
      // then on the larger one
    }
  }
  return std::nullopt;
}

}  // namespace

void measure_as_handed_out(CheckedExercise& checked, const Exercise& exercise,
                           const std::map<std::string, Rational>& scales) {
  if (scales.empty()) return;
  const Solution solution = exercise.solution(checked.givens);
  for (const auto& [sheet, scale] : scales) {
    const auto drawn = drawn_at(scale, exercise, sheet, solution);
    if (!drawn) continue;
    for (CheckedQuantity& quantity : checked.quantities) {
      std::erase_if(quantity.on_sheets, [&sheet = sheet](const OnSheet& each) { return each.sheet == sheet; });
      for (const Measurement& each : drawn->measurements)
        if (each.quantity == quantity.spec.name) quantity.on_sheets.push_back(measure(each, sheet, drawn->paper));
    }
  }
}

}  // namespace epure
