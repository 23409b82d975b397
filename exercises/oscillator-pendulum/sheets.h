// The sheets.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::oscillator_pendulum {

PanelSheet motion_sheet(const Solution& s, Language language);
PanelSheet phase_plane_sheet(const Solution& s, Language language);
PanelSheet pendulum_plane_sheet(const Solution& s, Language language);
PanelSheet positions_sheet(const Solution& s, Language language);
PanelSheet hodograph_sheet(const Solution& s, Language language);
PanelSheet angle_sheet(const Solution& s, Language language);

}  // namespace epure::oscillator_pendulum
