#include "drawings/charts/chart.h"

#include <cmath>
#include <stdexcept>

#include "drawings/charts/chart_curves.h"
#include "drawings/charts/chart_names.h"
#include "drawings/charts/ticks.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings {

double AxisMap::at(double value) const {
  const double t = scale == AxisScale::linear
                       ? (value - low) / (high - low)
                       : (std::log10(value) - std::log10(low)) / (std::log10(high) - std::log10(low));
  return from + t * (to - from);
}

double AxisMap::value(double mm) const {
  const double t = (mm - from) / (to - from);
  if (scale == AxisScale::linear) return low + t * (high - low);
  return std::pow(10, std::log10(low) + t * (std::log10(high) - std::log10(low)));
}

double AxisMap::per_mm() const {
  const double length = to - from;
  return scale == AxisScale::linear ? (high - low) / length : (std::log10(high) - std::log10(low)) / length;
}

namespace {

constexpr double axis_title_size = 3.5;                 // mm
constexpr double long_tick = 2, short_tick = 1.1;       // mm
constexpr double beside_frame = 1.5, below_frame = 2;   // mm to the numbers
constexpr double above_title = 2.2, below_title = 2.8;  // mm between the x axis' title and numbers, y axis' and frame
constexpr double narrowest_frame = 20, lowest_frame = 15;  // mm

// The frame in its box, once the letters around it have got their room.
struct Arrangement {
  Ticks x, y;
  Box frame;
  std::string x_title, y_title;
  std::vector<std::vector<std::size_t>> legend;
  bool legend_beside_title = false;
};

double widest(const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, measure(tick.text, number_size).width);
  return width;
}

double digit_height() { return measure("0", number_size).ascent; }

double height(const std::string& text, double size) {
  if (text.empty()) return 0;
  const TextSize extent = measure(text, size);
  return extent.ascent + extent.descent;
}

void require_room(Box frame) {
  constexpr double largest = 1e4;  // mm: ten metres of paper
  if (frame.width() > largest || frame.height() > largest)
    throw std::invalid_argument("chart: its box is larger than any paper");
  if (!(frame.width() >= narrowest_frame) || !(frame.height() >= lowest_frame))
    throw std::invalid_argument("chart: its box leaves no room between the letters of its axes");
}

class ChartPainter {
 public:
  ChartPainter(const Chart& chart, Box box, Language language) : chart_(chart), box_(box), language_(language) {}

  enum class Shows { all, axes };
  ChartMap run(Figure& figure, Shows shows = Shows::all) const {
    Arrangement parts = arrange(chart_.legend);
    ChartMap map = map_of(parts);
    const std::vector<Label> others = marker_labels(chart_, map);
    std::optional<std::vector<Writing>> names;
    if (!chart_.legend) names = direct_names(chart_, map, marks(parts, map), others, box_);
    if (!names && !chart_.legend) {
      parts = arrange(true);
      map = map_of(parts);
    }
    if (shows == Shows::axes) {
      append(figure, frame_marks(parts, map));
      return map;
    }
    append(figure, marks(parts, map));
    for (const Writing& name : names.value_or(std::vector<Writing>{})) figure.marks.push_back(name);
    figure.window_of.resize(figure.marks.size(), -1);
    const std::vector<Label> special = marker_labels(chart_, map);
    figure.labels.insert(figure.labels.end(), special.begin(), special.end());
    return map;
  }

 private:
  Arrangement arrange(bool legend) const {
    Arrangement parts;
    parts.x_title = title(chart_.x);
    Box frame = box_;
    frame.low.y += below_frame + digit_height() + (parts.x_title.empty() ? 0 : above_title + title_height(chart_.x));
    frame.high.y -= std::max(digit_height() / 2, header_height(parts, legend, frame));
    frame.high.x -= number_size;
    require_room(frame);
    parts.y = ticks(chart_.y, frame.height(), Along::vertical, language_);
    frame.low.x += std::max(chart_.letters_left, widest(parts.y.numbered) + beside_frame);
    require_room(frame);
    parts.x = ticks(chart_.x, frame.width(), Along::horizontal, language_);
    // The last number may reach past the frame.
    const double past = overhang(parts.x, frame);
    if (past > number_size) {
      frame.high.x -= past - number_size;
      require_room(frame);
      parts.x = ticks(chart_.x, frame.width(), Along::horizontal, language_);
    }
    parts.frame = frame;
    parts.x_title = title(chart_.x, parts.x.power);
    parts.y_title = title(chart_.y, parts.y.power);
    return parts;
  }

  // With the power of ten it may need.
  static double title_height(const Axis& axis) { return height(title(axis, 3), axis_title_size); }

  // Above the frame: the title of the y axis at the left, the legend at the right of it or, for want of room, above.
  double header_height(Arrangement& parts, bool legend, Box frame) const {
    const std::string y_title = title(chart_.y, 3);
    const bool titled = !title(chart_.y).empty();
    const double title_room = titled ? below_title + title_height(chart_.y) : 0;
    if (!legend) return title_room;
    parts.legend = legend_rows(chart_, frame.width());
    if (parts.legend.empty()) return title_room;
    const double rows = static_cast<double>(parts.legend.size()) * legend_row_height;
    const double title_width = titled ? measure(y_title, axis_title_size).width + 8 : 0;
    parts.legend_beside_title =
        parts.legend.size() == 1 && title_width + legend_width(chart_, parts.legend[0]) < frame.width();
    return parts.legend_beside_title ? std::max(title_room, below_title / 2 + rows) : title_room + rows;
  }

  double overhang(const Ticks& x, Box frame) const {
    const AxisMap map = axis_map(chart_.x, x.low, x.high, frame.low.x, frame.high.x);
    const Tick& last = x.numbered.back();
    return map.at(last.value) + measure(last.text, number_size).width / 2 - frame.high.x;
  }

  ChartMap map_of(const Arrangement& parts) const {
    const Box frame = parts.frame;
    return {frame, axis_map(chart_.x, parts.x.low, parts.x.high, frame.low.x, frame.high.x),
            axis_map(chart_.y, parts.y.low, parts.y.high, frame.low.y, frame.high.y)};
  }

  Figure marks(const Arrangement& parts, const ChartMap& map) const {
    Figure figure;
    const std::vector<Look> how = looks(chart_.curves, !parts.legend.empty());
    draw_references(map, figure);
    draw_x_axis(parts, map, figure);
    draw_y_axis(parts, map, figure);
    if (!parts.legend.empty()) {
      const double rows = static_cast<double>(parts.legend.size()) * legend_row_height;
      const double top = parts.legend_beside_title ? map.frame.high.y + below_title / 2 + rows : box_.high.y;
      draw_legend(chart_, how, parts.legend, {map.frame.high.x, top}, figure);
    }
    draw_curves(chart_, how, map, figure);
    figure.marks.push_back(border(map.frame));
    for (const Marker& marker : chart_.markers)
      if (const Point p = on_paper(map, marker.at); contains(grown(map.frame, 1e-6), p))
        figure.marks.push_back(DataPoint{p, marker.shape, marker.meaning, marker.name});
    figure.window_of.resize(figure.marks.size(), -1);
    return figure;
  }

  Figure frame_marks(const Arrangement& parts, const ChartMap& map) const {
    Figure figure;
    draw_x_axis(parts, map, figure);
    draw_y_axis(parts, map, figure);
    figure.marks.push_back(border(map.frame));
    figure.window_of.resize(figure.marks.size(), -1);
    return figure;
  }
  static Line border(const Box& f) {
    return {polyline({f.low, {f.high.x, f.low.y}, f.high, {f.low.x, f.high.y}}, true), Meaning::text};
  }

  void draw_references(const ChartMap& map, Figure& figure) const {
    const Box f = map.frame;
    for (const ReferenceLine& line : chart_.verticals)
      if (const double x = map.x.at(line.at); x >= f.low.x && x <= f.high.x)
        figure.marks.push_back(Line{segment({x, f.low.y}, {x, f.high.y}), line.meaning});
    for (const ReferenceLine& line : chart_.horizontals)
      if (const double y = map.y.at(line.at); y >= f.low.y && y <= f.high.y)
        figure.marks.push_back(Line{segment({f.low.x, y}, {f.high.x, y}), line.meaning});
  }

  // Ticks point inward, from the opposite side too: there a ruler can be laid.
  static void tick(Figure& figure, Point foot, Point opposite, double length) {
    const Point in = length * unit(foot, opposite);
    figure.marks.push_back(Line{segment(foot, foot + in), Meaning::dimension});
    figure.marks.push_back(Line{segment(opposite, opposite - in), Meaning::dimension});
  }

  // Ticks first, then the numbers as a table: in a file things alike that follow each other are said once.
  void draw_x_axis(const Arrangement& parts, const ChartMap& map, Figure& figure) const {
    const Box f = map.frame;
    const double baseline = f.low.y - below_frame - digit_height();
    const auto at = [&](double value, double length) {
      const double x = map.x.at(value);
      if (x > f.low.x + 0.01 && x < f.high.x - 0.01) tick(figure, {x, f.low.y}, {x, f.high.y}, length);
    };
    for (const double value : parts.x.between) at(value, short_tick);
    for (const Tick& number : parts.x.numbered) at(number.value, long_tick);
    for (const Tick& number : parts.x.numbered) {
      const double width = measure(number.text, number_size).width;
      figure.marks.push_back(Writing{.text = number.text,
                                     .baseline = {map.x.at(number.value) - width / 2, baseline},
                                     .size = number_size,
                                     .row = 0,
                                     .anchor = 0.5});
    }
    if (parts.x_title.empty()) return;
    const TextSize size = measure(parts.x_title, axis_title_size);
    const double middle = (f.low.x + f.high.x) / 2;
    figure.marks.push_back(Writing{.text = parts.x_title,
                                   .baseline = {middle - size.width / 2, baseline - above_title - size.ascent},
                                   .size = axis_title_size,
                                   .anchor = 0.5});
  }

  void draw_y_axis(const Arrangement& parts, const ChartMap& map, Figure& figure) const {
    const Box f = map.frame;
    const auto at = [&](double value, double length) {
      const double y = map.y.at(value);
      if (y > f.low.y + 0.01 && y < f.high.y - 0.01) tick(figure, {f.low.x, y}, {f.high.x, y}, length);
    };
    for (const double value : parts.y.between) at(value, short_tick);
    for (const Tick& number : parts.y.numbered) at(number.value, long_tick);
    for (std::size_t i = 0; i < parts.y.numbered.size(); ++i) {
      const auto& [value, text] = parts.y.numbered[i];
      const double width = measure(text, number_size).width;
      figure.marks.push_back(
          Writing{.text = text,
                  .baseline = {f.low.x - beside_frame - width, map.y.at(value) - digit_height() / 2},
                  .size = number_size,
                  .row = i,
                  .anchor = 1});
    }
    if (parts.y_title.empty()) return;
    const TextSize size = measure(parts.y_title, axis_title_size);
    const double left = f.low.x - beside_frame - widest(parts.y.numbered);
    figure.marks.push_back(Writing{parts.y_title, {left, f.high.y + below_title + size.descent}, axis_title_size});
  }

  static void append(Figure& to, const Figure& chart) {
    to.window_of.resize(to.marks.size(), -1);
    const int shift = static_cast<int>(to.windows.size());
    for (const int window : chart.window_of) to.window_of.push_back(window < 0 ? -1 : window + shift);
    to.marks.insert(to.marks.end(), chart.marks.begin(), chart.marks.end());
    to.windows.insert(to.windows.end(), chart.windows.begin(), chart.windows.end());
  }

  const Chart& chart_;
  Box box_;
  Language language_;
};

}  // namespace

namespace {

void require_drawable(const Chart& chart) {
  require_sound(chart.x);
  require_sound(chart.y);
  require_sound(chart);
}

}  // namespace

ChartMap draw(const Chart& chart, Box box, Figure& figure, Language language) {
  require_drawable(chart);
  return ChartPainter(chart, box, language).run(figure);
}

ChartMap draw_axes(const Chart& chart, Box box, Figure& figure, Language language) {
  require_drawable(chart);
  return ChartPainter(chart, box, language).run(figure, ChartPainter::Shows::axes);
}

}  // namespace epure::drawings
