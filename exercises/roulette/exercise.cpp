#include "exercises/roulette/exercise.h"

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace roulette {
namespace {

Description description() {
  return {.id = "roulette",
          .title = {"A point carried by a rolling circle", "Un punto portato da un cerchio che rotola"},
          .document = "epure",
          .item = "roulettes",
          .source = {"epure, roulettes", "epure, curve di rotolamento"},
          .givens = given_specs(),
          .sheets = {{"path", {"Path of the point", "Traiettoria del punto"}},
                     {"instant", {"Velocity, acceleration, curvature", "Velocità, accelerazione, curvatura"}}},
          .quantities = quantity_specs(),
          .printed = {}};
}

// A line has no radius.
std::set<std::string> without_part(const Problem& problem) {
  if (problem.is_line()) return {"r"};
  if (problem.rolls_on_line()) return {"R"};
  return {};
}

class RouletteExercise : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return solved(problem_of(givens), rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Problem problem = problem_of(givens);
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request, without_part(problem));
    if (sheet == "path") draw_path_sheet(onto, problem, request);
    if (sheet == "instant") draw_instant_sheet(onto, problem, request);
    return onto;
  }

 private:
  Description about_ = description();
};

}  // namespace
}  // namespace roulette

std::unique_ptr<Exercise> make_roulette() { return std::make_unique<roulette::RouletteExercise>(); }

}  // namespace epure
