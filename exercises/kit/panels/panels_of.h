// The panels that a sheet consists of, for who draws them otherwise than as a sheet.
#pragma once

#include <optional>
#include <string>

#include "exercises/kit/panels/panel_sheet.h"

namespace epure {

// None of an exercise that is not made of panels.
std::optional<PanelSheet> panel_sheet(const Exercise& exercise, const std::string& sheet, const Solution& solution,
                                      Language language);

}  // namespace epure
