#include "exercises/kit/panels/phase_plane_panel.h"

#include <cmath>

namespace epure {
namespace {

using drawings::Datum;

// Strokes along an isocline, so long and so far apart as parts of the axes.
constexpr double half_stroke = 0.008, apart = 0.07;

struct Axes {
  double wide, high;
  double between(const Datum& p, const Datum& q) const { return std::hypot((q.x - p.x) / wide, (q.y - p.y) / high); }
};

// In the direction of motion as it is seen.
std::vector<Datum> stroke(const Datum& at, const Arrow2& motion, const Axes& axes) {
  const double size = std::hypot(motion.x / axes.wide, motion.y / axes.high);
  if (!(size > 0)) return {};
  const double dx = motion.x / size * half_stroke, dy = motion.y / size * half_stroke;
  return {{at.x - dx, at.y - dy}, {at.x + dx, at.y + dy}};
}

void add_strokes(std::vector<std::vector<Datum>>& onto, const PhasePlane& plane, const PhasePlane::Line& isocline,
                 const Axes& axes) {
  double since = apart / 2;
  for (std::size_t i = 1; i < isocline.size(); ++i) {
    since += axes.between(isocline[i - 1], isocline[i]);
    const Datum& at = isocline[i];
    const bool shows = at.x > plane.x.low && at.x < plane.x.high && at.y > plane.y.low && at.y < plane.y.high;
    if (since < apart || !shows) continue;
    since = 0;
    if (auto line = stroke(at, plane.motion(at), axes); !line.empty()) onto.push_back(std::move(line));
  }
}

drawings::Chart chart_of(const PhasePlane& plane) {
  drawings::Chart chart;
  chart.x = plane.x, chart.y = plane.y;
  chart.horizontals = {{.at = 0}};
  chart.verticals = {{.at = 0}};
  chart.markers = plane.markers;
  const Axes axes{plane.x.high - plane.x.low, plane.y.high - plane.y.low};
  std::vector<std::vector<Datum>> strokes;
  for (const PhasePlane::Line& isocline : plane.isoclines) add_strokes(strokes, plane, isocline, axes);
  chart.curves.push_back({.name = "isoclines",
                          .runs = plane.isoclines,
                          .meaning = Meaning::construction,
                          .line = drawings::LineType::dotted});
  chart.curves.push_back({.name = "directions",
                          .runs = std::move(strokes),
                          .meaning = Meaning::construction,
                          .line = drawings::LineType::continuous});
  for (const PhasePlane::Orbit& orbit : plane.orbits)
    chart.curves.push_back({.name = orbit.name,
                            .runs = orbit.runs,
                            .meaning = orbit.meaning,
                            .line = orbit.line,
                            .points = orbit.points,
                            .label = orbit.label});
  return chart;
}

}  // namespace

PhasePlanePanel::PhasePlanePanel(const PhasePlane& plane) : ChartPanel(chart_of(plane), plane.read) {}

}  // namespace epure
