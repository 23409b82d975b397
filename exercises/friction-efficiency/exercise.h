// What the parts of this exercise share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/friction-efficiency/problem.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure::friction_efficiency {

std::vector<PartOfExercise> parts();
std::vector<Printed> printed_by_the_source();
std::vector<SheetMaker> sheets();

// Of these quantities of a case those that have a value at the friction angles of 1°, 2° ... up to `most`, also
// beyond where a mechanism jams: for a chart.
using ValuesByName = std::vector<std::pair<std::string, double>>;
std::vector<ValuesByName> values_at_friction_angles(const Givens& givens, int most, const std::string& of_case,
                                                    const std::vector<std::string>& names);

}  // namespace epure::friction_efficiency
