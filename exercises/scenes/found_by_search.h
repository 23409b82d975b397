// What is searched for over all places of the drive, as the ledger has it; and the mechanism elsewhere.
#pragma once

#include <cmath>
#include <string>

#include "exercises/kit/proof/exercise.h"
#include "exercises/scenes/scene.h"
#include "geometry/numbers/enclosure.h"

namespace epure::scenes {

inline geometry::Settled known(const geometry::Enclosure& enclosure, const std::string& rung) {
  return {.kind = geometry::Settled::Kind::enclosed,
          .enclosure = enclosure,
          .reason = {"an extreme is closed in so far", "un estremo è racchiuso fin qui"},
          .rung = rung};
}
inline geometry::Settled known(const geometry::Deep& value) {
  const std::string rung = "Deep " + std::to_string(geometry::Arithmetic<geometry::Deep>::bits());
  const auto certain = geometry::certain_double(value);
  if (!certain) return known(geometry::enclosure(value), rung);
  geometry::Enclosure ends = geometry::enclosure(value);
  ends.value = *certain;
  return {.kind = geometry::Settled::Kind::certain, .enclosure = ends, .reason = {}, .rung = rung};
}
inline geometry::Settled undecided(const Words& why) {
  return {.kind = geometry::Settled::Kind::undecided, .enclosure = {}, .reason = why};
}

// With the drive so many turns from +x, or so many metres along.
inline void put(geometry::Drive& drive, const geometry::Rational& place) {
  if (auto* turned = std::get_if<geometry::TurnedLink>(&drive))
    turned->angle = {place, 0};
  else if (auto* slid = std::get_if<geometry::SlidPoint>(&drive))
    slid->at = place;
  else
    std::get<geometry::Stretched>(drive).length = place;
}

}  // namespace epure::scenes
