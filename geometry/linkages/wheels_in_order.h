// In which order a linkage with gears is constructed so that its forces are found one after the other: each wheel
// after the one wheel that its own place in the gears is told by, and after what carries both. Then in the reverse of
// that order all but one of the forces in a wheel's teeth are known, and its moments about its centre give that one.
#pragma once

#include <vector>

#include "geometry/linkages/assur_groups.h"

namespace epure::geometry {

struct WheelsInOrder {
  std::vector<Step> steps;
  std::vector<int> left;  // wheels whose teeth bear forces that are found only together; none: all are in order
};
WheelsInOrder wheels_in_order(const Linkage& linkage, const std::vector<Step>& steps);

}  // namespace epure::geometry
