// The tables of both recursions beside the exact motions, row by row.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"

namespace epure::oscillator_pendulum {

// Euler's, to t = 20 s; the pendulum's, to t = 1 s. They end before where a number leaves what doubles hold.
LongTable oscillator_table(const Solution& s);
LongTable pendulum_table(const Solution& s);
PanelSheet oscillator_table_sheet(const Solution& s, Language language);
PanelSheet pendulum_table_sheet(const Solution& s, Language language);

}  // namespace epure::oscillator_pendulum
