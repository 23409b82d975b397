// The sheets of the pump.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::pump_flywheel {

PanelSheet torque_sheet(const Solution& s, Language language);
PanelSheet energy_sheet(const Solution& s, Language language);
PanelSheet energy_with_mass_sheet(const Solution& s, Language language);
PanelSheet wittenbauer_sheet(const Solution& s, Language language);
PanelSheet harmonics_sheet(const Solution& s, Language language);

}  // namespace epure::pump_flywheel
