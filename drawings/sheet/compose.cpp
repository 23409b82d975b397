// From a sheet of marks with meanings to a page of primitives.
#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <tuple>

#include "drawings/labels/labels.h"
#include "drawings/labels/namesakes.h"
#include "drawings/labels/window.h"
#include "drawings/marks/canvas.h"
#include "drawings/marks/symbols.h"
#include "drawings/output.h"
#include "drawings/paths/clip.h"
#include "drawings/paths/vectors.h"
#include "drawings/sheet/bars_below.h"
#include "drawings/sheet/column.h"
#include "drawings/sheet/ink.h"
#include "drawings/sheet/layout.h"
#include "drawings/sheet/steps_of_marks.h"
#include "drawings/sheet/title_block.h"
#include "drawings/stopwatch.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

void draw_marks(Canvas& canvas, const Figure& figure, Box area, const StepsOfMarks& steps) {
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    canvas.clip_to(window_of(figure, i, area));
    canvas.in_step(steps.marks[i]);
    try {
      draw(canvas, figure.marks[i]);
    } catch (const std::invalid_argument& wrong) {
      throw std::invalid_argument(fmt::format("{}: {}", describe(figure.marks[i], i), wrong.what()));
    } catch (const TooFar& why) {
      throw TooFar(in_words(figure.marks[i]) + ": " + why.words());
    }
  }
  canvas.clip_to(area);
}

// What the label machine places, and how to draw it once it has a place.
struct Placeable {
  LabelBox box;
  std::string text;  // empty: the number of a step
  double size = 0, descent = 0;
  Colour colour;
  int number = 0;
  std::string name() const {
    return text.empty() ? fmt::format("step {}", number) : fmt::format("label '{}'", plain(text));
  }
};

Placeable placeable(const Label& label) {
  const TextSize extent = measure(label.text, label.size);
  return {.box = {extent.width, extent.ascent + extent.descent, label.at, label.to, label.away_from},
          .text = label.text,
          .size = label.size,
          .descent = extent.descent,
          .colour = ink(label.ink)};
}

// What shows of a line or vector, if that is straight.
std::optional<Segment> straight_part(const Figure& figure, std::size_t mark, Box area) {
  const Box window = window_of(figure, mark, area);
  if (const auto* arrow = std::get_if<Arrow>(&figure.marks[mark]))
    return clip_segment(arrow->from, arrow->to, window);
  const Path& path = std::get<Line>(figure.marks[mark]).path;
  if (path.pieces.size() != 1 || !path.pieces.front().straight) return {};
  return clip_segment(path.start, path.pieces.front().end, window);
}

// The smallest in which this point shows, of a close-up or a chart; none: the drawing area alone. What stands at the
// border of one has its letters on either side of it.
std::optional<Box> window_around(const Figure& figure, Point at, Box area) {
  constexpr double border = 1.5;  // mm
  std::optional<Box> found;
  for (const Box& window : figure.windows)
    if (contains(grown(window, -border), at) && !contains(window, area) &&
        (!found || window.width() < found->width()))
      found = window;
  return found;
}

std::vector<Placeable> placeables(const Figure& figure, Box area, const StepsOfMarks& steps) {
  const Namesakes namesakes(figure, figure.labels, area);
  std::vector<Placeable> all;
  for (std::size_t i = 0; i < figure.labels.size(); ++i) {
    const Label& label = figure.labels[i];
    if (label.text.empty()) continue;
    all.push_back(placeable(label));
    LabelBox& box = all.back().box;
    box.step = steps.labels[i];
    box.naming = namesakes.of(label, box.width);
    if (label.to) std::tie(box.at, box.to) = box.naming->own;
    if (!label.to) box.window = window_around(figure, label.at, area);
  }
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    const auto* dimension = std::get_if<Dimension>(&figure.marks[i]);
    if (!dimension || dimension->text.empty()) continue;
    const auto [from, to] = dimension_line(*dimension);
    all.push_back(placeable(Label{.text = dimension->text, .at = from, .to = to}));
    all.back().box.step = steps.marks[i];
  }
  for (std::size_t i = 0; i < figure.steps.size(); ++i) {
    const StepNumber& step = figure.steps[i];
    LabelBox box{step_diameter, step_diameter, step.at};
    box.step = step.number;
    box.number = LabelBox::Number::at_point;
    if (const auto line = steps.lines[i]) {
      box.number = LabelBox::Number::on_line;
      box.along = straight_part(figure, *line, area);
    }
    all.push_back({.box = box, .text = {}, .colour = black, .number = step.number});
  }
  return all;
}

void require_numbers(const Placeable& item) {
  try {
    demand_drawable(item.box.at);
    if (item.box.to) demand_drawable(*item.box.to);
    if (item.box.away_from) demand_drawable(*item.box.away_from);
  } catch (const std::invalid_argument& wrong) {
    throw std::invalid_argument(fmt::format("{}: {}", item.name(), wrong.what()));
  } catch (const TooFar& why) {
    const std::string name = item.text.empty() ? std::to_string(item.number) : plain(item.text);
    throw TooFar((item.text.empty() ? Words{"step ", "passo "} : Words{}) + name + ": " + why.words());
  }
}

// Of what letters belong to, or of the leader to it, the point that is nearest to them.
Point named_at(const LabelBox& label, const Place& place) {
  if (place.leader) return place.leader->first;
  return label.to ? nearest_on(label.at, *label.to, middle(place.box)) : label.at;
}

// There the letters stay where they are.
double anchor(const Box& letters, Point at) { return at.x <= letters.low.x ? 0 : at.x >= letters.high.x ? 1 : 0.5; }

void draw_placed(std::vector<Primitive>& ink, const Placeable& item, const Place& place) {
  const std::size_t before = ink.size();
  if (place.leader)
    ink.push_back(Stroke{segment(place.leader->first, place.leader->second), fine, {}, black, {}, {}});
  if (item.text.empty()) {
    const auto circled = circled_number(middle(place.box), item.number, step_diameter, item.colour);
    ink.insert(ink.end(), circled.begin(), circled.end());
  } else {
    ink.push_back(PlacedText{.text = item.text,
                             .baseline = {place.box.low.x, place.box.low.y + item.descent},
                             .size = item.size,
                             .colour = item.colour,
                             .anchor = anchor(place.box, named_at(item.box, place))});
  }
  belongs_to(item.box.step, ink, before);
}

void report(std::vector<std::string>& conflicts, const std::vector<Placeable>& items,
            const std::vector<Place>& places) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!places[i].found) conflicts.push_back(items[i].name() + " has no place inside the drawing area");
    if (places[i].touches_drawing) conflicts.push_back(items[i].name() + " touches a line or symbol");
    for (const std::size_t j : places[i].touches)
      if (i < j) conflicts.push_back(items[i].name() + " overlaps " + items[j].name());
  }
}

// The column tells the steps.
std::vector<Primitive> figure_ink(const Figure& figure, Box area, const std::vector<Block>& column,
                                  std::vector<std::string>* conflicts) {
  const StepsOfMarks steps = steps_of_marks(figure, column);
  Canvas canvas(area);
  draw_marks(canvas, figure, area, steps);
  const std::vector<Placeable> items = placeables(figure, area, steps);
  std::vector<LabelBox> boxes;
  for (const Placeable& item : items) {
    require_numbers(item);
    boxes.push_back(item.box);
  }
  const std::vector<Place> places = place_labels(boxes, canvas.obstacles(), area);
  if (conflicts) {
    for (const std::string& text : canvas.crossed_texts())
      conflicts->push_back(fmt::format("'{}' touches a line, a symbol or other letters", plain(text)));
    report(*conflicts, items, places);
  }
  std::vector<Primitive> ink = canvas.take();
  for (std::size_t i = 0; i < items.size(); ++i)
    if (places[i].found) draw_placed(ink, items[i], places[i]);
  return ink;
}

void append(std::vector<Primitive>& to, std::vector<Primitive> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

Stroke frame_line(Box frame) {
  return {polyline({frame.low, {frame.high.x, frame.low.y}, frame.high, {frame.low.x, frame.high.y}}, true),
          wide,
          {},
          black,
          {},
          {}};
}

// The figure, its scale bars right under it.
std::vector<Primitive> bare_ink(const Sheet& sheet, std::vector<std::string>* conflicts) {
  Figure figure = sheet.figure;
  std::vector<ScaleBar> bars = taken_out(figure);
  std::vector<Primitive> primitives = figure_ink(figure, drawing_area(sheet.paper), sheet.column, conflicts);
  append(primitives, bars_below(ink_box(primitives), std::move(bars), conflicts));
  return primitives;
}

// Each primitive says which step drew it.
Page composed(const Sheet& sheet, std::vector<std::string>* conflicts) {
  const Timed timed(Work::layout);
  Page page{sheet.id, sheet.title, sheet.description, paper_box(sheet.paper), sheet.language, {}, !sheet.bare};
  if (sheet.bare) {
    page.primitives = bare_ink(sheet, conflicts);
    const Box box = ink_box(page.primitives);
    if (!is_nothing(box)) page.extent = grown(box, 2);
    return page;
  }
  page.primitives = figure_ink(sheet.figure, drawing_area(sheet.paper), sheet.column, conflicts);
  const Layout parts = layout(sheet.paper, title_block_height(sheet));
  page.primitives.push_back(frame_line(parts.frame));
  append(page.primitives, set_title_block(sheet, parts.title_block, conflicts));
  append(page.primitives, set_column(sheet.column, parts.column, sheet.language, conflicts));
  return page;
}

}  // namespace

Page compose(const Sheet& sheet, std::vector<std::string>* conflicts) {
  Page page = composed(sheet, conflicts);
  belongs_to(0, page.primitives);
  return page;
}

Page compose_in_steps(const Sheet& sheet) {
  Page page = composed(sheet, nullptr);
  for (const Block& block : sheet.column)
    if (const auto* steps = std::get_if<Steps>(&block))
      page.steps.insert(page.steps.end(), steps->lines.begin(), steps->lines.end());
  return page;
}

Page after_step(Page page, int step) {
  std::erase_if(page.primitives, [&](const Primitive& primitive) {
    return std::visit([](const auto& p) { return p.step; }, primitive) > step;
  });
  return page;
}

std::vector<std::string> overlaps(const Sheet& sheet) {
  std::vector<std::string> conflicts;
  compose(sheet, &conflicts);
  return conflicts;
}

}  // namespace epure::drawings
