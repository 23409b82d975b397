// What stands beside the figure of a sheet that is to be solved.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"

namespace epure {

// The quantities that it asks for, each once, in the order in which the solved sheet tells them. A sheet without
// results asks for what its other sections tell, and one that tells all in words of its own for what it tells
// somebody who does not see it.
std::vector<Result::Asked> asked_on(const Solution& solution, const PanelSheet& shown);

// The question, a table of what the sheet asks for with the units in which it is told, and a place for name, number
// and date.
std::vector<drawings::Block> problem_column(const Description& about, const Solution& solution,
                                            const PanelSheet& shown, const SheetRequest& request);

// A small cross with the letter O, where a polygon begins.
void mark_start(Plot& plot, const Place& at);

}  // namespace epure
