#include "drawings/sheet/bars_below.h"

#include <fmt/format.h>

#include "drawings/marks/canvas.h"
#include "drawings/marks/symbols.h"
#include "drawings/paths/vectors.h"
#include "drawings/sheet/ink.h"
#include "drawings/text/text.h"

namespace epure::drawings {
namespace {

// More than a bar takes with its letters, on each side of the point where it stands.
constexpr double around_bar = 300;  // mm

// What a bar covers, from the point where it stands.
Box reach(ScaleBar bar) {
  bar.at = {};
  Canvas canvas(grown(Box{}, around_bar));
  draw(canvas, bar);
  return ink_box(canvas.take());
}

// Moves each bar to its place. Rows are alike, so that the bars of one stand on one line.
void set_in_rows(std::vector<ScaleBar>& bars, Box drawn) {
  constexpr double under = 3, between_bars = 8, between_rows = 2.5;  // mm
  Box tallest = nothing();
  for (const ScaleBar& bar : bars) tallest = include(tallest, reach(bar));
  double left = drawn.low.x, line = drawn.low.y - under - tallest.high.y;
  for (ScaleBar& bar : bars) {
    const Box box = reach(bar);
    if (left > drawn.low.x && left + box.width() > drawn.high.x) {
      left = drawn.low.x;
      line -= tallest.height() + between_rows;
    }
    bar.at = {left - box.low.x, line};
    left += box.width() + between_bars;
  }
}

}  // namespace

std::vector<ScaleBar> taken_out(Figure& figure) {
  std::vector<ScaleBar> bars;
  std::vector<Mark> others;
  std::vector<int> windows;
  std::vector<KnownStep> known;
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    if (const auto* bar = std::get_if<ScaleBar>(&figure.marks[i])) {
      bars.push_back(*bar);
      continue;
    }
    others.push_back(std::move(figure.marks[i]));
    windows.push_back(i < figure.window_of.size() ? figure.window_of[i] : -1);
    known.push_back(i < figure.known_of_marks.size() ? figure.known_of_marks[i] : KnownStep{});
  }
  figure.marks = std::move(others);
  figure.window_of = std::move(windows);
  figure.known_of_marks = std::move(known);
  return bars;
}

std::vector<Primitive> bars_below(Box drawn, std::vector<ScaleBar> bars, std::vector<std::string>* conflicts) {
  set_in_rows(bars, is_nothing(drawn) ? Box{} : drawn);
  Box room = nothing();
  for (const ScaleBar& bar : bars) room = include(room, grown(Box{bar.at, bar.at}, around_bar));
  Canvas canvas(is_nothing(room) ? Box{} : room);
  for (const ScaleBar& bar : bars) draw(canvas, bar);
  if (conflicts)
    for (const std::string& text : canvas.crossed_texts())
      conflicts->push_back(fmt::format("'{}' touches a line, a symbol or other letters", plain(text)));
  return canvas.take();
}

}  // namespace epure::drawings
