// The sheets of the landing.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::aircraft_landing {

PanelSheet slip_sheet(const Solution& s, Language language);

}  // namespace epure::aircraft_landing
