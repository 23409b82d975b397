// What the parts of the exercise hand each other.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::cam_dynamics {

std::vector<Printed> printed_by_the_source();

PanelSheet velocity_sheet(const Solution& s, Language language);
PanelSheet acceleration_sheet(const Solution& s, Language language);
PanelSheet forces_sheet(const Solution& s, Language language);
PanelSheet torque_sheet(const Solution& s, Language language);
PanelSheet maximum_lift_sheet(const Solution& s, Language language);
PanelSheet lift_sheet(const Solution& s, Language language);
PanelSheet closing_force_sheet(const Solution& s, Language language);

}  // namespace epure::cam_dynamics
