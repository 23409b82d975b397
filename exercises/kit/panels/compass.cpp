#include "exercises/kit/panels/compass.h"

#include <algorithm>
#include <cmath>

namespace epure {

void compass_arc(Plot& plot, const Place& centre, const Place& P, double half_mm) {
  const drawings::Point c = plot.at(centre), p = plot.at(P);
  const double radius = std::hypot(p.x - c.x, p.y - c.y), at = std::atan2(p.y - c.y, p.x - c.x);
  if (radius < 1) return;  // mm: no compass is set so narrow
  const double half = std::min(half_mm / radius, 1.0);
  plot.mark(drawings::Line{drawings::arc(c, radius, at - half, at + half), Meaning::construction, {}});
}

}  // namespace epure
