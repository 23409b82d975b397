// A composed page: primitives in paper millimetres, in drawing order, ready for a writer. What a mark looks like
// (symbols, line types, label places) is decided before this point; how a file holds it, after.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

struct Colour {
  double red = 0, green = 0, blue = 0, opacity = 1;
  bool operator==(const Colour&) const = default;
};
struct Stroke {
  Path path;
  double width = 0.25;              // mm
  std::vector<double> dashes = {};  // mm, empty: continuous
  Colour colour;
  std::optional<Box> clip = {};
  std::string name = {};  // id, or empty
  int step = 0;           // of the construction, which drew it; 0: it was there before, or nobody asked
};
struct Fill {
  Path path;
  Colour colour;
  std::optional<Box> clip = {};
  std::string name = {};
  int step = 0;
};
enum class Weight { regular, bold };
struct PlacedText {
  std::string text;  // rich text
  Point baseline;    // left end of the baseline
  double size = 3.5;
  Colour colour;
  Weight weight = Weight::regular;
  std::optional<std::size_t> row = {};  // of the table it is a cell of
  int step = 0;
  double anchor = 0;  // where it stays when it is set in other letters: 0 at its left end, 1 at its right end
};
using Primitive = std::variant<Stroke, Fill, PlacedText>;

// Those from this one on are drawn by the step.
inline void belongs_to(int step, std::vector<Primitive>& primitives, std::size_t from = 0) {
  for (std::size_t i = from; i < primitives.size(); ++i)
    std::visit([step](auto& primitive) { primitive.step = step; }, primitives[i]);
}

struct Page {
  std::string id, title, description;
  Box extent;  // what of the paper the page shows: the whole sheet, or the crop of a bare one
  Language language = Language::english;
  std::vector<Primitive> primitives;
  bool is_paper =
      false;  // a whole sheet is white paper also on a screen's dark page; a bare drawing takes its ground
  std::vector<std::string> steps = {};           // the construction's, from the first, in words (rich text)
  std::map<std::string, std::string> told = {};  // plain text of marks, by their names: for who points at them
};

// Layout, symbols, styles, label placement. Deterministic. `conflicts`, when given, receives a sentence for every
// label that had to overlap something. Throws std::invalid_argument naming the mark for a coordinate that is not
// finite, TooFar (output.h) for one that is too large.
Page compose(const Sheet& sheet, std::vector<std::string>* conflicts = nullptr);
// The same page, on which each primitive says which step drew it; and the steps.
Page compose_in_steps(const Sheet& sheet);
// What the page shows after this step.
Page after_step(Page page, int step);

// What a PDF says of itself, and what its reader shows beside the pages. Plain text; an empty one is left out.
struct Bookmark {
  std::string title;
  std::size_t page = 0;    // from 0
  bool is_within = false;  // below the last one that is not
};
// Leads from an area of one page to another page; both from 0.
struct Link {
  std::size_t on_page = 0;
  Box area;
  std::size_t to_page = 0;
};
struct Document {
  std::string title;
  std::string author = {}, subject = {};
  std::vector<Bookmark> bookmarks = {};
  std::vector<Link> links = {};
};

// All throw as pdf() and svg() do (output.h); bytes depend on the pages alone.
std::string write_pdf(const std::vector<Page>& pages, const Document& document);
std::string write_svg(const Page& page);
// For TeX and others that take no PDF. PostScript knows no transparency: the light areas are mixed with white, and
// lie below all else.
std::string write_eps(const Page& page);
// Its background is transparent unless the page is paper. The file says how large it is.
std::string write_png(const Page& page, double dots_per_inch);
struct Pixels {
  long width = 0, height = 0;
};
Pixels pixels(const Page& page, double dots_per_inch);
// A picture takes four bytes a pixel while it is painted.
inline constexpr long most_pixels = 80'000'000;

}  // namespace epure::drawings
