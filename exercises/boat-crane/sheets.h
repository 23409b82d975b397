// The crane's sheets.
#pragma once

#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure::boat_crane {

// Beam and column on their supports, with the boat's weight: all that a student starts from.
FreeBodyPanel loaded_crane(const Solution& s);

PanelSheet reactions_sheet(const Solution& s, Language language);
PanelSheet elastic_sheet(const Solution& s, Language language);
PanelSheet section_sheet(const Solution& s, Language language);
PanelSheet fatigue_sheet(const Solution& s, Language language);
PanelSheet buckling_sheet(const Solution& s, Language language);
PanelSheet checks_sheet(const Solution& s, Language language);

}  // namespace epure::boat_crane
