#include "drawings/files/check_page.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "drawings/text/unicode.h"

namespace epure::drawings {
namespace {

constexpr double largest_page = 2000;                                           // mm, either side
constexpr double widest_line = 50, longest_dash = 1000, largest_letters = 100;  // mm

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         c == '-';
}
bool starts_id(char c) { return is_plain(c) && c != '.' && c != '-'; }
// What may stand in an id, in a CSS selector (after its prefix) and in a file name.
bool is_id(std::string_view id) {
  for (const char c : id)
    if (!is_plain(c)) return false;
  return !id.empty() && starts_id(id.front());
}

struct Describe {
  std::string operator()(const Stroke& s) const {
    return s.name.empty() ? "a line" : fmt::format("line '{}'", s.name);
  }
  std::string operator()(const Fill& f) const {
    return f.name.empty() ? "an area" : fmt::format("area '{}'", f.name);
  }
  std::string operator()(const PlacedText& t) const { return fmt::format("text \"{}\"", t.text); }
};

// Checks the numbers of a page, or of one primitive on it, which is named in every complaint. There are thousands of
// numbers, so nothing is put into words before there is a complaint.
class Checker {
 public:
  explicit Checker(const Page& page, const Primitive* primitive = nullptr) : page_(page), primitive_(primitive) {}

  void number(double value, double low, double high, std::string_view what, std::string_view of = {}) const {
    if (!(value >= low && value <= high))  // NaN fails this too
      complain(fmt::format("{}{} is {}, and must lie between {} and {}", what, of, value, low, high));
  }
  void point(Point p, std::string_view what) const {
    number(p.x, -farthest, farthest, "x of ", what);
    number(p.y, -farthest, farthest, "y of ", what);
  }
  void box(const Box& b, std::string_view what) const {
    point(b.low, what);
    point(b.high, what);
    number(b.width(), 0, 2 * farthest, "width of ", what);
    number(b.height(), 0, 2 * farthest, "height of ", what);
  }
  void path(const Path& path) const {
    point(path.start, "the start");
    for (const Piece& piece : path.pieces) {
      if (!piece.straight) {
        point(piece.first_control, "a control point");
        point(piece.second_control, "a control point");
      }
      point(piece.end, "a corner");
    }
  }
  void colour(const Colour& c) const {
    number(c.red, 0, 1, "red");
    number(c.green, 0, 1, "green");
    number(c.blue, 0, 1, "blue");
    number(c.opacity, 0, 1, "the opacity");
  }
  void name(const std::string& name) const {
    if (!name.empty() && !is_id(name))
      complain("a name holds only letters, digits, _ . and - and starts with a letter, a digit or _");
  }

  void operator()(const Stroke& stroke) const {
    name(stroke.name);
    path(stroke.path);
    colour(stroke.colour);
    if (stroke.clip) box(*stroke.clip, "the clip box");
    number(stroke.width, file_resolution, widest_line, "the line width");
    double period = 0;
    for (const double dash : stroke.dashes) {
      number(dash, 0, longest_dash, "a dash");
      period += dash;
    }
    // Shorter periods would make a line of millions of dashes.
    if (!stroke.dashes.empty()) number(period, 0.05, longest_dash, "the sum of the dashes");
  }
  void operator()(const Fill& fill) const {
    name(fill.name);
    path(fill.path);
    colour(fill.colour);
    if (fill.clip) box(*fill.clip, "the clip box");
  }
  void operator()(const PlacedText& text) const {
    point(text.baseline, "the baseline");
    number(text.size, file_resolution, largest_letters, "the letter size");
    colour(text.colour);
  }

 private:
  [[noreturn]] void complain(const std::string& why) const {
    const std::string who = primitive_ ? fmt::format("sheet '{}', {}", page_.id, std::visit(Describe{}, *primitive_))
                                       : fmt::format("page '{}'", page_.id);
    throw std::invalid_argument(fmt::format("{}: {}", who, why));
  }

  const Page& page_;
  const Primitive* primitive_;
};

}  // namespace

void check_plain_text(const std::string& text, const char* what) {
  try {
    characters(text);
  } catch (const std::invalid_argument& reason) {
    throw std::invalid_argument(fmt::format("{}: {}", what, reason.what()));
  }
}

void check(const Page& page) {
  if (!is_id(page.id)) throw std::invalid_argument(fmt::format("'{}' cannot be the id of a drawing", page.id));
  check_plain_text(page.title, "the title");
  check_plain_text(page.description, "the description");
  const Checker whole(page);
  whole.box(page.extent, "the page");
  whole.number(page.extent.width(), 1, largest_page, "the width");
  whole.number(page.extent.height(), 1, largest_page, "the height");
  for (const Primitive& primitive : page.primitives) std::visit(Checker(page, &primitive), primitive);
}

}  // namespace epure::drawings
