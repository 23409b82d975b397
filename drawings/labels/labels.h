// Automatic label placement: every label finds a place beside its point or segment where it touches no line, no
// symbol and no other label; where there is none near, a farther one with a thin leader.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawings/labels/obstacles.h"
#include "drawings/picture.h"

namespace epure::drawings {

using Segment = std::pair<Point, Point>;

// A vector, a line or a point (a segment of no length) that letters name, and others that they seem to name when they
// stand nearer to these. Between a point, a link or an arc and its letters lies no vector that does not end there and
// no centre line, and between an arc and its letters no link.
struct Naming {
  Segment own;
  std::vector<Segment> others;
  std::vector<Segment> not_between = {};
};

// What is to be placed: a box of known size that belongs to a point, or to the segment at-to.
struct LabelBox {
  double width = 0, height = 0;
  Point at;
  std::optional<Point> to = {};
  std::optional<Point> away_from = {};
  std::optional<Naming> naming = {};  // none: it names nothing
  std::optional<Box> window = {};     // what it belongs to is drawn in this one: it stands there, if it can
  int step = 0;                       // of the construction, which draws it; 0: it was there before
  // The number of its step: on a line that this one drew, or at a point where lines of other steps may meet.
  enum class Number { no, at_point, on_line } number = Number::no;
  std::optional<Segment> along =
      {};  // of that line, where it is straight, what shows: the number may stand there too
};

struct Place {
  Box box;
  std::optional<Segment> leader = {};  // from the box to what it names
  bool found = false;  // false: what it belongs to lies outside the area, or the area is too small for it
  bool touches_drawing = false;
  std::vector<std::size_t> touches = {};  // other labels
};

// Deterministic; the result has one place a label, in the same order.
std::vector<Place> place_labels(const std::vector<LabelBox>& labels, const Obstacles& obstacles, Box area);

// White space labels keep to each other and to lines where there is room for it.
inline constexpr double label_clearance = 1;  // mm

}  // namespace epure::drawings
