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

// Of these quantities of a case those that have a value at another friction angle (degrees), also beyond where a
// mechanism jams: for a chart.
std::vector<std::pair<std::string, double>> values_at_friction_angle(const Givens& givens, const Rational& degrees,
                                                                     const std::string& of_case,
                                                                     const std::vector<std::string>& names);

}  // namespace epure::friction_efficiency
