// The quantities that coupler_routes.h writes down, described.
#pragma once

#include "exercises/kit/statement/exercise.h"

namespace epure {

QuantitySpec metres(const std::string& name, const std::string& symbol, const Words& meaning);
QuantitySpec speed(const std::string& name, const std::string& symbol, const Words& meaning);
QuantitySpec acceleration(const std::string& name, const std::string& symbol, const Words& meaning);

// Abscissa and ordinate of a point, `symbol` its letters within a subscript: "B", "P31".
std::vector<QuantitySpec> coordinates(const std::string& name, const std::string& symbol, const Words& of);
// Components and size of a vector: "v_C", symbol "v", subscript "C".
std::vector<QuantitySpec> components(const std::string& name, const std::string& letter, const std::string& subscript,
                                     const std::string& unit, const Words& of);

// Of write_pole, write_acceleration_pole, write_circles and write_curvature. `points` are the letters of the points.
std::vector<QuantitySpec> pole_quantities(const std::string& pole, const std::string& symbol,
                                          const std::vector<std::string>& points);
std::vector<QuantitySpec> acceleration_pole_quantities(const std::vector<std::string>& points);
std::vector<QuantitySpec> circle_quantities();
std::vector<QuantitySpec> curvature_quantities(const std::string& point, const std::string& symbol);

// The same quantities in a case of the exercise: the names after "dead_centre_folded.", the meaning followed by
// which.
std::vector<QuantitySpec> in_case(const std::string& prefix, const Words& which,
                                  std::vector<QuantitySpec> quantities);

// One list after the other.
std::vector<QuantitySpec> joined(const std::vector<std::vector<QuantitySpec>>& groups);

}  // namespace epure
