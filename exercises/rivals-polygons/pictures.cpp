#include "exercises/rivals-polygons/pictures.h"

#include <fmt/format.h>

#include <cassert>
#include <optional>
#include <utility>

#include "exercises/kit/panels/sheet.h"

namespace epure::rivals_polygons {
namespace {

constexpr double caption_height = 6;  // mm at the top of a picture's cell
constexpr double caption_size = 2.7;  // mm

std::vector<const PolygonSide*> drawn_sides(const std::vector<PolygonSide>& chain) {
  std::vector<const PolygonSide*> sides;
  for (const PolygonSide& side : chain)
    if (side.is_drawn()) sides.push_back(&side);
  return sides;
}

Words known(const PolygonSide& side) { return {side.label + " known", side.label + " nota"}; }

Words directions(const VectorPolygon& polygon) {
  const PolygonSide &closing = polygon.right.back(), &sought = polygon.left.back();
  if (sought.closes_alone()) return {"direction of " + sought.label, "direzione di " + sought.label};
  return {fmt::format("directions of {} and {}", closing.label, sought.label),
          fmt::format("direzioni di {} e {}", closing.label, sought.label)};
}

// What is where on the sheet, and at which scales.
struct Arrangement {
  std::vector<drawings::Box> cells;  // below their captions
  int empty_cells;                   // of the grid
  Fit lengths, vectors;              // the vectors' origin is that of the first cell, the narrowest
};

// A row of equal cells, apart enough for neighbours' letters to be told apart.
void add_row(std::vector<drawings::Box>& cells, const drawings::Box& room, int count) {
  constexpr double gap = 3;  // mm
  const double width = room.width() / count;
  for (int i = 0; i < count; ++i)
    cells.push_back(
        {{room.low.x + i * width + gap / 2, room.low.y}, {room.low.x + (i + 1) * width - gap / 2, room.high.y}});
}

// Rows of `columns` cells, from above. The first row begins at `left`, with `taken` cells fewer.
std::vector<drawings::Box> grid(const drawings::Box& room, int columns, int rows, int taken, double left, int count) {
  std::vector<drawings::Box> cells;
  const double height = room.height() / rows;
  for (int row = 0; row < rows; ++row) {
    const double top = room.high.y - row * height;
    add_row(cells, {{row == 0 ? left : room.low.x, top - height}, {room.high.x, top}},
            row == 0 ? columns - taken : columns);
  }
  cells.resize(static_cast<std::size_t>(count));
  return cells;
}

drawings::Point centre(const drawings::Box& box) {
  return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
}

class Arranger {
 public:
  Arranger(const MechanismFigure& mechanism, const VectorPolygon& polygon, std::size_t pictures,
           const SheetRequest& request)
      : mechanism_(mechanism),
        polygon_(polygon),
        count_(static_cast<int>(pictures)),
        request_(request),
        room_(room_above_scale_bars(request)) {}

  Arrangement best() {
    for (int columns = 1; columns <= count_; ++columns)
      for (const double share : {0.46, 0.40, 0.34, 0.28}) try_mechanism_above(columns, share);
    for (int columns = 2; columns <= count_; ++columns)
      for (int taken = 1; taken < columns; ++taken)
        for (const double wider : {1.0, 1.1}) try_mechanism_among(columns, taken, wider);
    if (!best_) throw *refusal_;
    return *best_;
  }

 private:
  static int rows_for(int columns, int cells) { return (cells + columns - 1) / columns; }

  // The mechanism over the whole width, a grid of pictures below it.
  void try_mechanism_above(int columns, double share) {
    const int rows = rows_for(columns, count_);
    const double divide = room_.high.y - share * room_.height();
    consider({{room_.low.x, divide}, room_.high},
             grid({room_.low, {room_.high.x, divide}}, columns, rows, 0, room_.low.x, count_),
             columns * rows - count_);
  }

  // The mechanism where the first cells of the grid's first row would be, or `wider` than these.
  void try_mechanism_among(int columns, int taken, double wider) {
    const int rows = rows_for(columns, count_ + taken);
    const double left = room_.low.x + wider * room_.width() / columns * taken;
    consider({{room_.low.x, room_.high.y - room_.height() / rows}, {left, room_.high.y}},
             grid(room_, columns, rows, taken, left, count_), columns * rows - taken - count_);
  }

  // What is measured on the sheet are the vectors: their scale weighs more than the mechanism's.
  static double worth(const Arrangement& of) {
    const double vectors = of.vectors.scale.mm_per_unit;
    return vectors * vectors * of.lengths.scale.mm_per_unit;
  }
  static bool is_better(const Arrangement& a, const Arrangement& b) {
    return std::pair(worth(a), -a.empty_cells) > std::pair(worth(b), -b.empty_cells);
  }

  void consider(const drawings::Box& for_mechanism, std::vector<drawings::Box> cells, int empty_cells) {
    for (drawings::Box& cell : cells) cell.high.y -= caption_height;
    const double height = cells.front().height();
    constexpr double lowest = 25;  // mm: a picture needs some height for letters alone
    if (height < lowest) return;
    try {
      const Fit lengths = fit_lengths(for_mechanism, request_, 1000 / mechanism_.reach(), [&](const Scale& scale) {
        Extent extent;
        mechanism_.include(extent, scale);
        return extent.box();
      });
      const Arrangement found{cells, empty_cells, lengths, fit_polygon(polygon_, cells.front(), request_.language)};
      if (!best_ || is_better(found, *best_)) best_ = found;
    } catch (const BadGivens& refused) {
      refusal_ = refused;
    }
  }

  const MechanismFigure& mechanism_;
  const VectorPolygon& polygon_;
  int count_;
  const SheetRequest& request_;
  drawings::Box room_;
  std::optional<Arrangement> best_;
  std::optional<BadGivens> refusal_;
};

}  // namespace

std::vector<Picture> pictures_of(const VectorPolygon& polygon, const std::vector<int>& figures) {
  std::vector<Picture> all;
  int step = 0;
  for (const PolygonSide* side : drawn_sides(polygon.right)) {
    if (side->is_unknown()) break;
    ++step;
    all.push_back({{.steps = step, .first_numbered = step}, known(*side)});
  }
  const int last = steps_of_sides(polygon);
  all.push_back({{.steps = last, .first_numbered = step + 1, .closed = false}, directions(polygon)});
  all.push_back({{.steps = last, .numbered = false}, {"the polygon, closed", "il poligono chiuso"}});
  assert(figures.size() <= all.size());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    Words& caption = all[all.size() - figures.size() + i].caption;
    caption.english += fmt::format(" (figure {})", figures[i]);
    caption.italian += fmt::format(" (figura {})", figures[i]);
  }
  return all;
}

std::vector<Scale> draw_pictures(DrawnSheet& onto, const MechanismFigure& mechanism, const VectorPolygon& polygon,
                                 const std::vector<Picture>& pictures, const SheetRequest& request) {
  const Arrangement where = Arranger(mechanism, polygon, pictures.size(), request).best();
  Plot small(onto, where.lengths.origin, where.lengths.scale);
  mechanism.draw(small);
  const drawings::Point first = centre(where.cells.front());
  char letter = 'a';
  for (std::size_t i = 0; i < pictures.size(); ++i, ++letter) {
    const drawings::Box& cell = where.cells[i];
    const drawings::Point origin{where.vectors.origin.x + centre(cell).x - first.x,
                                 where.vectors.origin.y + centre(cell).y - first.y};
    Plot plot(onto, origin, where.vectors.scale);
    draw_polygon(plot, polygon, pictures[i].stage);
    plot.mark(drawings::Writing{.text = fmt::format("{})  {}", letter, pictures[i].caption.in(request.language)),
                                .baseline = {cell.low.x + 3, cell.high.y + 1},
                                .size = caption_size});
  }
  return {where.lengths.scale, where.vectors.scale};
}

}  // namespace epure::rivals_polygons
