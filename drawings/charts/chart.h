// Charts as plain data, and how they become ordinary marks and labels of a figure.
//
//   Chart chart;
//   chart.x = {.quantity = "$φ_{2}$", .unit = "°", .low = 0, .high = 360, .steps = degree_steps};
//   chart.y = {.quantity = "$ω_{4}$", .unit = "rad/s", .low = -4, .high = 6};
//   chart.curves = {{.name = "omega_4", .runs = {...}, .meaning = Meaning::velocity, .label = "$ω_{4}$"}};
//   const ChartMap map = draw(chart, box, sheet.figure, sheet.language);
//   const Point on_paper = map.at({60, 3.2});
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

struct Datum {  // a point of the chart, in the units of its axes
  double x = 0, y = 0;
};

// Steps between the numbers of an axis, to choose from: of angles in degrees, and of what is counted.
inline const std::vector<int> degree_steps{1, 2, 5, 10, 15, 30, 45, 60, 90, 180, 360};
inline const std::vector<int> whole_steps{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

enum class AxisScale { linear, logarithmic };
struct Axis {
  std::string quantity = {};  // rich text: "$ω_{4}$"; the axis is called "ω₄ (rad/s)"
  std::string unit = {};  // rich text; very large and very small numbers get a power of ten: "ω₄ (10⁶ rad/s)"
  double low = 0, high = 1;
  AxisScale scale = AxisScale::linear;
  std::vector<int> steps = {};  // empty: 1, 2, 5 times a power of ten; likewise when none of them suits
  bool to_ticks =
      true;  // the ends are moved outwards to numbers of the axis; false: they stay, unless two numbers would not fit
};

struct Curve {
  std::string name = {};  // id of its line in the SVG
  // Points joined by straight lines: about one in every half millimetre looks smooth. What is discontinuous has
  // several runs; nothing is drawn between two. A run of one point is drawn as a point.
  std::vector<std::vector<Datum>> runs = {};
  Meaning meaning = Meaning::locus;
  // Unless told, the curve gets the line type of its meaning or, where an earlier curve looks like that in black and
  // white, the first line type that is free; in a legend, where four types do not suffice, with marks along it.
  LineType line = LineType::of_its_meaning;
  std::vector<Datum> points = {};           // marked one by one; a curve with points and no runs is a scatter
  std::optional<PointShape> shape = {};     // of its points; unless told, the first that no earlier curve has
  std::string label = {};                   // stands beside the curve where there is room, or in the legend
  std::optional<double> label_near_x = {};  // where on the curve, if it matters
};

struct Marker {  // a special point with its value: "max 4.31"
  Datum at = {};
  std::string label = {};
  PointShape shape = PointShape::dot;
  Meaning meaning = Meaning::text;
  std::string name = {};
};

struct ReferenceLine {  // across the whole chart: zero, a limit, a position
  double at = 0;
  std::string label = {};
  Meaning meaning = Meaning::axis;
};

struct ChartArea {  // filled, below all curves: what they integrate to
  std::vector<Datum> border = {};
  Meaning meaning = Meaning::plate;
};

struct Chart {
  Axis x = {}, y = {};
  std::vector<ChartArea> areas = {};
  std::vector<Curve> curves = {};
  std::vector<Marker> markers = {};
  std::vector<ReferenceLine> verticals = {}, horizontals = {};
  bool legend = false;      // true: a legend above the frame even where curves could be labelled directly
  double letters_left = 0;  // mm left of the frame at least, so that the frames of charts above each other line up
};

// From a number of one axis to the paper and back.
struct AxisMap {
  AxisScale scale = AxisScale::linear;
  double low = 0, high = 1;       // the ends of the axis, in its unit
  double from = 0, to = 1;        // where they lie, mm
  double at(double value) const;  // mm; nonsense for a value that is not positive on a logarithmic axis
  double value(double mm) const;  // the inverse
  double per_mm() const;          // units of the axis in a millimetre; on a logarithmic axis powers of ten
};
struct ChartMap {
  Box frame;  // where curves show
  AxisMap x, y;
  Point at(Datum datum) const { return {x.at(datum.x), y.at(datum.y)}; }
};

// Draws the chart into `box` (mm), letters included, and returns where its numbers lie on the paper. What lies
// outside the axes is cut off. Throws std::invalid_argument: "axis ω_4 (rad/s): ..." for an end that is not finite,
// ends in the wrong order or so close that their numbers could not be told apart, or an end of a logarithmic axis
// that is not positive; "curve ...", "marker ..." for a value that is not finite, or not positive on a logarithmic
// axis; "chart:
// ..." when the box leaves the frame less than 20 mm x 15 mm or is not on paper.
ChartMap draw(const Chart& chart, Box box, Figure& figure, Language language);

// The frame with its numbers alone, where they stand with the curves.
ChartMap draw_axes(const Chart& chart, Box box, Figure& figure, Language language);

}  // namespace epure::drawings
