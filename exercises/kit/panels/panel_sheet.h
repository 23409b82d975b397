// A sheet as a list of panels, and an exercise whose sheets are such lists.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/results.h"

namespace epure {

// What the column tells under a heading of its own.
struct Section {
  Words heading;
  std::vector<Result> lines;
};

struct PanelSheet {
  Panels panels = {};                // in the order of reading, and of their steps
  std::vector<Result> legend = {};   // what the givens' letters mean, told under them: the first way that has room
  std::vector<Section> first = {};   // before all else: that the mechanism cannot work
  std::vector<Section> theory = {};  // before the results
  std::vector<Result> results = {};
  Words seen = {};                          // for who does not see the sheet: what is on it ...
  std::vector<std::string> told = {};       // ... and the quantities then told
  std::set<std::string> without_part = {};  // givens that are not shown, as they have none here
  Words title = {};                         // of the exercise, where these givens make it another
};

// A sheet and how it is made from what the exercise has found.
struct SheetMaker {
  SheetSpec spec;
  std::function<PanelSheet(const Solution&, Language)> make;
  // Shown after the sheet's panels, which are on its first page; on further ones it stands alone, with the theory.
  std::function<LongTable(const Solution&)> table = {};
};

using Solve = std::function<std::vector<RouteValue>(const Givens&, Rung)>;
using FindFlaws = std::function<std::vector<Flaw>(const Givens&)>;

// The sheets and quantities of the description are taken from the makers and from what the routes write.
// `flaws`: none for a mechanism that always works.
std::unique_ptr<Exercise> exercise_of_panels(Description about, Solve solve, std::vector<SheetMaker> sheets,
                                             FindFlaws flaws = {});
// The quantities of one case, those of which the names begin with "case."; or those without a case.
struct PartOfExercise {
  std::string of_case;
  Solve solve;
};
// The same in parts: a drawing finds the first, and those that its sheets take numbers from.
std::unique_ptr<Exercise> exercise_of_panels(Description about, std::vector<PartOfExercise> parts,
                                             std::vector<SheetMaker> sheets, FindFlaws flaws = {});

// Places the panels side by side or one below the other, whichever leaves them larger, each at a standard scale, and
// writes the column, the scale bars and the description. A scale asked for is that of the first panel with lengths.
// Throws DoesNotFit.
DrawnSheet arrange(const Description& about, const std::string& sheet, const Solution& solution,
                   const PanelSheet& shown, const SheetRequest& request);

}  // namespace epure
