#include "exercises/roulette/exercise.h"

#include "exercises/kit/sheet.h"

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

// What the sheet names: without the radius of a circle that does not take part.
Givens taking_part(const Givens& givens, const Problem& problem) {
  std::vector<GivenSpec> specs;
  for (const GivenSpec& spec : givens.specs())
    if (spec.symbol != (problem.is_line() ? "r" : problem.rolls_on_line() ? "R" : "")) specs.push_back(spec);
  Givens named(specs);
  for (const GivenSpec& spec : specs) named.set(spec.symbol + "=" + givens.text(spec.symbol));
  return named;
}

class RouletteExercise : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return solved(problem_of(givens), rung);
  }

  DrawnSheet draw(const std::string& sheet, const Givens& givens, const SheetRequest& request) const override {
    const Problem problem = problem_of(givens);
    DrawnSheet onto = blank_sheet(about_, sheet, taking_part(givens, problem), request);
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
