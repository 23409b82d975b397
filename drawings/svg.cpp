// A page to SVG. Written directly rather than by Cairo: every mark is one element with its own id, coordinates are
// millimetres, and nothing depends on what was drawn before.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "drawings/check_page.h"
#include "drawings/grid.h"
#include "drawings/page.h"
#include "drawings/typeset.h"
#include "drawings/vectors.h"

namespace epure::drawings {
namespace {

// Five decimals of a millimetre: a hundredth of a micrometre, far below the grid. No trailing zeros, no "-0".
std::string number(double value) {
  std::string text = fmt::format("{:.5f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string pair(Point p) { return number(p.x) + " " + number(p.y); }

template <class ToPage>
std::string path_data(const Path& path, ToPage to_page) {
  std::string d = "M" + pair(to_page(path.start));
  for (const Piece& piece : path.pieces) {
    if (piece.straight)
      d += " L" + pair(to_page(piece.end));
    else
      d += " C" + pair(to_page(piece.first_control)) + " " + pair(to_page(piece.second_control)) + " " +
           pair(to_page(piece.end));
  }
  return path.closed ? d + " Z" : d;
}

std::string colour_code(const Colour& c) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(part * 255)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(c.red), byte(c.green), byte(c.blue));
}

void set(pugi::xml_node element, const char* attribute, const std::string& value) {
  element.append_attribute(attribute) = value.c_str();
}

pugi::xml_node add(pugi::xml_node parent, const char* element) { return parent.append_child(element); }

void add_text(pugi::xml_node parent, const char* element, const std::string& id, const std::string& text) {
  pugi::xml_node child = add(parent, element);
  set(child, "id", id);
  child.text() = text.c_str();
}

class Writer {
 public:
  explicit Writer(const Page& page)
      : page_(page), left_(on_grid(page.extent.low.x)), top_(on_grid(page.extent.high.y)) {
    root_ = add(document_, "svg");
    write_head();
    definitions_ = add(root_, "defs");
    marks_ = add(root_, "g");
    set(marks_, "fill", "none");
    set(marks_, "stroke-linejoin", "round");
    words_ = add(root_, "g");
    // Seen are the outlines; these letters lie over them unseen, to be found, selected and read aloud.
    set(words_, "fill-opacity", "0");
    set(words_, "font-family", "'STIX Two Text', serif");
  }

  std::string write() {
    for (const Primitive& primitive : page_.primitives) std::visit(*this, primitive);
    if (!definitions_.first_child()) root_.remove_child(definitions_);
    std::ostringstream out;
    document_.save(out, " ", pugi::format_indent | pugi::format_no_declaration, pugi::encoding_utf8);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + out.str();
  }

  void operator()(const Stroke& stroke) {
    pugi::xml_node line = add_mark(stroke.path, stroke.name, stroke.clip);
    set(line, "stroke", colour_code(stroke.colour));
    if (stroke.colour.opacity < 1) set(line, "stroke-opacity", number(stroke.colour.opacity));
    set(line, "stroke-width", number(stroke.width));
    std::string dashes;
    for (const double dash : stroke.dashes) dashes += (dashes.empty() ? "" : " ") + number(dash);
    if (!dashes.empty()) set(line, "stroke-dasharray", dashes);
  }

  void operator()(const Fill& fill) { paint(add_mark(fill.path, fill.name, fill.clip), fill.colour); }

  void operator()(const PlacedText& text) {
    const SetText set_text = typeset(text.text, text.size, text.weight);
    pugi::xml_node outlines = add(marks_, "g");
    paint(outlines, text.colour);
    std::string letters;
    for (const GlyphRun& run : set_text.runs) letters += add_run(outlines, run, text.baseline);
    for (const Path& arrow : set_text.arrows)
      set(add(outlines, "path"), "d", path_data(arrow, [&](Point p) { return unrounded(text.baseline + p); }));
    add_words(letters, text, set_text.extent.width);
  }

 private:
  void write_head() {
    const std::string title = inner_id("title"), description = inner_id("desc");
    const char* language = page_.language == Language::italian ? "it" : "en";
    set(root_, "xmlns", "http://www.w3.org/2000/svg");
    set(root_, "xmlns:xlink", "http://www.w3.org/1999/xlink");
    set(root_, "id", page_.id);
    set(root_, "width", number(page_.extent.width()) + "mm");
    set(root_, "height", number(page_.extent.height()) + "mm");
    set(root_, "viewBox", "0 0 " + number(page_.extent.width()) + " " + number(page_.extent.height()));
    set(root_, "lang", language);
    set(root_, "xml:lang", language);
    set(root_, "role", "img");
    set(root_, "aria-labelledby", page_.description.empty() ? title : title + " " + description);
    add_text(root_, "title", title, page_.title);
    if (!page_.description.empty()) add_text(root_, "desc", description, page_.description);
  }

  Point rounded(Point p) const { return {on_grid(p.x) - left_, top_ - on_grid(p.y)}; }
  Point unrounded(Point p) const { return {p.x - left_, top_ - p.y}; }

  // Names start with a letter, a digit or an underscore, so an id with two hyphens is never that of a mark.
  std::string inner_id(const std::string& what) const { return page_.id + "--" + what; }

  std::string mark_id(const std::string& name) {
    std::string id = page_.id + "-" + name;
    for (int count = 2; !ids_.insert(id).second; ++count) id = fmt::format("{}-{}-{}", page_.id, name, count);
    return id;
  }

  pugi::xml_node add_mark(const Path& path, const std::string& name, const std::optional<Box>& clip) {
    pugi::xml_node mark = add(marks_, "path");
    if (!name.empty()) set(mark, "id", mark_id(name));
    set(mark, "d", path_data(path, [this](Point p) { return rounded(p); }));
    if (clip) set(mark, "clip-path", "url(#" + clip_id(*clip) + ")");
    return mark;
  }

  static void paint(pugi::xml_node element, const Colour& colour) {
    set(element, "fill", colour_code(colour));
    if (colour.opacity < 1) set(element, "fill-opacity", number(colour.opacity));
  }

  std::string clip_id(const Box& clip) {
    const Point corner = rounded({clip.low.x, clip.high.y});
    const Point opposite = rounded({clip.high.x, clip.low.y});
    const std::string size = pair(opposite - corner), key = pair(corner) + " " + size;
    const auto [entry, is_new] = clips_.try_emplace(key, inner_id(fmt::format("clip-{}", clips_.size() + 1)));
    if (is_new) {
      pugi::xml_node path = add(definitions_, "clipPath");
      set(path, "id", entry->second);
      pugi::xml_node window = add(path, "rect");
      set(window, "x", number(corner.x));
      set(window, "y", number(corner.y));
      set(window, "width", number(opposite.x - corner.x));
      set(window, "height", number(opposite.y - corner.y));
    }
    return entry->second;
  }

  // Returns the characters the run stands for.
  std::string add_run(pugi::xml_node parent, const GlyphRun& run, Point baseline) {
    const double scale = run.size / units_per_em;
    const Point start = run.glyphs.front().at;
    pugi::xml_node group = add(parent, "g");
    set(group, "transform",
        fmt::format("translate({}) scale({:.7g} {:.7g})", pair(unrounded(baseline + start)), scale, -scale));
    std::string letters;
    for (const SetGlyph& glyph : run.glyphs) {
      letters += glyph.text;
      const std::string id = glyph_id(run.face, glyph.index);
      if (id.empty()) continue;
      const Point at = (1 / scale) * (glyph.at - start);
      pugi::xml_node use = add(group, "use");
      set(use, "xlink:href", "#" + id);
      if (std::abs(at.x) > 0.01) set(use, "x", fmt::format("{:.0f}", at.x));
      if (std::abs(at.y) > 0.01) set(use, "y", fmt::format("{:.0f}", at.y));
    }
    return letters;
  }

  // The id of the outline; empty for a glyph without ink.
  std::string glyph_id(Face face, unsigned glyph) {
    if (is_nothing(ink(face, glyph))) return {};
    const std::string id = inner_id(fmt::format("glyph-{}-{}", "ribm"[static_cast<int>(face)], glyph));
    if (ids_.insert(id).second) {
      std::string d;
      for (const Path& contour : outline(face, glyph)) d += path_data(contour, [](Point p) { return p; });
      pugi::xml_node path = add(definitions_, "path");
      set(path, "id", id);
      set(path, "d", d);
    }
    return id;
  }

  void add_words(const std::string& letters, const PlacedText& text, double width) {
    if (letters.find_first_not_of(' ') == std::string::npos) return;
    const Point at = unrounded(text.baseline);
    pugi::xml_node words = add(words_, "text");
    set(words, "x", number(at.x));
    set(words, "y", number(at.y));
    set(words, "font-size", number(text.size));
    set(words, "textLength", number(width));
    set(words, "lengthAdjust", "spacingAndGlyphs");
    words.text() = letters.c_str();
  }

  const Page& page_;
  double left_, top_;  // mm, the upper left corner of the page, moved to the grid
  pugi::xml_document document_;
  pugi::xml_node root_, definitions_, marks_, words_;
  std::set<std::string> ids_;
  std::map<std::string, std::string> clips_;  // box to id
};

}  // namespace

std::string write_svg(const Page& page) {
  check(page);
  return Writer(page).write();
}

}  // namespace epure::drawings
