// The base tangent: what a workshop measures over k teeth, between faces that touch flanks of both sides.
#pragma once

#include "exercises/kit/panels/rounded.h"
#include "geometry/gears/tooth_thickness.h"

namespace epure::gear_pair {

using geometry::Deep;
using geometry::Rational;

struct BaseTangent {
  long teeth;
  Deep length;
};

// The faces touch half of its length from its middle: k is chosen so that this is nearest to the middle of the teeth.
// Throws Impossible for a ring, and when the faces would find no flank. `wheel` is no rack.
inline BaseTangent base_tangent(const geometry::GearPair<Deep>& pair, int wheel) {
  const geometry::WheelData data = wheel == 1 ? first_wheel(pair.given) : second_wheel(pair.given);
  const auto& circles = wheel == 1 ? pair.wheel1 : *pair.wheel2;
  const geometry::Impossible none("there is no base tangent: its faces would find no flank",
                                  "non c'è scartamento: le sue facce non troverebbero fianchi");
  if (data.ring || data.z < 4) throw none;
  const Deep on_base = base_thickness(pair, wheel),
             pitch = geometry::quotient(Deep(2) * geometry::pi<Deep>() * circles.r_b,
                                        geometry::from_rational<Deep>(Rational(data.z)));
  const double r_b = to_double(circles.r_b), middle = CGAL::to_double(data.r + data.m * data.x);
  if (middle <= r_b) throw none;
  const double wanted = 2 * std::sqrt((middle - r_b) * (middle + r_b));
  const long k = std::clamp(std::lround((wanted - to_double(on_base)) / to_double(pitch)) + 1, 2L, data.z / 2);
  const Deep length = geometry::from_rational<Deep>(Rational(k - 1)) * pitch + on_base;
  const double touched = std::hypot(r_b, to_double(length) / 2);
  if (touched <= std::max(CGAL::to_double(data.r_root), r_b) || touched >= CGAL::to_double(data.r_tip)) throw none;
  return {k, length};
}

}  // namespace epure::gear_pair
