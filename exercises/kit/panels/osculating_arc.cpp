#include "exercises/kit/panels/osculating_arc.h"

#include <algorithm>
#include <numbers>

namespace epure {

void draw_osculating_arc(Plot& plot, const Place& X, const Place& centre, double half_length,
                         const std::string& name) {
  constexpr double small = 6;                      // mm: so small a circle is seen as a whole
  constexpr double widest = std::numbers::pi / 3;  // radians to each side
  constexpr double straight = 1e9;                 // mm: from there on the arc rises by less than a micrometre
  const double radius = distance(centre, X) * plot.scale().mm_per_unit;
  const double half = radius < small ? std::numbers::pi : std::min(half_length / radius, widest),
               middle = direction(centre, X);
  if (radius < straight) {
    plot.mark(drawings::Line{drawings::arc(plot.at(centre), radius, middle - half, middle + half),
                             Meaning::construction, name});
    return;
  }
  const drawings::Point at = plot.at(X);
  const drawings::Point along{-half_length * std::sin(middle), half_length * std::cos(middle)};
  plot.mark(drawings::Line{drawings::segment({at.x - along.x, at.y - along.y}, {at.x + along.x, at.y + along.y}),
                           Meaning::construction, name});
}

}  // namespace epure
