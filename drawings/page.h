// A composed page: primitives in paper millimetres, in drawing order, ready for a writer. What a mark looks like
// (symbols, line types, label places) is decided before this point; how a file holds it, after.
#pragma once

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
};
struct Fill {
  Path path;
  Colour colour;
  std::optional<Box> clip = {};
  std::string name = {};
};
enum class Weight { regular, bold };
struct PlacedText {
  std::string text;  // rich text
  Point baseline;    // left end of the baseline
  double size = 3.5;
  Colour colour;
  Weight weight = Weight::regular;
  std::optional<std::size_t> row = {};  // of the table it is a cell of
};
using Primitive = std::variant<Stroke, Fill, PlacedText>;

struct Page {
  std::string id, title, description;
  Box extent;  // what of the paper the page shows: the whole sheet, or the crop of a bare one
  Language language = Language::english;
  std::vector<Primitive> primitives;
  bool is_paper =
      false;  // a whole sheet is white paper also on a screen's dark page; a bare drawing takes its ground
};

// Layout, symbols, styles, label placement. Deterministic. `conflicts`, when given, receives a sentence for every
// label that had to overlap something. Throws std::invalid_argument naming the mark for a coordinate that is not
// finite, TooFar (output.h) for one that is too large.
Page compose(const Sheet& sheet, std::vector<std::string>* conflicts = nullptr);

std::string write_pdf(const std::vector<Page>& pages, const std::string& document_title);
std::string write_svg(const Page& page);

}  // namespace epure::drawings
