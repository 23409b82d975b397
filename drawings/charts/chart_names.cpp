#include "drawings/charts/chart_names.h"

#include <algorithm>
#include <cmath>

#include "drawings/charts/chart_curves.h"
#include "drawings/labels/candidates.h"
#include "drawings/labels/namesakes.h"
#include "drawings/marks/canvas.h"
#include "drawings/marks/symbols.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

LabelBox box_of(const Label& label) {
  const TextSize size = measure(label.text, label.size);
  return {size.width, size.ascent + size.descent, label.at, label.to, label.away_from};
}

void draw_on(Canvas& canvas, const Figure& figure, Box box) {
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    const int window = i < figure.window_of.size() ? figure.window_of[i] : -1;
    canvas.clip_to(window < 0 ? box : figure.windows[static_cast<std::size_t>(window)]);
    draw(canvas, figure.marks[i]);
  }
}

// Points of the curve to look for a place beside, some millimetres apart: a few dozen at most, unless a part of the
// curve is wished for.
std::vector<Point> stations(const Curve& curve, const ChartMap& map) {
  constexpr double least_apart = 4, most = 40;  // mm, number
  const std::vector<std::vector<Point>> chains = visible(curve, map);
  double total = 0;
  for (const std::vector<Point>& chain : chains)
    for (std::size_t i = 1; i < chain.size(); ++i) total += distance(chain[i - 1], chain[i]);
  const double apart = curve.label_near_x ? least_apart : std::max(least_apart, total / most);
  std::vector<Point> found;
  const std::vector<Point> points = visible_points(curve, map);
  const std::size_t every = curve.label_near_x ? 1 : 1 + points.size() / static_cast<std::size_t>(most);
  for (std::size_t i = 0; i < points.size(); i += every) found.push_back(points[i]);
  for (const std::vector<Point>& chain : chains) {
    const std::vector<Point> more = along(chain, apart / 2, apart);
    found.insert(found.end(), more.begin(), more.end());
    if (found.empty()) found.push_back(between(chain.front(), chain.back(), 0.5));
  }
  return found;
}

// Those nearest to where the label is wanted.
std::vector<Point> wished(std::vector<Point> stations, const Curve& curve, const ChartMap& map) {
  constexpr double reach = 5;  // mm
  if (!curve.label_near_x || stations.empty()) return stations;
  const double wish = map.x.at(*curve.label_near_x);
  const auto off = [&](Point p) { return std::abs(p.x - wish); };
  double nearest = INFINITY;
  for (const Point p : stations) nearest = std::min(nearest, off(p));
  std::erase_if(stations, [&](Point p) { return off(p) > nearest + reach; });
  return stations;
}

class FreePlaces {
 public:
  FreePlaces(const Chart& chart, const ChartMap& map, const Obstacles& obstacles)
      : chart_(chart), map_(map), obstacles_(obstacles) {
    const Box shown = grown(map.frame, 1);
    for (const Curve& curve : chart.curves) {
      Obstacles& line = lines_.emplace_back(shown);
      for (const auto& chain : visible(curve, map))
        for (std::size_t k = 1; k < chain.size(); ++k) line.add({chain[k - 1], chain[k]});
      for (const Point p : visible_points(curve, map)) line.add({p, p});
    }
  }

  void keep_clear(Box box) {
    const Point lower_right{box.high.x, box.low.y}, upper_left{box.low.x, box.high.y};
    for (const auto& [from, to] : {std::pair{box.low, lower_right}, std::pair{lower_right, box.high},
                                   std::pair{box.high, upper_left}, std::pair{upper_left, box.low}})
      obstacles_.add({from, to, 0, true});
  }

  // None when there is no free place beside curve i.
  std::optional<Box> beside(std::size_t i, LabelBox wanted) const {
    const Box room = grown(map_.frame, -1);
    std::optional<Box> best;
    double least = unclear;
    for (const Point at : wished(stations(chart_.curves[i], map_), chart_.curves[i], map_)) {
      wanted.at = at;
      for (const Candidate& candidate : clear_places_around_point(wanted, obstacles_, room, least)) {
        const double cost = candidate.cost + ambiguity(i, candidate.box);
        if (cost >= least) continue;
        least = cost;
        best = candidate.box;
      }
    }
    return best;
  }

 private:
  static constexpr double unclear = 20;  // worse than this, and the legend is clearer
  static_assert(unclear < price::touch_thin, "no label through a line");

  // A label no nearer to its own curve than to another would name the wrong one; nearly as near is bad enough.
  double ambiguity(std::size_t own, Box box) const {
    constexpr double plain = 3;  // times as far away
    const double to_own = nearest(own, box, 10);
    double cost = 0;
    for (std::size_t j = 0; j < lines_.size(); ++j) {
      if (j == own) continue;
      const double to_other = nearest(j, box, plain * to_own);
      if (to_other <= to_own) return INFINITY;
      cost += 4 * (plain * to_own - to_other);
    }
    return cost;
  }

  // At most `reach`.
  double nearest(std::size_t curve, Box box, double reach) const {
    double least = reach;
    lines_[curve].near(box, reach, [&](const Obstacle& o) {
      least = std::min(least, gap(box, o.from, o.to));
      return least > 0;
    });
    return least;
  }

  const Chart& chart_;
  const ChartMap& map_;
  Obstacles obstacles_;
  std::vector<Obstacles> lines_;  // what shows of each curve
};

}  // namespace

std::optional<std::vector<Writing>> direct_names(const Chart& chart, const ChartMap& map, const Figure& figure,
                                                 const std::vector<Label>& others, Box box) {
  const auto has_name = [](const Curve& curve) { return !curve.label.empty(); };
  if (std::none_of(chart.curves.begin(), chart.curves.end(), has_name)) return std::vector<Writing>{};
  Canvas canvas(box);
  draw_on(canvas, figure, box);
  const Obstacles drawn = canvas.obstacles();
  FreePlaces places(chart, map, drawn);
  std::vector<LabelBox> boxes;
  const Namesakes namesakes(figure, others, box);
  for (const Label& label : others) {
    boxes.push_back(box_of(label));
    boxes.back().naming = namesakes.of(label, boxes.back().width);
  }
  for (const Place& place : place_labels(boxes, drawn, box))
    if (place.found) places.keep_clear(place.box);
  std::vector<Writing> names;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const Curve& curve = chart.curves[i];
    if (curve.label.empty() || stations(curve, map).empty()) continue;
    const TextSize size = measure(curve.label, curve_label_size);
    const auto found = places.beside(i, {size.width, size.ascent + size.descent, {}});
    if (!found) return std::nullopt;
    places.keep_clear(*found);
    names.push_back({curve.label, found->low + Point{0, size.descent}, curve_label_size, curve.meaning});
  }
  return names;
}

std::vector<Label> marker_labels(const Chart& chart, const ChartMap& map) {
  constexpr double from_end = 4, on_axis = 1, numbers = 5;  // mm
  std::vector<Label> labels;
  const auto add = [&](const std::string& text, Point at, Meaning ink) {
    if (text.empty() || !contains(grown(map.frame, 1e-6), at)) return;
    labels.push_back({.text = text, .at = at, .ink = ink, .size = marker_label_size});
    // Of a point on an axis the letters stand within the frame, out of the row of that axis' numbers.
    if (at.y - map.frame.low.y < on_axis) labels.back().away_from = at - Point{0, numbers};
    if (at.x - map.frame.low.x < on_axis) labels.back().away_from = at - Point{numbers, 0};
  };
  for (const Marker& marker : chart.markers) add(marker.label, on_paper(map, marker.at), marker.meaning);
  for (const ReferenceLine& line : chart.verticals)
    add(line.label, {map.x.at(line.at), map.frame.high.y - from_end}, line.meaning);
  for (const ReferenceLine& line : chart.horizontals)
    add(line.label, {map.frame.high.x - from_end, map.y.at(line.at)}, line.meaning);
  return labels;
}

namespace {

constexpr double sample = 9, after_sample = 1.5, between_entries = 6;  // mm

double entry_width(const Curve& curve) {
  return sample + after_sample + measure(curve.label, marker_label_size).width;
}

}  // namespace

double legend_width(const Chart& chart, const std::vector<std::size_t>& row) {
  double width = -between_entries;
  for (const std::size_t i : row) width += entry_width(chart.curves[i]) + between_entries;
  return width;
}

std::vector<std::vector<std::size_t>> legend_rows(const Chart& chart, double width) {
  std::vector<std::vector<std::size_t>> rows;
  double used = INFINITY;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    if (chart.curves[i].label.empty()) continue;
    const double entry = entry_width(chart.curves[i]);
    if (used + between_entries + entry > width) {
      rows.emplace_back();
      used = -between_entries;
    }
    rows.back().push_back(i);
    used += between_entries + entry;
  }
  return rows;
}

void draw_legend(const Chart& chart, const std::vector<Look>& looks,
                 const std::vector<std::vector<std::size_t>>& rows, Point top_right, Figure& figure) {
  const double half_digit = measure("0", marker_label_size).ascent / 2;
  double y = top_right.y - legend_row_height / 2;
  for (const auto& row : rows) {
    double x = top_right.x - legend_width(chart, row);
    for (const std::size_t i : row) {
      const Curve& curve = chart.curves[i];
      const Point left{x, y}, right{x + sample, y};
      if (!curve.runs.empty()) figure.marks.push_back(Line{segment(left, right), curve.meaning, {}, looks[i].line});
      if (!curve.points.empty() || looks[i].marks)
        figure.marks.push_back(
            DataPoint{between(left, right, 0.5), looks[i].marks.value_or(looks[i].shape), curve.meaning});
      figure.marks.push_back(
          Writing{curve.label, {x + sample + after_sample, y - half_digit}, marker_label_size, curve.meaning});
      x += entry_width(curve) + between_entries;
    }
    y -= legend_row_height;
  }
}

}  // namespace epure::drawings
