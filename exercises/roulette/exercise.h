// A point M carried by a circle or a line that rolls without slipping: its path, and at one instant its velocity, its
// acceleration and the centre of curvature of the path, from the inflection circle. No book's exercise: every given
// is the user's. Metres, seconds, radians; axes and senses as in geometry/motion/rolling.h.
#pragma once

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/rolling/rolled.h"

namespace epure::roulette {

std::vector<GivenSpec> given_specs();
// Throws BadGivens for a circle that does not fit into the other, or a distance that is negative.
RollingGivens rolling_of(const Givens& givens);

// "curtate epicycloid": what M traces.
Words name_of_path(const RollingGivens& given);

// The bodies at the start and at the instant, and the path with the points it is built from and its cusps.
PanelSheet path_sheet(const Solution& solution, Language language);

}  // namespace epure::roulette
