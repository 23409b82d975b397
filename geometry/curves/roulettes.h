// The paths of points carried by a rolling circle or line, as curves over φ in radians (span.h).
#pragma once

#include "geometry/curves/span.h"
#include "geometry/motion/rolling.h"

namespace epure::geometry {

struct Roulette {
  Rolling rolling;

  template <class X>
  Point<X> operator()(const X& phi) const {
    return tracing_point<X>(rolling, Radians<X>{phi});
  }
};

}  // namespace epure::geometry
