#include "drawings/paths/clip.h"

#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"

namespace epure::drawings {

std::optional<std::pair<Point, Point>> clip_segment(Point from, Point to, Box box) {
  const Point d = to - from;
  double enter = 0, leave = 1;
  // Liang and Barsky: along each border normal the segment enters or leaves at one parameter.
  const auto cut = [&](double towards, double room) {
    if (towards == 0) return room >= 0;
    const double t = room / towards;
    if (towards < 0)
      enter = std::max(enter, t);
    else
      leave = std::min(leave, t);
    return enter <= leave;
  };
  if (!cut(-d.x, from.x - box.low.x) || !cut(d.x, box.high.x - from.x) || !cut(-d.y, from.y - box.low.y) ||
      !cut(d.y, box.high.y - from.y))
    return std::nullopt;
  // The ends themselves are kept bit by bit where nothing is cut off: they are what gets measured.
  return std::pair{enter > 0 ? nearest_in(box, between(from, to, enter)) : from,
                   leave < 1 ? nearest_in(box, between(from, to, leave)) : to};
}

namespace {

class Clipper {
 public:
  explicit Clipper(Box box) : box_(box) {}

  void straight(Point from, Point to) {
    const auto inside = clip_segment(from, to, box_);
    if (inside) append(inside->first, {true, {}, {}, inside->second});
  }

  void curve(Point from, const Piece& piece) {
    shown_.clear();
    find_shown(from, piece, 0, 1);
    for (const auto& [begin, end] : shown_) {
      Point start = from;
      Piece part = piece;
      if (end < 1) part = split(start, part, end).first;
      if (begin > 0) {
        const Halves halves = split(start, part, begin / end);
        start = halves.first.end;
        part = halves.second;
      }
      append(start, part);
    }
  }

  std::vector<Path> take() { return std::move(runs_); }

 private:
  // `part` is the curve between the two parameters: halved until it is inside, outside, or too small to be seen.
  void find_shown(Point from, const Piece& part, double begin, double end) {
    const Box hull = bounds({from, {part}, false});
    if (apart(hull, box_)) return;
    if (contains(box_, hull)) {
      if (!shown_.empty() && shown_.back().second == begin)
        shown_.back().second = end;
      else
        shown_.emplace_back(begin, end);
      return;
    }
    const double middle = (begin + end) / 2;
    if (hull.width() + hull.height() <= file_resolution / 4 || middle <= begin || middle >= end) return;
    const Halves halves = split(from, part, 0.5);
    find_shown(from, halves.first, begin, middle);
    find_shown(halves.first.end, halves.second, middle, end);
  }

  void append(Point from, const Piece& piece) {
    const bool continues = !runs_.empty() && distance(end_, from) == 0;
    if (!continues) runs_.push_back({from, {}, false});
    runs_.back().pieces.push_back(piece);
    end_ = piece.end;
  }

  Box box_;
  Point end_;
  std::vector<std::pair<double, double>> shown_;  // of the curve in hand, by its parameter
  std::vector<Path> runs_;
};

}  // namespace

std::vector<Path> clip_path(const Path& path, Box box) {
  if (contains(box, bounds(path))) return {path};
  Clipper clipper(box);
  Point at = path.start;
  for (const Piece& piece : path.pieces) {
    if (piece.straight)
      clipper.straight(at, piece.end);
    else
      clipper.curve(at, piece);
    at = piece.end;
  }
  if (path.closed && distance(at, path.start) > 0) clipper.straight(at, path.start);
  return clipper.take();
}

namespace {

// One side of the box: keeps what lies where `room` is not negative.
template <typename Room>
std::vector<Point> cut_polygon(const std::vector<Point>& corners, Room room) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    const double at_a = room(a), at_b = room(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) kept.push_back(between(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

}  // namespace

std::vector<Point> clip_polygon(std::vector<Point> corners, Box box) {
  corners = cut_polygon(corners, [&](Point p) { return p.x - box.low.x; });
  corners = cut_polygon(corners, [&](Point p) { return box.high.x - p.x; });
  corners = cut_polygon(corners, [&](Point p) { return p.y - box.low.y; });
  return cut_polygon(corners, [&](Point p) { return box.high.y - p.y; });
}

}  // namespace epure::drawings
