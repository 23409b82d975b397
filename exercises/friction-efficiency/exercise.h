// What the parts of this exercise share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/friction-efficiency/problem.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure::friction_efficiency {

std::vector<RouteValue> solve(const Givens& givens, Rung rung);
std::vector<Printed> printed_by_the_source();
std::vector<SheetMaker> sheets();

// The efficiencies of all mechanisms at a friction angle (degrees), also beyond where one of them jams: for a chart.
std::vector<std::pair<std::string, double>> efficiencies_at(const Givens& givens, const Rational& degrees);

}  // namespace epure::friction_efficiency
