#include <algorithm>
#include <utility>

#include "exercises/kit/panels/panel_sheet.h"

namespace epure {
namespace {

class ExerciseOfPanels : public Exercise {
 public:
  ExerciseOfPanels(Description about, Solve solve, std::vector<SheetMaker> sheets, FindFlaws flaws)
      : about_(std::move(about)), solve_(std::move(solve)), sheets_(std::move(sheets)), flaws_(std::move(flaws)) {
    for (const SheetMaker& sheet : sheets_) about_.sheets.push_back(sheet.spec);
    const Solution stated(Givens(about_.givens), solve_(Givens(about_.givens), Rung::fast));
    for (const RouteValue& value : stated.values())
      if (value.described) about_.quantities.push_back(*value.described);
  }

  const Description& about() const override { return about_; }
  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override { return solve_(givens, rung); }
  std::vector<Flaw> flaws(const Givens& givens) const override {
    return flaws_ ? flaws_(givens) : std::vector<Flaw>{};
  }
  Solution solution(const Givens& givens) const override { return {givens, solve_(givens, Rung::drawing)}; }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const auto maker =
        std::find_if(sheets_.begin(), sheets_.end(), [&](const SheetMaker& each) { return each.spec.name == sheet; });
    return arrange(about_, sheet, solution, maker->make(solution, request.language), request);
  }

 private:
  Description about_;
  Solve solve_;
  std::vector<SheetMaker> sheets_;
  FindFlaws flaws_;
};

}  // namespace

std::unique_ptr<Exercise> exercise_of_panels(Description about, Solve solve, std::vector<SheetMaker> sheets,
                                             FindFlaws flaws) {
  return std::make_unique<ExerciseOfPanels>(std::move(about), std::move(solve), std::move(sheets), std::move(flaws));
}

}  // namespace epure
