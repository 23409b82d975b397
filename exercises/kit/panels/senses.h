// Where the arc arrows of links that turn stand.
#pragma once

#include "exercises/kit/panels/mechanism_figure.h"

namespace epure {

constexpr double sweep_of_arrow = 1.3;  // radians

// The arrows that draw_sense_of_crank and draw_sense_of_turning draw.
ArcArrow sense_of_crank(const Place& A0, const Place& A, double sense, const std::string& symbol, double support);
ArcArrow sense_of_turning(const Place& centre, const Place& P, double sense, const std::string& symbol);

}  // namespace epure
