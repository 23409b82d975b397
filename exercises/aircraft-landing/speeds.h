// Speeds as they are drawn: the closed form between its ends.
#pragma once

#include <vector>

#include "drawings/charts/chart.h"
#include "exercises/aircraft-landing/landing.h"
#include "exercises/kit/proof/solution.h"

namespace epure::aircraft_landing {

struct SpeedsAt {
  double t, v, rim;
  double lost;  // v_0 - v, which doubles could not tell where it is small
};

// At equal steps from touch-down until slip ends.
std::vector<SpeedsAt> speeds_until_slip_ends(const Solution& s, int steps);

// Of a chart: (t, v) and (t, ω R).
std::vector<drawings::Datum> of_aircraft(const std::vector<SpeedsAt>& all);
std::vector<drawings::Datum> of_rim(const std::vector<SpeedsAt>& all);

// Both speeds over time up to `last`, from `low` to `high`: until slip ends, and then the one that is left.
drawings::Chart chart_of_speeds(const Solution& s, double last, double low, double high);

}  // namespace epure::aircraft_landing
