// Looks at a composed page from outside: samples its strokes point by point, without the code that placed the labels.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "drawings/page.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings::probe {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
inline const Box a4_area = drawing_area(Paper::a4);

// Points along the path, curves by their parameter; the next is at most about `step` mm further.
inline std::vector<Point> samples(const Path& path, double step) {
  std::vector<Point> points{path.start};
  const auto straight_to = [&](Point end) {
    const Point start = points.back();
    const int n = static_cast<int>(distance(start, end) / step) + 1;
    for (int i = 1; i <= n; ++i) points.push_back(between(start, end, static_cast<double>(i) / n));
  };
  for (const Piece& p : path.pieces) {
    const Point a = points.back();
    if (p.straight) {
      straight_to(p.end);
      continue;
    }
    const double polygon = distance(a, p.first_control) + distance(p.first_control, p.second_control) +
                           distance(p.second_control, p.end);
    const int n = static_cast<int>(3 * polygon / step) + 1;
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n, s = 1 - t;
      points.push_back(s * s * s * a + 3 * s * s * t * p.first_control + 3 * s * t * t * p.second_control +
                       t * t * t * p.end);
    }
  }
  if (path.closed) straight_to(path.start);
  return points;
}

inline Box text_box(const PlacedText& text) {
  const TextSize size = measure(text.text, text.size, text.weight);
  const Point b = text.baseline;
  return {{b.x, b.y - size.descent}, {b.x + size.width, b.y + size.ascent}};
}

template <typename Kind>
std::vector<Kind> all(const Page& page) {
  std::vector<Kind> found;
  for (const Primitive& p : page.primitives)
    if (const Kind* kind = std::get_if<Kind>(&p)) found.push_back(*kind);
  return found;
}

template <typename Kind>
std::vector<Kind> named(const Page& page, const std::string& name) {
  std::vector<Kind> found;
  for (const Kind& kind : all<Kind>(page))
    if (kind.name == name) found.push_back(kind);
  return found;
}

inline bool strictly_inside(Box box, Point p) {
  return p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y;
}

// Every text in `area` that a stroke's middle line or another text runs into, by its plain letters.
inline std::vector<std::string> disturbed(const Page& page, Box area) {
  std::vector<PlacedText> texts;
  for (const PlacedText& text : all<PlacedText>(page))
    if (contains(area, text_box(text))) texts.push_back(text);
  std::vector<std::string> found;
  const std::vector<Stroke> strokes = all<Stroke>(page);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Box box = text_box(texts[i]);
    bool hit = false;
    for (const Stroke& stroke : strokes)
      for (const Point p : samples(stroke.path, 0.2)) hit = hit || strictly_inside(box, p);
    for (std::size_t j = 0; j < texts.size(); ++j) hit = hit || (j != i && !apart(box, text_box(texts[j])));
    if (hit) found.push_back(plain(texts[i].text));
  }
  return found;
}

}  // namespace epure::drawings::probe
