// The arc arrow of a crank: clear of the crank and of the hatched support it turns in.
#pragma once

#include <cmath>
#include <numbers>

#include "exercises/kit/proof/exercise.h"
#include "tests/support/catch.h"

namespace epure::tests {

// Radians from `direction` to the nearest place of the arc; 0 on it.
inline double apart(const drawings::Rotation& arc, double direction) {
  const double middle = (arc.from + arc.to) / 2, half = std::abs(arc.to - arc.from) / 2;
  return std::max(0.0, std::abs(std::remainder(direction - middle, 2 * std::numbers::pi)) - half);
}

// Of the first hinge that the sheet shows with such an arrow; `crank` is the direction of its link.
inline void arc_arrow_is_clear(const DrawnSheet& drawn, double crank) {
  // The hatching's corner: 5 mm beside the hinge and 7 below it, seen from the hinge.
  const double half_support = std::atan2(5.0, 7.0);
  for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
    const auto* arc = std::get_if<drawings::Rotation>(&mark);
    if (!arc || arc->meaning != drawings::Meaning::link) continue;  // else an angle
    for (const drawings::Mark& other : drawn.sheet.figure.marks) {
      const auto* hinge = std::get_if<drawings::FixedHinge>(&other);
      if (!hinge || std::hypot(hinge->at.x - arc->centre.x, hinge->at.y - arc->centre.y) > 1e-9) continue;
      CHECK(apart(*arc, hinge->down) > half_support);
      CHECK(apart(*arc, crank) > 0.3);
      CHECK(std::abs(std::remainder(hinge->down - crank, 2 * std::numbers::pi)) > half_support);
      return;
    }
  }
  FAIL("no arc arrow at a support");
}

}  // namespace epure::tests
