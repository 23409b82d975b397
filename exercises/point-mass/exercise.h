// The parts of the exercise: what its source printed, and its sheets.
#pragma once

#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/statement/description.h"
#include "exercises/point-mass/problem.h"

namespace epure::point_mass {

std::vector<Printed> printed_by_the_source();
std::vector<TableAudit> audit_of_the_table();

PanelSheet integration_sheet(const Solution& s, Language language);
PanelSheet tangents_sheet(const Solution& s, Language language);
PanelSheet curves_sheet(const Solution& s, Language language);

}  // namespace epure::point_mass
