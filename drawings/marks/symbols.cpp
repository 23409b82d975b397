#include "drawings/marks/symbols.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "drawings/output.h"
#include "drawings/paths/clip.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

constexpr double quarter = std::numbers::pi / 2;
constexpr LineStyle symbol_outline{medium, {}, black}, symbol_detail{fine, {}, black};

// Outlines of small signs are never as heavy as the links they stand beside.
LineStyle sign_style(Meaning meaning) {
  LineStyle style = line_style(meaning);
  style.width = std::min(style.width, narrow);
  style.dashes.clear();
  return style;
}

// Short strokes at 45° on the right of from -> to: solid ground.
void hatch(Canvas& canvas, Point from, Point to) {
  constexpr double spacing = 1.6, depth = 1.8;  // mm
  const double total = distance(from, to);
  if (total < depth) return;
  const Point along = unit(from, to), right = -1 * left_of(along);
  const int count = static_cast<int>((total - depth) / spacing);
  const double start = depth + (total - depth - count * spacing) / 2;
  for (int i = 0; i <= count; ++i) {
    const Point top = from + (start + i * spacing) * along;
    canvas.stroke(segment(top, top + depth * (right - along)), symbol_detail);
  }
}

void hinge_circle(Canvas& canvas, Point at) {
  canvas.raise();
  canvas.fill(circle(at, hinge_radius), white);
  canvas.stroke(circle(at, hinge_radius), symbol_outline);
  canvas.lower();
}

void draw_mark(Canvas& canvas, const Line& line) {
  canvas.stroke(line.path, line_style(line.meaning, line.type), line.name);
}

void draw_mark(Canvas& canvas, const Area& area) { canvas.tint(area.path, tint(area.meaning), area.name); }

void point(Canvas& canvas, Point at, Colour colour, const std::string& name) {
  canvas.raise();
  canvas.fill(circle(at, dot_radius), colour, name);
  canvas.lower();
}

void draw_mark(Canvas& canvas, const Arrow& arrow) {
  demand_drawable(arrow.from);
  demand_drawable(arrow.to);
  const LineStyle style = line_style(arrow.meaning);
  const double total = distance(arrow.from, arrow.to);
  if (total < head_length) {  // joined to where it starts, or a polygon of vectors would gape there
    if (total > dot_radius) canvas.stroke(segment(arrow.from, arrow.to), {style.width / 2, {}, style.colour});
    return point(canvas, arrow.to, style.colour, arrow.name);
  }
  const double head = std::min(head_length, total / 3);
  // The shaft ends inside the head, where it is wider than the shaft: its square end must not blunt the tip.
  const Point neck = arrow.to - 0.8 * head * unit(arrow.from, arrow.to);
  // Beside a small head the shaft grows thinner too, or the arrow would look like a pencil.
  const double width = style.width * std::max(0.5, head / head_length);
  canvas.stroke(segment(arrow.from, neck), {width, {}, style.colour}, arrow.name);
  const std::string head_name = arrow.name.empty() ? std::string{} : arrow.name + "_head";
  canvas.fill(arrow_head(arrow.to, arrow.to - arrow.from, head), style.colour, head_name);
}

void draw_mark(Canvas& canvas, const Dot& dot) { point(canvas, dot.at, ink(dot.meaning), dot.name); }

void draw_mark(Canvas& canvas, const Cross& cross) {
  constexpr double arm = 1.3;  // mm
  const LineStyle style{medium, {}, ink(cross.meaning)};
  canvas.raise();
  canvas.stroke(segment(cross.at - Point{arm, arm}, cross.at + Point{arm, arm}), style, cross.name);
  canvas.stroke(segment(cross.at + Point{-arm, arm}, cross.at + Point{arm, -arm}), style);
  canvas.lower();
}

Path diamond(Point at, double reach) {
  const Point x{reach, 0}, y{0, reach};
  return polyline({at - y, at + x, at + y, at - x}, true);
}

Path upright_triangle(Point at, double reach) {
  constexpr double sixth = std::numbers::pi / 6;
  return polyline(
      {at + reach * direction(-sixth), at + reach * direction(quarter), at + reach * direction(7 * sixth)}, true);
}

// The outlines enclose about equal areas, so that no shape seems to count for more.
Path outline(const DataPoint& point) {
  constexpr double radius = 0.95, half_side = 0.84, half_diagonal = 1.2, corner = 1.35;  // mm
  const Point at = point.at, x{half_side, 0}, y{0, half_side};
  switch (point.shape) {
    case PointShape::square:
      return polyline({at - x - y, at + x - y, at + x + y, at - x + y}, true);
    case PointShape::diamond:
      return diamond(at, half_diagonal);
    case PointShape::triangle:
      return upright_triangle(at, corner);
    default:
      return circle(at, radius);
  }
}

void strokes(Canvas& canvas, const DataPoint& point, Point arm, const LineStyle& style) {
  canvas.stroke(segment(point.at - arm, point.at + arm), style, point.name);
  canvas.stroke(segment(point.at - left_of(arm), point.at + left_of(arm)), style);
}

void draw_mark(Canvas& canvas, const DataPoint& point) {
  constexpr double arm = 1.2, diagonal = 0.85, dot = 0.75;  // mm
  demand_drawable(point.at);
  const LineStyle style{narrow, {}, ink(point.meaning)};
  canvas.raise();
  switch (point.shape) {
    case PointShape::dot:
      canvas.fill(circle(point.at, dot), style.colour, point.name);
      break;
    case PointShape::cross:
      strokes(canvas, point, {diagonal, diagonal}, style);
      break;
    case PointShape::plus:
      strokes(canvas, point, {arm, 0}, style);
      break;
    default:
      canvas.fill(outline(point), white);
      canvas.stroke(outline(point), style, point.name);
  }
  canvas.lower();
}

void draw_mark(Canvas& canvas, const Hinge& hinge) { hinge_circle(canvas, hinge.at); }

void draw_mark(Canvas& canvas, const FixedHinge& hinge) {
  constexpr double depth = 6, half_base = 3.5, half_ground = 5;  // mm
  demand_drawable(hinge.down);
  const Point down = direction(hinge.down), side = left_of(down);  // standing upright: to the right
  const Point foot = hinge.at + depth * down;
  const Path stand = polyline({foot - half_base * side, hinge.at, foot + half_base * side}, true);
  canvas.fill(stand, white);
  canvas.stroke(stand, symbol_outline);
  canvas.stroke(segment(foot - half_ground * side, foot + half_ground * side), line_style(Meaning::ground));
  hatch(canvas, foot - half_ground * side, foot + half_ground * side);
  hinge_circle(canvas, hinge.at);
}

void draw_mark(Canvas& canvas, const Slider& slider) {
  demand_drawable(slider.along);
  const Point along = (block_length / 2) * direction(slider.along);
  const Point up = (block_height / 2) * direction(slider.along + quarter);
  const Point at = slider.at;
  const Path block = polyline({at - along - up, at + along - up, at + along + up, at - along + up}, true);
  if (!slider.is_open) canvas.fill(block, white);
  // A number of what passes beneath an open one would be taken for the block's.
  if (slider.is_open)
    for (const double across : {-0.5, 0.0, 0.5})
      canvas.keep_clear(segment(at - along + across * up, at + along + across * up));
  canvas.stroke(block, line_style(Meaning::link));
}

void ground(Canvas& canvas, Point from, Point to) {
  // Cut before hatching, so that a guide of kilometres has no more strokes than show.
  const auto shown = clip_segment(from, to, grown(canvas.clip(), 5));
  if (!shown) return;
  canvas.stroke(segment(shown->first, shown->second), line_style(Meaning::ground));
  hatch(canvas, shown->first, shown->second);
}

void draw_mark(Canvas& canvas, const Guide& guide) {
  demand_drawable(guide.from);
  demand_drawable(guide.to);
  const Point shift = (-block_height / 2) * left_of(unit(guide.from, guide.to));
  ground(canvas, guide.from + shift, guide.to + shift);
}

void draw_mark(Canvas& canvas, const Ground& surface) {
  demand_drawable(surface.from);
  demand_drawable(surface.to);
  ground(canvas, surface.from, surface.to);
}

Path rounded(Point from, Point to, double radius) {
  if (distance(from, to) == 0) return circle(from, radius);
  const double along = angle_of(to - from);
  Path outline = arc(to, radius, along - quarter, along + quarter);
  const Path back = arc(from, radius, along + quarter, along + 3 * quarter);
  outline.pieces.push_back({true, {}, {}, back.start});
  outline.pieces.insert(outline.pieces.end(), back.pieces.begin(), back.pieces.end());
  outline.closed = true;
  return outline;
}

void draw_mark(Canvas& canvas, const Slot& slot) {
  demand_drawable(slot.from);
  demand_drawable(slot.to);
  demand_drawable(slot.width);
  if (!(slot.width > 0)) throw std::invalid_argument("a slot needs a width");
  const Path outline = rounded(slot.from, slot.to, slot.width / 2);
  canvas.fill(outline, white);
  canvas.stroke(outline, symbol_outline);
}

void draw_mark(Canvas& canvas, const Rotation& rotation) {
  demand_drawable(rotation.centre);
  demand_drawable(rotation.from);
  demand_drawable(rotation.to);
  const double sweep = std::abs(rotation.to - rotation.from);
  if (!(sweep > 0) || !(rotation.radius > 0)) throw std::invalid_argument("a rotation needs a radius and an angle");
  const LineStyle style = sign_style(rotation.meaning);
  const double head = std::min(head_length, rotation.radius * std::min(sweep, 2.0) / 3);
  // Tip and root of the head both lie on the arc, so the head points along the chord between them.
  const double bite = 2 * std::asin(head / 2 / rotation.radius);
  const double sense = rotation.to > rotation.from ? 1 : -1;
  const Point tip = rotation.centre + rotation.radius * direction(rotation.to);
  const Point root = rotation.centre + rotation.radius * direction(rotation.to - sense * bite);
  const double neck = rotation.to - sense * 0.8 * bite;
  canvas.stroke(arc(rotation.centre, rotation.radius, std::min(rotation.from, neck), std::max(rotation.from, neck)),
                style);
  canvas.fill(arrow_head(tip, tip - root, head), style.colour);
}

void draw_mark(Canvas& canvas, const RightAngle& mark) {
  constexpr double side = 2.2;  // mm
  demand_drawable(mark.first);
  demand_drawable(mark.second);
  const Point first = side * direction(mark.first), second = side * direction(mark.second);
  canvas.stroke(polyline({mark.at + first, mark.at + first + second, mark.at + second}, false), symbol_detail);
}

void draw_mark(Canvas& canvas, const ParallelMark& mark) {
  constexpr double arm = 1.8, spacing = 1.4, half_opening = std::numbers::pi / 5;  // mm, mm, rad
  if (mark.heads < 1 || mark.heads > 9) throw std::invalid_argument("a parallel mark has one to nine heads");
  demand_drawable(mark.along);
  for (int i = 0; i < mark.heads; ++i) {
    const Point tip = mark.at + (i - (mark.heads - 1) / 2.0) * spacing * direction(mark.along);
    canvas.stroke(polyline({tip - arm * direction(mark.along + half_opening), tip,
                            tip - arm * direction(mark.along - half_opening)},
                           false),
                  symbol_outline);
  }
}

void draw_mark(Canvas& canvas, const AngleMark& mark) {
  demand_drawable(mark.at);
  demand_drawable(mark.from);
  demand_drawable(mark.to);
  canvas.stroke(arc(mark.at, mark.radius, mark.from, mark.to), sign_style(mark.meaning));
}

void draw_mark(Canvas& canvas, const Dimension& dimension) {
  constexpr double off_point = 1, beyond = 1.5;  // mm: extension lines
  demand_drawable(dimension.from);
  demand_drawable(dimension.to);
  demand_drawable(dimension.offset);
  const LineStyle style = line_style(Meaning::dimension);
  const auto [from, to] = dimension_line(dimension);
  const double away = std::abs(dimension.offset);
  if (away > off_point) {
    canvas.stroke(
        segment(between(dimension.from, from, off_point / away), between(dimension.from, from, 1 + beyond / away)),
        style);
    canvas.stroke(segment(between(dimension.to, to, off_point / away), between(dimension.to, to, 1 + beyond / away)),
                  style);
  }
  canvas.stroke(segment(from, to), style);
  const double head = std::min(head_length, distance(from, to) / 3);
  canvas.fill(arrow_head(to, to - from, head), style.colour);
  canvas.fill(arrow_head(from, from - to, head), style.colour);
}

void draw_mark(Canvas& canvas, const Writing& writing) {
  if (writing.text.empty()) return;
  canvas.text({writing.text, writing.baseline, writing.size, ink(writing.ink), Weight::regular, writing.row, 0,
               writing.anchor});
}

void centred_text(Canvas& canvas, const std::string& text, Point baseline_middle, double size) {
  if (text.empty()) return;
  const double width = measure(text, size).width;
  canvas.text({.text = text,
               .baseline = baseline_middle - Point{width / 2, 0},
               .size = size,
               .colour = black,
               .anchor = 0.5});
}

void draw_mark(Canvas& canvas, const ScaleBar& bar) {
  constexpr double height = 1.1, caption_size = 3.2, tick_size = 2.7;  // mm
  if (bar.divisions < 1 || bar.divisions > 100 || !(bar.length > 0))
    throw std::invalid_argument("a scale bar needs a length and 1 to 100 divisions");
  demand_drawable(bar.at);
  demand_drawable(bar.length);
  const double part = bar.length / bar.divisions;
  const auto piece = [&](int i) {
    const Point low = bar.at + Point{i * part, 0};
    return polyline({low, low + Point{part, 0}, low + Point{part, height}, low + Point{0, height}}, true);
  };
  for (int i = 0; i < bar.divisions; i += 2) canvas.fill(piece(i), black);
  canvas.stroke(
      polyline({bar.at, bar.at + Point{bar.length, 0}, bar.at + Point{bar.length, height}, bar.at + Point{0, height}},
               true),
      symbol_detail);
  for (std::size_t i = 0; i < bar.ticks.size(); ++i) {
    const Point tick = bar.at + Point{static_cast<double>(i) * part, 0};
    centred_text(canvas, bar.ticks[i], tick - Point{0, 1.1 + 0.68 * tick_size}, tick_size);
  }
  if (!bar.caption.empty())
    canvas.text({bar.caption, bar.at + Point{0, height + 1.4}, caption_size, black, Weight::regular});
}

constexpr std::array<Phrase, std::variant_size_v<Mark>> kinds{{{"line", "linea"},
                                                               {"area", "area"},
                                                               {"arrow", "freccia"},
                                                               {"dot", "punto"},
                                                               {"cross", "croce"},
                                                               {"data point", "punto del grafico"},
                                                               {"hinge", "cerniera"},
                                                               {"fixed hinge", "cerniera fissa"},
                                                               {"slider", "corsoio"},
                                                               {"guide", "guida"},
                                                               {"ground", "telaio"},
                                                               {"slot", "asola"},
                                                               {"rotation", "rotazione"},
                                                               {"right angle", "angolo retto"},
                                                               {"parallel mark", "segno di parallelismo"},
                                                               {"angle mark", "angolo"},
                                                               {"dimension", "quota"},
                                                               {"writing", "scritta"},
                                                               {"scale bar", "scala grafica"}}};

std::string name_of(const Mark& mark) {
  return std::visit(
      [](const auto& m) {
        if constexpr (requires { m.name; })
          return m.name;
        else
          return std::string{};
      },
      mark);
}

}  // namespace

std::pair<Point, Point> dimension_line(const Dimension& dimension) {
  const Point shift = dimension.offset * left_of(unit(dimension.from, dimension.to));
  return {dimension.from + shift, dimension.to + shift};
}

Path arrow_head(Point tip, Point towards, double length) {
  const Point back = -length * unit({}, towards);
  const Point side = std::tan(head_angle / 2 * std::numbers::pi / 180) * left_of(back);
  return polyline({tip, tip + back + side, tip + back - side}, true);
}

void draw(Canvas& canvas, const Mark& mark) {
  std::visit([&](const auto& m) { draw_mark(canvas, m); }, mark);
}

std::vector<Primitive> circled_number(Point centre, int number, double diameter, Colour colour) {
  const std::string text = fmt::format("{}", number);
  // Two figures must fit inside the circle too.
  const double size = (text.size() > 1 ? 0.56 : 0.7) * diameter;
  const TextSize extent = measure(text, size);
  const Point baseline = centre - Point{extent.width / 2, (extent.ascent - extent.descent) / 2};
  return {Stroke{circle(centre, diameter / 2), fine, {}, colour, {}, {}},
          PlacedText{text, baseline, size, colour, Weight::regular}};
}

std::string describe(const Mark& mark, std::size_t index) {
  const std::string name = name_of(mark);
  const std::string kind = kinds.at(mark.index()).english;
  return name.empty() ? fmt::format("{} (mark {})", kind, index)
                      : fmt::format("{} '{}' (mark {})", kind, name, index);
}

Words in_words(const Mark& mark) {
  const std::string name = name_of(mark);
  return Words(kinds.at(mark.index())) + (name.empty() ? "" : " " + name);
}

}  // namespace epure::drawings
