#include "bench/recording.h"

#include <array>
#include <cstring>
#include <initializer_list>

#include "drawings/paths/grid.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/typeset.h"

namespace epure::drawings {
namespace {

class Recorder {
 public:
  void begin(const Page& page) {
    frame_ = Frame(page.extent);
    call('p', {page.extent.width() * points_per_mm, page.extent.height() * points_per_mm});
  }

  void operator()(const Stroke& stroke) {
    call('(');
    clip(stroke.clip);
    trace(stroke.path);
    ink(stroke.colour);
    call('w', {stroke.width * points_per_mm});
    call('d', {static_cast<double>(stroke.dashes.size())});
    for (const double dash : stroke.dashes) number(dash * points_per_mm);
    call('S');
    call(')');
  }

  void operator()(const Fill& fill) {
    call('(');
    clip(fill.clip);
    trace(fill.path);
    ink(fill.colour);
    call('F');
    call(')');
  }

  void operator()(const PlacedText& text) {
    const SetText& set = typeset(text.text, text.size, text.weight);
    ink(text.colour);
    for (const GlyphRun& run : set.runs) {
      const Point at = frame_.unrounded(text.baseline + run.start);
      call('t', {static_cast<double>(run.face), run.size * points_per_mm, at.x, at.y,
                 static_cast<double>(run.letters.size())});
      calls_ += run.letters;
    }
    for (const Path& arrow : set.arrows) {
      add(arrow, [&](Point p) { return frame_.unrounded(text.baseline + p); });
      call('F');
    }
  }

  std::string result() && { return std::move(calls_); }

 private:
  void number(double value) {
    std::array<char, sizeof value> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    calls_.append(bytes.data(), bytes.size());
  }
  void call(char name, std::initializer_list<double> numbers = {}) {
    calls_ += name;
    for (const double value : numbers) number(value);
  }

  void ink(const Colour& c) { call('i', {c.red, c.green, c.blue, c.opacity}); }

  void clip(const std::optional<Box>& box) {
    if (!box) return;
    trace(polyline({box->low, {box->high.x, box->low.y}, box->high, {box->low.x, box->high.y}}, true));
    call('k');
  }

  void trace(const Path& path) {
    add(path, [this](Point p) { return frame_.rounded(p); });
  }

  template <class ToPage>
  void add(const Path& path, ToPage to_page) {
    call('n');
    const Point start = to_page(path.start);
    call('m', {start.x, start.y});
    for (const Piece& piece : path.pieces) {
      const Point end = to_page(piece.end);
      if (piece.straight) {
        call('l', {end.x, end.y});
      } else {
        const Point a = to_page(piece.first_control), b = to_page(piece.second_control);
        call('c', {a.x, a.y, b.x, b.y, end.x, end.y});
      }
    }
    if (path.closed) call('z');
  }

  Frame frame_{Box{}};
  std::string calls_;
};

}  // namespace

std::string record(const std::vector<Page>& pages) {
  Recorder recorder;
  for (const Page& page : pages) {
    recorder.begin(page);
    for (const Primitive& primitive : page.primitives) std::visit(recorder, primitive);
  }
  return std::move(recorder).result();
}

}  // namespace epure::drawings
