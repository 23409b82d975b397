// The parts of the exercise: what its source printed, and its sheets.
#pragma once

#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/statement/description.h"
#include "exercises/point-mass/problem.h"

namespace epure::point_mass {

std::vector<Printed> printed_by_the_source();
std::vector<TableAudit> audit_of_the_table();

// The source's columns of v and s as its mistakes give them, beside the exact ones.
struct PrintedAgainstExact {
  std::string kind, method;
  std::vector<Rational> printed, exact;
};
std::vector<PrintedAgainstExact> printed_columns();

PanelSheet integration_sheet(const Solution& s, Language language);
PanelSheet tangents_sheet(const Solution& s, Language language);
PanelSheet curves_sheet(const Solution& s, Language language);
PanelSheet errors_sheet(const Solution& s, Language language);
PanelSheet table_sheet(const Solution& s, Language language);
LongTable long_table(const Solution& s);

}  // namespace epure::point_mass
