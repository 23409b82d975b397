// The sheets of the landing.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::aircraft_landing {

PanelSheet forces_sheet(const Solution& s, Language language);
PanelSheet wheel_sheet(const Solution& s, Language language);
PanelSheet slip_sheet(const Solution& s, Language language);
PanelSheet euler_sheet(const Solution& s, Language language);
PanelSheet integration_sheet(const Solution& s, Language language);

// What a negative friction of the rolling wheel means; empty of a positive one.
Words sense_after(const Solution& s);

// Where friction acts on a wheel of this radius, drawn: in the line of the ground its arrow would be lost.
Place just_above_ground(double R);

}  // namespace epure::aircraft_landing
