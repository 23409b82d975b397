// Letters set by HarfBuzz in the shipped fonts and no others, by any number of threads.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

enum class Face { regular, italic, bold, mathematics };

// All four fonts are drawn on a square of this many units. Letters are shaped and measured at this size, in whole
// units, and scaled afterwards: nothing is rounded, and every size has the same proportions.
inline constexpr double units_per_em = 1000;

struct ShapedGlyph {
  unsigned index = 0;
  Point at;          // font units, from the start of the letters
  Box ink;           // from the glyph's own place
  std::string text;  // the characters it stands for, UTF-8 (several for a ligature); may be empty
};
struct ShapedLetters {
  std::vector<ShapedGlyph> glyphs;
  double advance = 0;  // font units
};

// Everything here throws std::runtime_error when a shipped font is missing or is not what it should be.
bool has_glyph(Face face, char32_t character);
// With kerning and ligatures; stands until the next call in this thread. Throws std::invalid_argument for a character
// the face lacks.
const ShapedLetters& shape(Face face, const std::string& letters);
// The drawn part of a glyph in font units, y upwards; not `low <= high` when it draws nothing (a space).
Box ink(Face face, unsigned glyph);

}  // namespace epure::drawings
