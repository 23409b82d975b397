#include "drawings/marks/canvas.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "drawings/output.h"
#include "drawings/paths/clip.h"
#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings {

void demand_drawable(double value) {
  // 10,000 km of paper, where a double is worth 2 nm: what is cut out of it for the sheet is still right.
  constexpr double absurd = 1e10;
  if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("{} is not a number on paper", value));
  if (std::abs(value) > absurd)
    throw TooFar(
        fmt::format(
            "{:.3g} mm is too far off the paper to be drawn: the figure's lengths differ too much, or its scale "
            "is too large",
            value),
        fmt::format("{:.3g} mm: troppo lontano dal foglio per un disegno: le lunghezze della figura differiscono "
                    "troppo, o la sua scala è troppo grande",
                    value));
}

void demand_drawable(Point p) {
  demand_drawable(p.x);
  demand_drawable(p.y);
}

namespace {

void demand_path_drawable(const Path& path) {
  demand_drawable(path.start);
  for (const Piece& piece : path.pieces) {
    demand_drawable(piece.end);
    if (piece.straight) continue;
    demand_drawable(piece.first_control);
    demand_drawable(piece.second_control);
  }
}

}  // namespace

Canvas::Canvas(Box area) : clip_(area), drawn_(area) {}

void Canvas::put(Primitive primitive) {
  std::visit([this](auto& p) { p.step = step_; }, primitive);
  (raised_ ? above_ : below_).push_back(std::move(primitive));
}

void Canvas::remember(const Path& path, double width) {
  const std::vector<Point> points = flatten(path);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto inside = clip_segment(points[i - 1], points[i], clip_);
    if (inside) drawn_.add({inside->first, inside->second, width / 2, width > fine, step_});
  }
}

void Canvas::stroke(const Path& path, const LineStyle& style, const std::string& name) {
  demand_path_drawable(path);
  bool first = true;
  for (const Path& run : clip_path(path, clip_)) {
    const std::vector<double> dashes =
        style.dashes.empty() ? style.dashes : fitted_dashes(style.dashes, path_length(run), run.closed);
    put(Stroke{run, style.width, dashes, style.colour, {}, first ? name : std::string{}});
    remember(run, style.width);
    first = false;
  }
}

void Canvas::area(const Path& path, Colour colour, const std::string& name, double tolerance) {
  demand_path_drawable(path);
  const Box box = bounds(path);
  if (apart(box, clip_)) return;
  if (contains(clip_, box)) {
    put(Fill{path, colour, {}, name});
    return;
  }
  const std::vector<Point> inside = clip_polygon(flatten(path, tolerance), clip_);
  if (inside.size() >= 3) put(Fill{polyline(inside, true), colour, {}, name});
}

void Canvas::fill(const Path& path, Colour colour, const std::string& name) {
  area(path, colour, name, 0.005);
  remember(path, 0.2);
}

void Canvas::tint(const Path& path, Colour colour, const std::string& name) {
  area(path, colour, name, 0.05);  // a light edge, most often under a line
}

void Canvas::text(const PlacedText& text) {
  demand_drawable(text.baseline);
  const TextSize size = measure(text.text, text.size, text.weight);
  const Point b = text.baseline;
  const Box box{{b.x, b.y - size.descent}, {b.x + size.width, b.y + size.ascent}};
  if (!contains(clip_, middle(box))) return;
  put(text);
  texts_.emplace_back(text.text, box);
}

std::vector<std::string> Canvas::crossed_texts() const {
  std::vector<std::string> crossed;
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    bool touched = false;
    drawn_.near(texts_[i].second, 0, [&](const Obstacle& o) {
      touched = gap(texts_[i].second, o.from, o.to) <= o.half_width;
      return !touched;
    });
    for (std::size_t j = 0; j < texts_.size(); ++j)
      touched = touched || (i != j && gap(texts_[i].second, texts_[j].second) <= 0);
    if (touched) crossed.push_back(texts_[i].first);
  }
  return crossed;
}

Obstacles Canvas::obstacles() const {
  Obstacles all = drawn_;
  for (const auto& [text, box] : texts_) {
    // The outline with a diagonal: whatever meets the box meets one of them, or lies inside and is itself met.
    const Point lower_right{box.high.x, box.low.y}, upper_left{box.low.x, box.high.y};
    const std::array corners{box.low, lower_right, box.high, upper_left, box.low, box.high};
    for (std::size_t i = 1; i < corners.size(); ++i) all.add({corners[i - 1], corners[i], 0, true});
  }
  return all;
}

std::vector<Primitive> Canvas::take() {
  below_.insert(below_.end(), above_.begin(), above_.end());
  above_.clear();
  return std::move(below_);
}

}  // namespace epure::drawings
