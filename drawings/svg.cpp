// A page to SVG: drawn by Cairo, then finished. Cairo knows neither millimetres nor words nor names; its ids depend
// on what was drawn before, and its letters are outlines that nothing can find.
#include <fmt/format.h>

#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "drawings/check_page.h"
#include "drawings/grid.h"
#include "drawings/page.h"
#include "drawings/paint.h"
#include "drawings/stopwatch.h"
#include "drawings/typeset.h"

namespace epure::drawings {
namespace {

// Five decimals, far below the grid in millimetres as in points. No trailing zeros, no "-0".
std::string number(double value) {
  std::string text = fmt::format("{:.5f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string path_data(const Path& path, const Frame& frame) {
  const auto pair = [&](Point p) {
    const Point at = frame.rounded(p);
    return number(at.x) + " " + number(at.y);
  };
  std::string d = "M " + pair(path.start);
  for (const Piece& piece : path.pieces) {
    if (piece.straight)
      d += " L " + pair(piece.end);
    else
      d += " C " + pair(piece.first_control) + " " + pair(piece.second_control) + " " + pair(piece.end);
  }
  return path.closed ? d + " Z" : d;
}

void set(pugi::xml_node element, const char* attribute, const std::string& value) {
  pugi::xml_attribute there = element.attribute(attribute);
  if (!there) there = element.append_attribute(attribute);
  there = value.c_str();
}

void expect(bool holds, const char* otherwise) {
  if (!holds) throw std::logic_error(fmt::format("an SVG of Cairo is not as it was known to be: {}", otherwise));
}

bool is_a(pugi::xml_node element, std::string_view name) { return element.name() == name; }

void move_children(pugi::xml_node from, pugi::xml_node to) {
  while (pugi::xml_node child = from.first_child()) to.append_move(child);
}

// The element of a line or an area, inside of its clip; null when nothing of it can be seen, which Cairo leaves out.
pugi::xml_node element_of_mark(pugi::xml_node drawn) {
  pugi::xml_node element = drawn;
  do {
    expect(element.first_child() == element.last_child(), "a mark in several parts");
    element = element.first_child();
  } while (is_a(element, "g"));
  expect(!element || is_a(element, "path"), "a mark that is no path");
  expect(!element.attribute("transform"), "a mark that is not measured in points");
  return element;
}

class Finisher {
 public:
  explicit Finisher(const Page& page) : page_(page), frame_(page.extent) {
    expect(document_.load_string(paint_svg(page).c_str()), "it is no XML");
    root_ = document_.child("svg");
    definitions_ = root_.child("defs");
  }

  std::string finish() {
    write_head();
    gather_marks();
    note_definitions();
    rename_references(marks_);
    rename_definitions();
    write_words();
    std::ostringstream out;
    document_.save(out, " ", pugi::format_indent | pugi::format_no_declaration, pugi::encoding_utf8);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + out.str();
  }

 private:
  void write_head() {
    const std::string title = inner_id("title"), description = inner_id("desc");
    const char* language = page_.language == Language::italian ? "it" : "en";
    root_.remove_attribute("version");
    set(root_, "id", page_.id);
    set(root_, "width", number(page_.extent.width()) + "mm");
    set(root_, "height", number(page_.extent.height()) + "mm");
    set(root_, "lang", language);
    set(root_, "xml:lang", language);
    set(root_, "role", "img");
    set(root_, "aria-labelledby", page_.description.empty() ? title : title + " " + description);
    if (!page_.description.empty()) prepend_text("desc", description, page_.description);
    prepend_text("title", title, page_.title);
  }

  void prepend_text(const char* element, const std::string& id, const std::string& text) {
    pugi::xml_node child = root_.prepend_child(element);
    set(child, "id", id);
    child.text() = text.c_str();
  }

  // What Cairo drew page by page, one a primitive, on one page and with names.
  void gather_marks() {
    marks_ = root_.append_child("g");
    pugi::xml_node pages = root_.child("pageSet"), page = pages.first_child();
    for (const Primitive& primitive : page_.primitives) {
      const pugi::xml_node drawn = page.child("g");
      expect(!drawn.empty(), "a primitive without its page");
      std::visit([&](const auto& kind) { name(drawn, kind); }, primitive);
      move_children(drawn, marks_);
      page = page.next_sibling();
    }
    for (int empty = 0; empty < 2; ++empty, page = page.next_sibling())
      expect(page && !page.child("g").first_child(), "a page that belongs to no primitive");
    expect(!page, "too many pages");
    root_.remove_child(pages);
  }

  // What has a name is found by it and can be measured, also where Cairo left out what cannot be seen.
  template <class Mark>
  void name(pugi::xml_node drawn, const Mark& mark) {
    pugi::xml_node element = element_of_mark(drawn);
    if (mark.name.empty()) return;
    if (!element) {
      element = drawn.append_child("path");
      set(element, "style", "fill:none;stroke:none;");
      set(element, "d", path_data(mark.path, frame_));
    }
    set(element, "id", mark_id(mark.name));
  }
  void name(pugi::xml_node, const PlacedText&) {}

  // Names start with a letter, a digit or an underscore, so an id with two hyphens is never that of a mark.
  std::string inner_id(const std::string& what) const { return page_.id + "--" + what; }

  std::string mark_id(const std::string& name) {
    std::string id = page_.id + "-" + name;
    for (int count = 2; !ids_.insert(id).second; ++count) id = fmt::format("{}-{}-{}", page_.id, name, count);
    return id;
  }

  void note_definitions() {
    for (pugi::xml_node clip : definitions_.children("clipPath")) defined_[clip.attribute("id").value()] = {clip, ""};
    for (pugi::xml_node glyph : definitions_.child("g").children("symbol"))
      defined_[glyph.attribute("id").value()] = {glyph, ""};
  }

  // Numbered in the order of their first use.
  void rename_references(pugi::xml_node parent) {
    for (pugi::xml_node element = parent.first_child(); element;) {
      const pugi::xml_node next = element.next_sibling();
      if (const pugi::xml_attribute clip = element.attribute("clip-path")) {
        const std::string_view url = clip.value();  // url(#clip1)
        set(element, "clip-path", "url(#" + new_id(std::string(url.substr(5, url.size() - 6)), "clip") + ")");
      }
      if (is_a(element, "use"))
        rename_glyph(element);
      else
        rename_references(element);
      element = next;
    }
  }

  void rename_glyph(pugi::xml_node use) {
    const std::string old_id = use.attribute("xlink:href").value() + 1;  // #glyph0-1
    const pugi::xml_node symbol = definition(old_id).element;
    if (*symbol.child("path").attribute("d").value() == '\0')
      use.parent().remove_child(use);  // a space
    else
      set(use, "xlink:href", "#" + new_id(old_id, "glyph"));
  }

  struct Definition {
    pugi::xml_node element;
    std::string id;  // new; empty while nothing refers to it
  };

  Definition& definition(const std::string& old_id) {
    const auto found = defined_.find(old_id);
    expect(found != defined_.end(), "a reference to nothing");
    return found->second;
  }

  const std::string& new_id(const std::string& old_id, const std::string& kind) {
    Definition& found = definition(old_id);
    if (found.id.empty()) found.id = inner_id(fmt::format("{}-{}", kind, ++counts_[kind]));
    return found.id;
  }

  // What nothing refers to (a glyph for what a font lacks, spaces) is left out.
  void rename_definitions() {
    for (const auto& [old_id, definition] : defined_) {
      pugi::xml_node element = definition.element;
      if (definition.id.empty())
        element.parent().remove_child(element);
      else
        set(element, "id", definition.id);
    }
    const pugi::xml_node glyphs = definitions_.child("g");
    if (!glyphs.first_child()) definitions_.remove_child(glyphs);
    if (!definitions_.first_child()) root_.remove_child(definitions_);
  }

  // Seen are the outlines; these letters lie over them unseen, to be found, selected and read aloud.
  void write_words() {
    pugi::xml_node words = root_.append_child("g");
    set(words, "fill-opacity", "0");
    set(words, "font-family", "'STIX Two Text', serif");
    for (const Primitive& primitive : page_.primitives)
      if (const auto* text = std::get_if<PlacedText>(&primitive)) add_words(words, *text);
  }

  void add_words(pugi::xml_node words, const PlacedText& text) const {
    const SetText& set_text = typeset(text.text, text.size, text.weight);
    std::string letters;
    for (const GlyphRun& run : set_text.runs)
      for (const SetGlyph& glyph : run.glyphs) letters += glyph.text;
    if (letters.find_first_not_of(' ') == std::string::npos) return;
    const Point at = frame_.unrounded(text.baseline);
    pugi::xml_node element = words.append_child("text");
    set(element, "x", number(at.x));
    set(element, "y", number(at.y));
    set(element, "font-size", number(text.size * points_per_mm));
    set(element, "textLength", number(set_text.extent.width * points_per_mm));
    set(element, "lengthAdjust", "spacingAndGlyphs");
    element.text() = letters.c_str();
  }

  const Page& page_;
  Frame frame_;
  pugi::xml_document document_;
  pugi::xml_node root_, definitions_, marks_;
  std::set<std::string> ids_;
  std::map<std::string, Definition> defined_;  // by Cairo's id
  std::map<std::string, int> counts_;
};

}  // namespace

std::string write_svg(const Page& page) {
  const Timed timed(Work::svg);
  check(page);
  return Finisher(page).finish();
}

}  // namespace epure::drawings
