// The sheets, a file for each mechanism, and what they share.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "exercises/ideal-statics/quantities.h"
#include "exercises/kit/linkages/case_of_mechanism.h"
#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/panels/polygon_panel.h"

namespace epure::ideal_statics {

using namespace loaded;

// Told beside what the sheet finds, and not asked: another sheet finds it.
inline Result for_comparison(const Result& result) {
  return [result](const Solution& s, Language language) { return result(s, language); };
}

std::vector<SheetMaker> wedge_sheets();
std::vector<SheetMaker> double_slider_sheets();
std::vector<SheetMaker> lever_sheets();
std::vector<SheetMaker> fairbairn_sheets();

}  // namespace epure::ideal_statics
