// The curves of a chart as marks.
#pragma once

#include <optional>
#include <vector>

#include "drawings/charts/chart.h"

namespace epure::drawings {

// How a curve looks in black and white.
struct Look {
  LineType line = LineType::continuous;
  PointShape shape = PointShape::dot;    // of its points
  std::optional<PointShape> marks = {};  // points strung along the line where line types do not suffice
};
// One for each curve, in order, no two alike (see Curve::line). `marks_too`: with marks when line types have run out;
// without them the fifth curve of a kind looks like the first, and its label must tell.
std::vector<Look> looks(const std::vector<Curve>& curves, bool marks_too);

// Throws std::invalid_argument, naming the curve or marker, for what the axes cannot hold.
void require_sound(const Chart& chart);

// Where a datum lies, at most ten thousand times the frame away from it: what a pole sends to infinity leaves the
// frame in the same direction, to a ten thousandth of the way to the next point.
Point on_paper(const ChartMap& map, Datum datum);

// The visible parts of a curve's runs, as chains of points on the paper.
std::vector<std::vector<Point>> visible(const Curve& curve, const ChartMap& map);
// Its marked points that show; also its runs of one point.
std::vector<Point> visible_points(const Curve& curve, const ChartMap& map);
// Points along a chain `apart` mm from each other, the first after `start` mm.
std::vector<Point> along(const std::vector<Point>& chain, double start, double apart);

// Lines clipped to the frame by a window of the figure, and points on top of everything.
void draw_curves(const Chart& chart, const std::vector<Look>& looks, const ChartMap& map, Figure& figure);

}  // namespace epure::drawings
