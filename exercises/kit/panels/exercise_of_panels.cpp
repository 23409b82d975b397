#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "exercises/kit/panels/long_table_panel.h"
#include "exercises/kit/panels/panels_of.h"

namespace epure {
namespace {

// The table after the panels of the first page, a page of it after the other; each is told which of them it is.
DrawnSheet over_pages(const Description& about, const std::string& sheet, const Solution& solution, PanelSheet first,
                      const LongTable& table, const SheetRequest& request) {
  const std::size_t rows = rows_of_a_page(request.paper, table.columns.size()),
                    pages = request.blank ? 1 : std::max<std::size_t>(1, (table.rows() + rows - 1) / rows);
  const auto page_of = [&](std::size_t page, PanelSheet shown) {
    shown.panels.push_back(std::make_unique<LongTablePanel>(table, page * rows, request));
    DrawnSheet drawn = arrange(about, sheet, solution, shown, request);
    if (pages > 1) drawn.sheet.title_block.sheet += fmt::format(" ({}/{})", page + 1, pages);
    if (page > 0) drawn.sheet.id += fmt::format("-{}", page + 1);
    return drawn;
  };
  const PanelSheet further{.theory = first.theory, .seen = first.seen, .without_part = first.without_part};
  DrawnSheet drawn = page_of(0, std::move(first));
  for (std::size_t page = 1; page < pages; ++page)
    drawn.further.push_back(
        page_of(page, {.theory = further.theory, .seen = further.seen, .without_part = further.without_part}).sheet);
  return drawn;
}

std::vector<RouteValue> solved(const std::vector<PartOfExercise>& parts, const Givens& givens, Rung rung) {
  std::vector<RouteValue> all;
  for (const PartOfExercise& part : parts)
    for (RouteValue& value : part.solve(givens, rung)) all.push_back(std::move(value));
  return all;
}

// Every quantity once: what the first route says of it counts.
std::vector<Quantity> reported(const std::vector<PartOfExercise>& parts, const std::vector<GivenSpec>& givens) {
  std::vector<Quantity> quantities;
  std::set<std::string> names;
  for (RouteValue& value : solved(parts, Givens(givens), Rung::names))
    if (names.insert(value.quantity).second && value.described) quantities.push_back(std::move(*value.described));
  return quantities;
}

class ExerciseOfPanels : public Exercise {
 public:
  ExerciseOfPanels(Description about, std::vector<PartOfExercise> parts, std::vector<SheetMaker> sheets,
                   FindFlaws flaws)
      : about_(std::move(about)), parts_(std::move(parts)), sheets_(std::move(sheets)), flaws_(std::move(flaws)) {
    for (const SheetMaker& sheet : sheets_) about_.sheets.push_back(sheet.spec);
    about_.quantities = [parts = parts_, givens = about_.givens] { return reported(parts, givens); };
  }

  const Description& about() const override { return about_; }
  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return solved(parts_, givens, rung);
  }
  std::vector<Flaw> flaws(const Givens& givens) const override {
    return flaws_ ? flaws_(givens) : std::vector<Flaw>{};
  }
  Solution solution(const Givens& givens) const override {
    if (parts_.size() == 1) return {givens, parts_.front().solve(givens, Rung::drawing)};
    std::vector<Solution::FindPart> parts;
    for (const auto& [of_case, solve] : parts_)
      parts.push_back({of_case, [=, &solve = solve] { return solve(givens, Rung::drawing); }});
    return {givens, parts};
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const SheetMaker& maker = maker_of(sheet);
    PanelSheet first = maker.make(solution, request.language);
    if (!maker.table) return arrange(about_, sheet, solution, first, request);
    return over_pages(about_, sheet, solution, std::move(first), maker.table(solution), request);
  }

  PanelSheet panels(const std::string& sheet, const Solution& solution, Language language) const {
    return maker_of(sheet).make(solution, language);
  }

  std::optional<LongTable> long_table(const std::string& sheet, const Solution& solution) const override {
    const SheetMaker& maker = maker_of(sheet);
    return maker.table ? std::optional(maker.table(solution)) : std::nullopt;
  }

 private:
  const SheetMaker& maker_of(const std::string& sheet) const {
    return *std::find_if(sheets_.begin(), sheets_.end(),
                         [&](const SheetMaker& each) { return each.spec.name == sheet; });
  }

  Description about_;
  std::vector<PartOfExercise> parts_;
  std::vector<SheetMaker> sheets_;
  FindFlaws flaws_;
};

}  // namespace

std::optional<PanelSheet> panel_sheet(const Exercise& exercise, const std::string& sheet, const Solution& solution,
                                      Language language) {
  const auto* of_panels = dynamic_cast<const ExerciseOfPanels*>(&exercise);
  return of_panels ? std::optional(of_panels->panels(sheet, solution, language)) : std::nullopt;
}

std::unique_ptr<Exercise> exercise_of_panels(Description about, Solve solve, std::vector<SheetMaker> sheets,
                                             FindFlaws flaws) {
  std::vector<PartOfExercise> whole{{"", std::move(solve)}};
  return exercise_of_panels(std::move(about), std::move(whole), std::move(sheets), std::move(flaws));
}

std::unique_ptr<Exercise> exercise_of_panels(Description about, std::vector<PartOfExercise> parts,
                                             std::vector<SheetMaker> sheets, FindFlaws flaws) {
  return std::make_unique<ExerciseOfPanels>(std::move(about), std::move(parts), std::move(sheets), std::move(flaws));
}

}  // namespace epure
