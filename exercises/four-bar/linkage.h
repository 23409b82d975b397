// The linkage of a sheet: of the instant, or of a case by the prefix of its names.
#pragma once

#include "exercises/four-bar/exercise.h"
#include "exercises/kit/linkages/four_bar_mechanism.h"
#include "exercises/kit/panels/polygon_panel.h"

namespace epure::four_bar {

// With the senses in which coupler and rocker turn: by "omega", by "alpha", or none; and the angle of the crank.
std::shared_ptr<const Mechanism> linkage(const Solution& solution, const std::string& rate = {},
                                         const std::string& of_case = {}, bool marks_phi = true);

// The polygon of the accelerations of a case, with c', or with as many primes as these.
PolygonPanel acceleration_panel(const Solution& solution, const std::string& of_case, const std::string& primes);

template <class OfQuantity>
OfQuantity of_case(const std::string& prefix, OfQuantity quantity) {
  quantity.name = prefix + quantity.name;
  return quantity;
}

// Givens that have no part in a sheet: those of the other exercise of the source, and more.
inline std::set<std::string> without(std::set<std::string> more = {}) {
  more.insert("lambda");
  return more;
}

}  // namespace epure::four_bar
