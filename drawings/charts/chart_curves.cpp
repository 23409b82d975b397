#include "drawings/charts/chart_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "drawings/marks/style.h"
#include "drawings/paths/clip.h"
#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

// What a black-and-white print shows of a meaning's line.
LineType line_type(Meaning meaning) {
  const std::vector<double> dashes = line_style(meaning).dashes;
  if (dashes.empty()) return LineType::continuous;
  return dashes.size() > 2 ? LineType::dash_dotted : LineType::dashed;
}

void require_in(const Axis& axis, double value, const std::string& what) {
  if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("{}: {} has no place on a chart", what, value));
  if (axis.scale == AxisScale::logarithmic && !(value > 0))
    throw std::invalid_argument(fmt::format("{}: {} has no place on a logarithmic axis", what, value));
}

void require_in(const Chart& chart, Datum datum, const std::string& what) {
  require_in(chart.x, datum.x, what);
  require_in(chart.y, datum.y, what);
}

std::string name_of(const Curve& curve, std::size_t index) {
  if (!curve.name.empty()) return fmt::format("curve '{}'", curve.name);
  if (!curve.label.empty()) return fmt::format("curve '{}'", plain(curve.label));
  return fmt::format("curve {}", index + 1);
}

std::vector<Point> on_paper(const ChartMap& map, const std::vector<Datum>& run) {
  std::vector<Point> points;
  for (const Datum& datum : run) points.push_back(on_paper(map, datum));
  return points;
}

// Clips the marks added during its life to the frame.
class Window {
 public:
  Window(Figure& figure, Box frame) : figure_(figure), index_(static_cast<int>(figure.windows.size())) {
    figure.window_of.resize(figure.marks.size(), -1);
    figure.windows.push_back(frame);
  }
  void add(Mark mark) {
    figure_.marks.push_back(std::move(mark));
    figure_.window_of.push_back(index_);
  }

 private:
  Figure& figure_;
  int index_;
};

}  // namespace

namespace {

constexpr std::array line_types{LineType::continuous, LineType::dashed, LineType::dash_dotted, LineType::dotted};
constexpr std::array shapes{PointShape::dot,     PointShape::ring,  PointShape::square, PointShape::triangle,
                            PointShape::diamond, PointShape::cross, PointShape::plus};

PointShape shape_of(const Curve& curve, const std::vector<Curve>& curves, const std::vector<Look>& earlier) {
  if (curve.shape) return *curve.shape;
  const auto* free = std::find_if(shapes.begin(), shapes.end(), [&](PointShape shape) {
    for (std::size_t i = 0; i < earlier.size(); ++i)
      if (!curves[i].points.empty() && earlier[i].shape == shape) return false;
    return true;
  });
  return free != shapes.end() ? *free : shapes.front();
}

// In the order in which they are tried.
std::vector<Look> possible_looks(const Curve& curve, PointShape shape, bool marks_too) {
  if (curve.line != LineType::of_its_meaning) return {{curve.line, shape, {}}};
  std::vector<Look> all{{line_type(curve.meaning), shape, {}}};
  for (const LineType type : line_types) all.push_back({type, shape, {}});
  if (marks_too && curve.points.empty())
    for (const LineType type : line_types)
      for (const PointShape mark : shapes)
        if (mark != PointShape::dot) all.push_back({type, shape, mark});  // dots may mean special points
  return all;
}

bool alike(const Curve& one, const Look& its, const Curve& other, const Look& others) {
  const auto shown = [](const Curve& curve, const Look& look) {
    return curve.points.empty() ? look.marks : look.shape;
  };
  return !one.runs.empty() && !other.runs.empty() && its.line == others.line &&
         shown(one, its) == shown(other, others);
}

}  // namespace

std::vector<Look> looks(const std::vector<Curve>& curves, bool marks_too) {
  std::vector<Look> found;
  for (const Curve& curve : curves) {
    const PointShape shape =
        curve.points.empty() ? curve.shape.value_or(PointShape::dot) : shape_of(curve, curves, found);
    const std::vector<Look> possible = possible_looks(curve, shape, marks_too);
    const auto free = std::find_if(possible.begin(), possible.end(), [&](const Look& look) {
      for (std::size_t i = 0; i < found.size(); ++i)
        if (alike(curves[i], found[i], curve, look)) return false;
      return true;
    });
    found.push_back(free != possible.end() ? *free : possible.front());
  }
  return found;
}

void require_sound(const Chart& chart) {
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const std::string name = name_of(chart.curves[i], i);
    for (const auto& run : chart.curves[i].runs)
      for (const Datum& datum : run) require_in(chart, datum, name);
    for (const Datum& datum : chart.curves[i].points) require_in(chart, datum, name);
  }
  for (const ChartArea& area : chart.areas)
    for (const Datum& datum : area.border) require_in(chart, datum, "area");
  for (const Marker& marker : chart.markers)
    require_in(chart, marker.at, fmt::format("marker '{}'", plain(marker.label)));
  for (const ReferenceLine& line : chart.verticals) require_in(chart.x, line.at, "vertical line");
  for (const ReferenceLine& line : chart.horizontals) require_in(chart.y, line.at, "horizontal line");
}

Point on_paper(const ChartMap& map, Datum datum) {
  constexpr double far = 1e4;
  const Box frame = map.frame;
  const auto within = [](double mm, double low, double high) {
    return std::clamp(mm, low - far * (high - low), high + far * (high - low));
  };
  const Point p = map.at(datum);
  return {within(p.x, frame.low.x, frame.high.x), within(p.y, frame.low.y, frame.high.y)};
}

std::vector<std::vector<Point>> visible(const Curve& curve, const ChartMap& map) {
  std::vector<std::vector<Point>> chains;
  for (const auto& run : curve.runs) {
    if (run.size() < 2) continue;
    for (const Path& part : clip_path(polyline(on_paper(map, run), false), map.frame)) {
      chains.push_back({part.start});
      for (const Piece& piece : part.pieces) chains.back().push_back(piece.end);
    }
  }
  return chains;
}

std::vector<Point> visible_points(const Curve& curve, const ChartMap& map) {
  std::vector<Datum> all = curve.points;
  for (const auto& run : curve.runs)
    if (run.size() == 1) all.push_back(run.front());
  std::vector<Point> shown;
  for (const Datum& datum : all)
    if (const Point p = on_paper(map, datum); contains(grown(map.frame, 1e-6), p)) shown.push_back(p);
  return shown;
}

std::vector<Point> along(const std::vector<Point>& chain, double start, double apart) {
  std::vector<Point> found;
  double next = start;  // from the beginning of the piece
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const double piece = distance(chain[i - 1], chain[i]);
    for (; next <= piece && piece > 0; next += apart) found.push_back(between(chain[i - 1], chain[i], next / piece));
    next -= piece;
  }
  return found;
}

void draw_curves(const Chart& chart, const std::vector<Look>& looks, const ChartMap& map, Figure& figure) {
  Window window(figure, map.frame);
  for (const ChartArea& area : chart.areas)
    window.add(Area{polyline(thinned(on_paper(map, area.border), file_resolution / 2), true), area.meaning, {}});
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const Curve& curve = chart.curves[i];
    for (const auto& run : curve.runs)
      if (run.size() > 1)
        window.add(Line{polyline(thinned(on_paper(map, run), file_resolution / 2), false), curve.meaning, curve.name,
                        looks[i].line});
  }
  constexpr double apart = 25;  // mm between the marks along a line; those of neighbours are not to stand together
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const Curve& curve = chart.curves[i];
    if (looks[i].marks)
      for (const auto& chain : visible(curve, map))
        for (const Point p : along(chain, 5 + 4 * static_cast<double>(i % 5), apart))
          figure.marks.push_back(DataPoint{p, *looks[i].marks, curve.meaning});
    const std::string name = curve.name.empty() ? std::string{} : curve.name + "_point";
    for (const Point p : visible_points(curve, map))
      figure.marks.push_back(DataPoint{p, looks[i].shape, curve.meaning, name});
  }
}

}  // namespace epure::drawings
