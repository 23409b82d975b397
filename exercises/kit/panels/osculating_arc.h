// The osculating circle of a path beside the point of the path, where the two can be told apart or not. All of it
// would be taken for a path or a body, and hide what it crosses.
#pragma once

#include "exercises/kit/panels/plot.h"

namespace epure {

constexpr double beside_piece_of_path = 28, beside_whole_path = 60;  // mm of the arc to each side of the point

void draw_osculating_arc(Plot& plot, const Place& X, const Place& centre, double half_length = beside_piece_of_path,
                         const std::string& name = {});

}  // namespace epure
