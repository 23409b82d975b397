// The greatest and the least that quantities become over a turn of the drive, and where: extremes: [theta_4, v_C_x].
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "exercises/kit/proof/exercise.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Of which quantities they can be asked: what a drive sets (range_of_drive.h); where the only one is a turned link,
// coordinates of points and directions of links, and how fast these change.
std::vector<std::string> with_extremes(const Built& built);

// Whether it tells how fast another changes: at its extreme the mechanism has no limit position.
bool is_rate(const Built& built, const std::string& quantity);

// "theta_4_max", "theta_4_min", and the direction of the drive where it is so: "theta_4_max_at".
std::string extreme_name(const std::string& quantity, bool is_greatest);
std::string place_of_extreme(const std::string& quantity, bool is_greatest);
// "$θ_{4}$" to "$θ_{4,max}$", "$A$" to "$A_{max}$".
std::string symbol_of_extreme(const std::string& symbol, bool is_greatest);

// Of each name, one of with_extremes, by the construction and by the equations of all joints. Velocities are those
// with which it turns steadily. Absent, with the reason, where it does not turn right round, or a quantity grows or
// falls without end.
std::vector<RouteValue> extremes(const Built& built, const std::vector<std::string>& names, Rung rung);

}  // namespace epure::scenes
