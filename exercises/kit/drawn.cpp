#include "exercises/kit/drawn.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numbers/enclosure.h"

namespace epure {

using geometry::Deep;
using geometry::Sign;

namespace {

bool is_nonzero(const Deep& x) {
  const Sign s = geometry::sign(x);
  return s == Sign::positive || s == Sign::negative;
}

// What is smaller than this part of what it is drawn beside is drawn as zero: so that it need not be known better.
constexpr double least_part = 0x1p-80;

// 0 for what is certainly nearer to zero than `least`, or may be zero; else the double nearest to it, or to the
// middle of a ball.
double drawn_as(const Deep& x, double least) {
  if (!x.is_in_doubles()) {
    const geometry::Enclosure ends = geometry::enclosure(x);
    const bool may_be_zero = ends.lower <= 0 && ends.upper >= 0;
    return may_be_zero || std::abs(ends.value) < least ? 0 : ends.value;
  }
  const geometry::Bounded around = [&] {
    const geometry::Arithmetic<geometry::Bounded> rounding;
    return x.doubled().value();
  }();
  if (-least < around.inf() && around.sup() < least) return 0;
  if (-least < around.sup() && around.inf() < least) throw geometry::TooCoarse{};
  return geometry::certain_double(x).value();
}

// Which of two is far larger is seen from any doubles near them; and where neither is, either may come first.
double rough_size(const Deep& x) {
  return std::abs(x.is_in_doubles() ? x.doubled().near() : geometry::enclosure(x).value);
}

std::pair<double, double> both(const Deep& x, const Deep& y, double beside) {
  if (rough_size(x) < rough_size(y)) {
    const auto [first, second] = both(y, x, beside);
    return {second, first};
  }
  const double larger = drawn_as(x, least_part * beside);
  return {larger, drawn_as(y, least_part * std::max(beside, std::abs(larger)))};
}

}  // namespace

double to_double(const Deep& x) { return drawn_as(x, 0); }
Place to_double(const geometry::Point<Deep>& P, double beside) {
  const auto [x, y] = both(P.x, P.y, beside);
  return {x, y};
}
Arrow2 to_double(const geometry::Vector<Deep>& v) {
  const auto [x, y] = both(v.x, v.y, 0);
  return {x, y};
}

std::optional<Place> to_double(const geometry::ProjectivePoint<Deep>& P, double beside) {
  if (!is_nonzero(P.w)) return {};
  return to_double(geometry::finite(P), beside);
}

DrawnCycle to_double(const geometry::Cycle<Deep>& cycle) {
  const geometry::Point<Deep> origin{Deep(0), Deep(0)};
  if (is_nonzero(cycle.k)) {
    const geometry::Point<Deep> centre = geometry::finite(cycle.centre());
    const Deep radius = cycle.radius(), distance = geometry::distance(origin, centre);
    DrawnCycle circle{.centre = to_double(centre), .radius = to_double(radius)};
    if (is_nonzero(distance)) {
      const geometry::Vector<Deep> to_centre = centre - origin;
      circle.on_line = to_double(origin + geometry::quotient(distance - radius, distance) * to_centre, circle.radius);
      circle.along = to_double(geometry::quotient(Deep(1), distance) * geometry::quarter_turn(to_centre));
    }
    return circle;
  }
  if (!is_nonzero(geometry::square(cycle.l) + geometry::square(cycle.m))) return {};
  const auto line = cycle.straight();
  return {.on_line = to_double(geometry::foot(origin, line)), .along = to_double(line.direction())};
}

}  // namespace epure
