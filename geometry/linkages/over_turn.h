// What the drive of a linkage makes over a turn of it, with its derivatives by the drive: coordinates of points,
// directions of links, and how fast these change while it turns steadily.
#pragma once

#include <optional>
#include <variant>

#include "geometry/linkages/every_place.h"
#include "geometry/linkages/stationary.h"

namespace epure::geometry {

using BoundedThird = Taylor<Bounded, 3>;
using DeepThird = Taylor<Deep, 3>;
template <>
inline BoundedThird from_rational<BoundedThird>(const Rational& value) {
  return BoundedThird(from_rational<Bounded>(value));
}
template <>
inline DeepThird from_rational<DeepThird>(const Rational& value) {
  return DeepThird(from_rational<Deep>(value));
}

template <>
inline BoundedThird pi<BoundedThird>() {
  return BoundedThird(pi<Bounded>());
}
template <>
inline DeepThird pi<DeepThird>() {
  return DeepThird(pi<Deep>());
}

struct CoordinateOfPoint {
  int point;
  bool is_x;
};
struct DirectionOfLink {
  int link;  // of its x axis
};

// The linkage, whose only drive is a turned link, and the places must outlive it. The angle is that of EveryPlace: of
// so many turns of the link it makes one. `is_rate`: not the number itself but how fast it changes, at the drive's
// angular velocity, in radians or metres a second. In a scope of Arithmetic<Bounded>.
NumberOverAngle over_turn(const EveryPlace& places, const Linkage& linkage, const std::vector<Step>& steps,
                          const std::variant<CoordinateOfPoint, DirectionOfLink>& of, bool is_rate);

}  // namespace epure::geometry
