// The parts of the exercise: what its source printed, and its sheets.
#pragma once

#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/statement/description.h"
#include "exercises/michell-thrust/problem.h"

namespace epure::michell_thrust {

std::vector<Printed> printed_by_the_source();

PanelSheet coefficients_sheet(const Solution& s, Language language);
PanelSheet pad_sheet(const Solution& s, Language language);
PanelSheet forces_sheet(const Solution& s, Language language);

}  // namespace epure::michell_thrust
