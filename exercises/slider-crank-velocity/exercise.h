// N.1 of the Sapienza sheets: velocities of the slider-crank by poles and by the polar diagram, polodes, and
// the path of a coupler point.
#pragma once

#include <memory>

#include "exercises/kit/linkages/slider_crank_instant.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure::slider_crank_velocity {

std::vector<Printed> printed_by_the_source();

// The two sheets of curves; they keep what they need of the solution.
PanelSheet polodes_sheet(const Solution& solution, Language language);
PanelSheet coupler_curve_sheet(const Solution& solution, Language language);

}  // namespace epure::slider_crank_velocity
