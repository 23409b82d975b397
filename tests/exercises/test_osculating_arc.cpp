// Arcs of curvature: they touch the curve at X, however far off the centre is.
#include <cmath>

#include "exercises/kit/panels/osculating_arc.h"
#include "tests/support/catch.h"

using namespace epure;

TEST_CASE("an arc of curvature touches the curve, also where it is as good as straight") {
  constexpr double half_length = 15;
  const Place X{3, -2};
  for (const double radius : {20.0, 1e3, 1e6, 0.99e9, 1.01e9, 1e12})
    for (const double way : {0.3, 2.0, -1.1}) {
      CAPTURE(radius, way);
      const double nx = std::cos(way), ny = std::sin(way);
      DrawnSheet sheet;
      Plot plot(sheet, {90, 80}, {.mm_per_unit = 1, .caption = "", .unit = "m"});
      draw_osculating_arc(plot, X, {X.x + radius * nx, X.y + radius * ny}, half_length, "");
      const auto& path = std::get<drawings::Line>(sheet.sheet.figure.marks.at(0)).path;
      const drawings::Point from = path.start, to = path.pieces.back().end, at = plot.at(X);
      const double half = half_length / radius, rises = 2 * radius * std::pow(std::sin(half / 2), 2);
      const auto off_tangent = [&](drawings::Point p) { return (p.x - at.x) * nx + (p.y - at.y) * ny; };
      const auto along_tangent = [&](drawings::Point p) { return (p.x - at.x) * ny - (p.y - at.y) * nx; };
      CHECK(off_tangent(from) == Approx(rises).margin(1e-5));
      CHECK(off_tangent(to) == Approx(rises).margin(1e-5));
      CHECK(along_tangent(from) == Approx(-radius * std::sin(half)).margin(1e-5));
      CHECK(along_tangent(to) == Approx(radius * std::sin(half)).margin(1e-5));
    }
}
