#include "exercises/kit/drawn.h"

#include <algorithm>
#include <array>

#include "geometry/numbers/enclosure.h"

namespace epure {

using geometry::Bounded;
using geometry::Deep;
using geometry::Sign;

namespace {

bool is_nonzero(const Deep& x) {
  const Sign s = geometry::sign(x);
  return s == Sign::positive || s == Sign::negative;
}

// Two coordinates of one point, of which doubles hold the smaller one coarsely, perhaps not even its sign, when it is
// small beside the other: enough to draw them. A single number must hold by itself.
bool is_narrow_beside(const Bounded& x, const Bounded& other) {
  const auto least = [](const Bounded& of) { return std::max({of.inf(), -of.sup(), 0.0}); };
  return x.sup() - x.inf() <= geometry::known_part * std::max(least(x), least(other));
}

std::array<double, 2> together(const Deep& x, const Deep& y) {
  const auto one = [](const Deep& of, const Deep& other) {
    if (!of.is_interval() || !other.is_interval() || !is_narrow_beside(of.interval(), other.interval()))
      return to_double(of);
    const Bounded& ends = of.interval();
    return ends.inf() <= 0 && ends.sup() >= 0 ? 0 : geometry::enclosure(ends).value;
  };
  return {one(x, y), one(y, x)};
}

}  // namespace

double to_double(const Deep& x) {
  const geometry::Enclosure ends = geometry::enclosure(x);
  const bool may_be_zero = ends.lower <= 0 && ends.upper >= 0;
  return may_be_zero ? 0 : ends.value;
}
Place to_double(const geometry::Point<Deep>& P) {
  const auto [x, y] = together(P.x, P.y);
  return {x, y};
}
Arrow2 to_double(const geometry::Vector<Deep>& v) {
  const auto [x, y] = together(v.x, v.y);
  return {x, y};
}

std::optional<Place> to_double(const geometry::ProjectivePoint<Deep>& P) {
  if (!is_nonzero(P.w)) return {};
  return to_double(geometry::finite(P));
}

DrawnCycle to_double(const geometry::Cycle<Deep>& cycle) {
  const geometry::Point<Deep> origin{Deep(0), Deep(0)};
  if (is_nonzero(cycle.k)) {
    const geometry::Point<Deep> centre = geometry::finite(cycle.centre());
    const Deep radius = cycle.radius(), distance = geometry::distance(origin, centre);
    DrawnCycle circle{.centre = to_double(centre), .radius = to_double(radius)};
    if (is_nonzero(distance)) {
      const geometry::Vector<Deep> to_centre = centre - origin;
      circle.on_line = to_double(origin + geometry::quotient(distance - radius, distance) * to_centre);
      circle.along = to_double(geometry::quotient(Deep(1), distance) * geometry::quarter_turn(to_centre));
    }
    return circle;
  }
  if (!is_nonzero(geometry::square(cycle.l) + geometry::square(cycle.m))) return {};
  const auto line = cycle.straight();
  return {.on_line = to_double(geometry::foot(origin, line)), .along = to_double(line.direction())};
}

}  // namespace epure
