#include "exercises/kit/panels/rounded.h"

#include "exercises/kit/proof/zero_for_drawing.h"

namespace epure {

using geometry::Deep;
using geometry::Sign;

namespace {

bool is_nonzero(const Deep& x) {
  const Sign s = geometry::sign(x);
  return s == Sign::positive || s == Sign::negative;
}

}  // namespace

double to_double(const Deep& x) {
  const geometry::Enclosure ends = geometry::enclosure(x);
  if (!may_be_zero(ends)) return ends.value;
  if (is_zero_for_drawing(ends, geometry::Arithmetic<Deep>::bits())) return 0;
  throw geometry::Undecided("a quantity that cannot be told from zero for the drawing",
                            "una grandezza che per il disegno non si distingue da zero");
}
Place to_double(const geometry::Point<Deep>& P) { return {to_double(P.x), to_double(P.y)}; }
Arrow2 to_double(const geometry::Vector<Deep>& v) { return {to_double(v.x), to_double(v.y)}; }

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
