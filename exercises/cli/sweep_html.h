// A sweep as a page for a browser: the mechanism at each position, the quantities over it, and their values.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/sweep_chart.h"
#include "exercises/cli/sweep_row.h"

namespace epure {

// A page bears so many positions.
inline constexpr std::uint64_t most_positions_of_page = 721;

// One file that needs no other; `rows`: all of the study, in order. Printed, the position that is shown is at true
// scale. Where no sheet shows a mechanism, there are the charts and values alone.
std::string sweep_html(const SweepStudy& study, const std::vector<SweptRow>& rows, const SweepChart& chart,
                       Language language);

}  // namespace epure
