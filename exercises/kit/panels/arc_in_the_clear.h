// An arc arrow clear of what is drawn already: of links and vectors, of supports with their hatching, of other arcs.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/senses.h"

namespace epure {

// What is drawn as strokes, with as many mm to either side.
class DrawnStrokes {
 public:
  explicit DrawnStrokes(const std::vector<drawings::Mark>& marks) {
    for (const drawings::Mark& mark : marks) std::visit([this](const auto& each) { add(each); }, mark);
  }
  // From the nearest, mm; within its width negative.
  double room_at(const drawings::Point& P) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Stroke& each : strokes_)
      least = std::min(least, drawings::distance(P, drawings::nearest_on(each.from, each.to, P)) - each.half_width);
    return least;
  }

 private:
  struct Stroke {
    drawings::Point from, to;
    double half_width;
  };
  static constexpr double line = 0.5, head = 1.2, hinge = 1.7;  // mm to either side

  void add(const drawings::Line& mark) {
    if (mark.meaning != Meaning::link && mark.meaning != Meaning::ground) return;
    const std::vector<drawings::Point> points = drawings::flatten(mark.path);
    for (std::size_t i = 1; i < points.size(); ++i) strokes_.push_back({points[i - 1], points[i], line});
  }
  void add(const drawings::Arrow& mark) { strokes_.push_back({mark.from, mark.to, head}); }
  void add(const drawings::Hinge& mark) { strokes_.push_back({mark.at, mark.at, hinge}); }
  void add(const drawings::FixedHinge& mark) {
    constexpr double depth = 6.9, half_ground = 5, hatched = 1.4;  // mm of its base, to the middle of the hatching
    const drawings::Point down = drawings::direction(mark.down), side = half_ground * drawings::left_of(down),
                          base = mark.at + depth * down;
    strokes_.push_back({base - side, base + side, hatched});
    strokes_.push_back({mark.at, base, hinge});
  }
  void add(const drawings::Slider& mark) {
    constexpr double half = 5, high = 3;  // mm
    const drawings::Point along = half * drawings::direction(mark.along);
    strokes_.push_back({mark.at - along, mark.at + along, high + line});
  }
  void add(const drawings::Guide& mark) { add_wall(mark.from, mark.to); }
  void add(const drawings::Ground& mark) { add_wall(mark.from, mark.to); }
  void add_wall(const drawings::Point& from, const drawings::Point& to) {
    constexpr double hatched = 2;  // mm
    strokes_.push_back({from, to, hatched});
  }
  void add(const drawings::Rotation& mark) {
    const auto [from, to] = std::minmax(mark.from, mark.to);
    const std::vector<drawings::Point> points = drawings::flatten(drawings::arc(mark.centre, mark.radius, from, to));
    for (std::size_t i = 1; i < points.size(); ++i) strokes_.push_back({points[i - 1], points[i], head});
  }
  template <class Other>
  void add(const Other&) {}  // thin lines, and letters, which give way

  std::vector<Stroke> strokes_;
};

// Where it is if that is clear; else farther out, or else the nearest about the same point that is; where none is,
// with most room.
inline ArcArrow arc_in_the_clear(const ArcArrow& usual, const drawings::Point& O,
                                 const std::vector<drawings::Mark>& marks) {
  constexpr double enough = 0.7, further = 4;  // mm
  constexpr int directions = 24, pieces = 12;
  const DrawnStrokes drawn(marks);
  const auto room_of = [&](const ArcArrow& arc) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= pieces; ++i)
      least = std::min(
          least, drawn.room_at(O + arc.radius *
                                       drawings::direction(arc.middle + sweep_of_arrow * (1.0 * i / pieces - 0.5))));
    return least;
  };
  ArcArrow best = usual;
  double most = room_of(usual);
  for (int i = 0; i < directions; ++i)
    for (const double by : {0.0, further}) {
      if (most >= enough) return best;
      ArcArrow other = usual;
      other.middle += (i + 1) / 2 * (i % 2 == 0 ? 1 : -1) * 2 * std::numbers::pi / directions;
      other.radius += by;
      if (const double found = room_of(other); found > most) {
        best = other;
        most = found;
      }
    }
  return best;
}

}  // namespace epure
