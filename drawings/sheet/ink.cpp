#include "drawings/sheet/ink.h"

#include "drawings/paths/flatten.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

Box clipped(Box box, const std::optional<Box>& clip) { return clip ? intersection(box, *clip) : box; }

// By chords, not control points: the crop of a bare sheet should be tight around circles too.
Box covered(const Path& path) {
  Box box = nothing();
  for (const Point p : flatten(path, 0.01)) box = include(box, p);
  return box;
}

Box cover(const Stroke& stroke) { return clipped(grown(covered(stroke.path), stroke.width / 2), stroke.clip); }
Box cover(const Fill& fill) { return clipped(covered(fill.path), fill.clip); }
Box cover(const PlacedText& text) {
  const TextSize size = measure(text.text, text.size, text.weight);
  const Point b = text.baseline;
  return {{b.x, b.y - size.descent}, {b.x + size.width, b.y + size.ascent}};
}

}  // namespace

Box ink_box(const Primitive& primitive) {
  return std::visit([](const auto& p) { return cover(p); }, primitive);
}

Box ink_box(const std::vector<Primitive>& primitives) {
  Box box = nothing();
  for (const Primitive& primitive : primitives) box = include(box, ink_box(primitive));
  return box;
}

}  // namespace epure::drawings
