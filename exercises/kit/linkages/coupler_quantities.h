// The quantities that coupler_routes.h writes down, described.
#pragma once

#include "exercises/kit/proof/exercise.h"

namespace epure {

Quantity metres(const std::string& name, const std::string& symbol, const Words& meaning);
Quantity speed(const std::string& name, const std::string& symbol, const Words& meaning);
Quantity acceleration(const std::string& name, const std::string& symbol, const Words& meaning);

// Abscissa and ordinate of a point, `symbol` its letters within a subscript: "B", "P31".
std::vector<Quantity> coordinates(const std::string& name, const std::string& symbol, const Words& of);
// Components and size of a vector: "v_C", symbol "v", subscript "C".
std::vector<Quantity> components(const std::string& name, const std::string& letter, const std::string& subscript,
                                 const std::string& unit, const Words& of);

// Of write_pole, write_acceleration_pole, write_circles and write_curvature. `points` are the letters of the points.
std::vector<Quantity> pole_quantities(const std::string& pole, const std::string& symbol,
                                      const std::vector<std::string>& points);
std::vector<Quantity> acceleration_pole_quantities(const std::vector<std::string>& points);
std::vector<Quantity> circle_quantities();
std::vector<Quantity> curvature_quantities(const std::string& point, const std::string& symbol);

// The same quantities in a case of the exercise: the names after "dead_centre_folded.", the meaning followed by
// which.
std::vector<Quantity> in_case(const std::string& prefix, const Words& which, std::vector<Quantity> quantities);

// One list after the other.
std::vector<Quantity> joined(const std::vector<std::vector<Quantity>>& groups);

}  // namespace epure
