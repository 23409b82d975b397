// The parts of the exercise: what its source printed, and its sheets.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/statement/description.h"
#include "exercises/kit/statement/table_audit.h"
#include "exercises/michell-bearing/problem.h"
#include "exercises/michell-bearing/quantities.h"

namespace epure::michell_bearing {

std::vector<Printed> printed_by_the_source();
std::vector<TableAudit> audits();  // of its two tables

inline std::string of_film(const std::string& quantity) { return "inverse." + quantity; }
inline std::string of_pad(const std::string& quantity) { return "direct." + quantity; }
inline Result told(const Words& words, Language language) { return remark(words.in(language)); }

PanelSheet pressures_sheet(const Solution& s, Language language);
PanelSheet integration_sheet(const Solution& s, Language language);
PanelSheet load_sheet(const Solution& s, Language language);
PanelSheet velocities_sheet(const Solution& s, Language language);
PanelSheet direct_sheet(const Solution& s, Language language);
PanelSheet bearing_sheet(const Solution& s, Language language);

}  // namespace epure::michell_bearing
