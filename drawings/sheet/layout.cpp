#include "drawings/sheet/layout.h"

#include "drawings/paths/vectors.h"

namespace epure::drawings {

namespace {

constexpr double air = 3;            // mm between the frame and what stands inside
constexpr double between_parts = 5;  // mm between drawing area and column

}  // namespace

Box paper_box(Paper paper) { return paper == Paper::a4 ? Box{{0, 0}, {297, 210}} : Box{{0, 0}, {420, 297}}; }

// Well under a third of A4: the rest takes a metre at 1 : 5 with its symbols. On A3 letters stay as they are, so the
// column needs little more and the figure gets the room.
double title_block_width(Paper paper) { return paper == Paper::a4 ? 80 : 112; }

Layout layout(Paper paper, double title_block_height) {
  Layout result;
  result.paper = paper_box(paper);
  result.frame = grown(result.paper, -margin);
  const Box frame = result.frame;
  const double left = frame.high.x - title_block_width(paper);
  result.title_block = {{left, frame.low.y}, {frame.high.x, frame.low.y + title_block_height}};
  result.drawing = {{frame.low.x + air, frame.low.y + air}, {left - between_parts, frame.high.y - air}};
  result.column = {{left + inset, result.title_block.high.y + air}, {frame.high.x - inset, frame.high.y - air}};
  return result;
}

Box drawing_area(Paper paper) { return layout(paper, 0).drawing; }

}  // namespace epure::drawings
