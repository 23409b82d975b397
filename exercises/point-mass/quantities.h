// What is reported, by kind and by place: "v" at an instant (v_1) or at a row of the table (v_at_7), by the exact
// motion or by one of the two formulas.
#pragma once

#include <string>

#include "exercises/kit/statement/quantity.h"

namespace epure::point_mass {

// "F", "a", "v", "q", "E", "s"; `method`: "", "bezout" or "simpson". `at`: "1", "2", "3" or, in the table, "at_7".
Quantity of_motion(const std::string& kind, const std::string& method, const std::string& at);
// (numerical - exact)/exact
Quantity error_of(const std::string& kind, const std::string& method, const std::string& at);
Quantity centroid_at(const std::string& instant);
// "t_F_max", "v_max", "impulse_positive", ...; within the case of the graphical integration "pole_distance_v", "v_1".
Quantity extreme(const std::string& name);
Quantity pole_distance(const std::string& kind);
// Only told: how far the polygon's end lies above the true curve.
Quantity distance_of_polygon(const std::string& kind);
Quantity ordinate_of_polygon(const std::string& kind, const std::string& instant);

}  // namespace epure::point_mass
