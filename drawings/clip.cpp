#include "drawings/clip.h"

#include "drawings/flatten.h"
#include "drawings/vectors.h"

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

  void curve(Point from, const Piece& piece, int depth) {
    const Box hull = bounds({from, {piece}, false});
    if (apart(hull, box_)) return;
    const bool inside = contains(box_, hull);
    const bool small = hull.width() + hull.height() <= 0.5 * (box_.width() + box_.height());
    if (inside || small || depth == 0) {
      result_.overhangs = result_.overhangs || !inside;
      append(from, piece);
      return;
    }
    const Halves halves = halve(from, piece);
    curve(from, halves.first, depth - 1);
    curve(halves.first.end, halves.second, depth - 1);
  }

  ClippedPath take() { return std::move(result_); }

 private:
  void append(Point from, const Piece& piece) {
    const bool continues = !result_.runs.empty() && distance(end_, from) == 0;
    if (!continues) result_.runs.push_back({from, {}, false});
    result_.runs.back().pieces.push_back(piece);
    end_ = piece.end;
  }

  Box box_;
  Point end_;
  ClippedPath result_;
};

}  // namespace

ClippedPath clip_path(const Path& path, Box box) {
  if (contains(box, bounds(path))) return {{path}, false};
  Clipper clipper(box);
  Point at = path.start;
  for (const Piece& piece : path.pieces) {
    // 24 halvings bring 10 km down to a millimetre.
    if (piece.straight)
      clipper.straight(at, piece.end);
    else
      clipper.curve(at, piece, 24);
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
