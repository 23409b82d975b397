// The angles of coupler and rocker where one of them may point along -x.
#pragma once

#include "exercises/kit/linkages/angles.h"

namespace epure {

// Links that point along -x exactly: their angle is π, which no enclosure can tell from -π.
struct HalfTurned {
  bool coupler = false, rocker = false;
};

// Coupler A -> B; the rocker in the sense in which the exercise measures its angle.
template <class T>
struct LinkDirections {
  geometry::Vector<T> coupler, rocker;
};
// `find<T>()` returns LinkDirections<T>. What no number can tell is taken for no half turn.
template <class Find>
HalfTurned half_turned(const Find& find) {
  using geometry::Sign;
  const auto points_back = [&](const auto& of) {
    return geometry::decide([&]<class T>() -> T { return of(find.template operator()<T>()).y; }).sign == Sign::zero &&
           geometry::decide([&]<class T>() -> T { return of(find.template operator()<T>()).x; }).sign ==
               Sign::negative;
  };
  return {points_back([](const auto& links) { return links.coupler; }),
          points_back([](const auto& links) { return links.rocker; })};
}

template <class T>
T angle_or_half_turn(const geometry::Vector<T>& v, bool is_half_turn) {
  if (!is_half_turn) return angle_of(v);
  if constexpr (signs_only<T>) {
    return T(1);  // not zero
  } else {
    return geometry::pi<T>();
  }
}

}  // namespace epure
