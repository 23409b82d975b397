// The osculating circle of a path beside the point of the path, where the two can be told apart or not. All of it
// would be taken for a path or a body, and hide what it crosses.
#pragma once

#include "exercises/kit/panels/plot.h"

namespace epure {

void draw_osculating_arc(Plot& plot, const Place& X, const Place& centre, const std::string& name = {});

}  // namespace epure
