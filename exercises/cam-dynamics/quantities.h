// What is reported of the cam and its follower: bodies 1 (frame), 2 (cam), 3 (follower); B2 and B3 are the points of
// cam and follower at the roller's centre.
#pragma once

#include "exercises/kit/statement/forces.h"
#include "exercises/kit/statement/quantity.h"

namespace epure::cam_dynamics {

// One of the exercise's single numbers. `name` must be one of them.
const Quantity& quantity(const std::string& name);
// y_B less its least, with A₀A at so many degrees.
Quantity lift_at(int degrees);

VectorQuantity moving(const std::string& name);  // "v_B32", "a_coriolis"
VectorQuantity force(const std::string& name);   // "R_23", "F_2_in", "P_3", "P"

}  // namespace epure::cam_dynamics
