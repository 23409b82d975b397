#include "exercises/kit/panels/curve.h"

#include <cmath>

#include "exercises/kit/panels/rounded.h"

namespace epure {

geometry::Frame frame_of(const Plot& plot, const drawings::Box& room) {
  const Place low = plot.from_paper(room.low), high = plot.from_paper(room.high);
  return {low.x, low.y, high.x, high.y};
}

void draw_branches(Plot& plot, const geometry::Trace& trace, Meaning meaning, const std::string& name) {
  for (const geometry::Branch& branch : trace.branches) {
    if (branch.arcs.empty()) continue;
    drawings::Path path{plot.at(branch.arcs.front().start), {}, false};
    for (const geometry::BezierArc& arc : branch.arcs) {
      path.pieces.push_back({false, plot.at(arc.first_control), plot.at(arc.second_control), plot.at(arc.end)});
    }
    path.closed = branch.closed;
    plot.mark(drawings::Line{path, meaning, name});
  }
}

void draw_line(Plot& plot, const geometry::Line<double>& line, Meaning meaning) {
  const double normal2 = line.a * line.a + line.b * line.b;
  const Place foot{-line.a * line.c / normal2, -line.b * line.c / normal2};
  plot.cycle({.on_line = foot, .along = line.direction()}, meaning);
}

}  // namespace epure
