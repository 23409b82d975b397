// The sheets of the pump.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::pump_flywheel {

PanelSheet torque_sheet(const Solution& s, Language language);

}  // namespace epure::pump_flywheel
