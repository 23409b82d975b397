// The crane's sheets.
#pragma once

#include <memory>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel_sheet.h"

namespace epure::boat_crane {

// Beam and column on their supports.
std::shared_ptr<const MechanismFigure> whole_crane(const Solution& s);

PanelSheet reactions_sheet(const Solution& s, Language language);
PanelSheet elastic_sheet(const Solution& s, Language language);
PanelSheet section_sheet(const Solution& s, Language language);
PanelSheet fatigue_sheet(const Solution& s, Language language);
PanelSheet buckling_sheet(const Solution& s, Language language);
PanelSheet checks_sheet(const Solution& s, Language language);

}  // namespace epure::boat_crane
