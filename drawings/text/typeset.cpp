#include "drawings/text/typeset.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "drawings/paths/vectors.h"
#include "drawings/stopwatch.h"
#include "drawings/text/rich_text.h"
#include "drawings/text/unicode.h"

namespace epure::drawings {
namespace {

// Proportions, in parts of the size of the letters.
constexpr double script_size = 0.7;
constexpr double lowered = 0.19;           // a subscript alone
constexpr double lowered_in_stack = 0.25;  // with a superscript above it
constexpr double raised = 0.38;
constexpr double before_script = 0.02, after_script = 0.05;
constexpr double least_script_gap = 0.1;  // between the two scripts of a stack
constexpr double arrow_gap = 0.1;         // above the ink of the letters
constexpr double arrow_least_length = 0.42;
constexpr double arrow_thickness = 0.045;
constexpr double arrow_head_length = 0.17, arrow_head_half_width = 0.085;
// An arrow over slanted letters looks centred a little to the right of the middle of their ink.
constexpr double arrow_lean = 0.05;

class Setter {
 public:
  explicit Setter(Weight weight) : upright_(weight == Weight::bold ? Face::bold : Face::regular) {}

  void set(const std::vector<Node>& nodes, double size) {
    for (const Node& node : nodes) set(node, size);
  }

  SetText result() && {
    const bool blank = is_nothing(ink_);
    text_.extent = {pen_.x, blank ? 0 : std::max(0.0, ink_.high.y), blank ? 0 : std::max(0.0, -ink_.low.y)};
    return std::move(text_);
  }

 private:
  void set(const Node& node, double size) {
    const Box around = std::exchange(ink_, nothing());
    set_letters(node.letters, node.italic ? Face::italic : upright_, size);
    set(node.group, size);
    if (node.arrow) draw_arrow(size, !node.group.empty() && node.group.front().italic);
    set_scripts(node, size);
    ink_ = include(around, ink_);
  }

  // Both scripts start beside the letters; the pen goes on after the longer one.
  void set_scripts(const Node& node, double size) {
    if (node.below.empty() && node.above.empty()) return;
    const Point start = pen_;
    const Box nucleus = ink_;
    const bool stacked = !node.below.empty() && !node.above.empty();
    double end = start.x, top_below = -INFINITY;
    if (!node.below.empty()) {
      pen_ = start + Point{before_script * size, -(stacked ? lowered_in_stack : lowered) * size};
      top_below = set_script(node.below, "_", size).high.y;
      end = pen_.x;
    }
    if (!node.above.empty()) {
      // Slanted letters and arrows reach over their advance; a superscript must not touch them.
      const double overhang = is_nothing(nucleus) ? 0 : std::max(0.0, nucleus.high.x - start.x);
      pen_ = start + Point{before_script * size + overhang, raised * size};
      pen_.y = std::max(pen_.y, top_below + least_script_gap * size);
      set_script(node.above, "^", size);
      end = std::max(end, pen_.x);
    }
    pen_ = {end + after_script * size, start.y};
  }

  Box set_script(const std::vector<Node>& script, const std::string& mark, double size) {
    const Box around = std::exchange(ink_, nothing());
    prefix_ = mark;
    set(script, script_size * size);
    const Box own = std::exchange(ink_, include(around, ink_));
    return own;
  }

  void set_letters(const std::string& letters, Face wanted, double size) {
    std::string same;
    Face face = wanted;
    for (const char32_t c : characters(letters)) {
      const Face next = face_for(c, wanted);
      if (next != face) set_run(std::exchange(same, {}), face, size);
      face = next;
      same += utf8(c);
    }
    set_run(same, face, size);
  }

  static Face face_for(char32_t c, Face wanted) {
    if (has_glyph(wanted, c)) return wanted;
    if (has_glyph(Face::mathematics, c)) return Face::mathematics;
    throw std::invalid_argument(
        fmt::format("the shipped fonts have no glyph for {} (U+{:04X})", utf8(c), static_cast<unsigned>(c)));
  }

  void set_run(const std::string& letters, Face face, double size) {
    if (letters.empty()) return;
    const double scale = size / units_per_em;
    const ShapedLetters& shaped = shape(face, letters);
    GlyphRun run{face, size, {}, letters, pen_};
    for (const ShapedGlyph& glyph : shaped.glyphs) {
      const Point at = pen_ + scale * glyph.at;
      if (!is_nothing(glyph.ink)) ink_ = include(ink_, Box{at + scale * glyph.ink.low, at + scale * glyph.ink.high});
      run.glyphs.push_back({glyph.index, at, std::exchange(prefix_, {}) + glyph.text});
    }
    pen_.x += scale * shaped.advance;
    text_.runs.push_back(std::move(run));
  }

  void draw_arrow(double size, bool slanted) {
    if (is_nothing(ink_)) throw std::invalid_argument("a vector's arrow has nothing to stand over");
    const double middle = (ink_.low.x + ink_.high.x) / 2 + (slanted ? arrow_lean * size : 0);
    const double half = std::max(arrow_least_length * size, ink_.width()) / 2;
    const double head = arrow_head_half_width * size, thin = arrow_thickness * size / 2;
    const double y = ink_.high.y + arrow_gap * size + head;
    const double left = middle - half, right = middle + half, neck = right - arrow_head_length * size;
    text_.arrows.push_back(polyline({{left, y - thin},
                                     {neck, y - thin},
                                     {neck, y - head},
                                     {right, y},
                                     {neck, y + head},
                                     {neck, y + thin},
                                     {left, y + thin}},
                                    true));
    ink_ = include(ink_, Box{{left, y - head}, {right, y + head}});
  }

  Face upright_;
  SetText text_;
  Point pen_;
  Box ink_ = nothing();  // of what belongs to the node being set
  std::string prefix_;   // goes before the text of the next glyph
};

struct Wish {
  std::string rich_text;
  double size = 0;
  Weight weight = Weight::regular;
  bool operator==(const Wish&) const = default;
};
struct HashOfWish {
  std::size_t operator()(const Wish& wish) const {
    return std::hash<std::string>()(wish.rich_text) ^ std::hash<double>()(wish.size);
  }
};

}  // namespace

const SetText& typeset(const std::string& rich_text, double size, Weight weight) {
  if (!std::isfinite(size) || size <= 0)
    throw std::invalid_argument(fmt::format("label \"{}\": a letter size of {} mm", rich_text, size));
  thread_local std::unordered_map<Wish, SetText, HashOfWish> known;
  const Wish wish{rich_text, size, weight};
  if (const auto found = known.find(wish); found != known.end()) return found->second;
  constexpr std::size_t most = 5000;  // some megabytes; a sheet has about a hundred
  if (known.size() == most) known.clear();
  const Timed timed(Work::text);
  Setter setter(weight);
  setter.set(parse(rich_text), size);
  return known.emplace(wish, std::move(setter).result()).first->second;
}

}  // namespace epure::drawings
