// The shipped fonts. They are part of the program, so that nothing depends on the fonts of the machine, and no font
// can be missing or be replaced by another one. One thread at a time: FreeType faces hold state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drawings/picture.h"

struct FT_FaceRec_;

namespace epure::drawings {

enum class Face { regular, italic, bold, mathematics };

// All four fonts are drawn on a square of this many units.
inline constexpr double units_per_em = 1000;

struct ShapedGlyph {
  unsigned index = 0;
  Point at;          // font units, from the start of the letters
  std::string text;  // the characters it stands for, UTF-8 (several for a ligature); may be empty
};
struct ShapedLetters {
  std::vector<ShapedGlyph> glyphs;
  double advance = 0;  // font units
};

bool has_glyph(Face face, char32_t character);
// With kerning and ligatures. Throws std::invalid_argument for a character the face lacks.
ShapedLetters shape(Face face, std::string_view letters);
// The drawn part of a glyph in font units, y upwards; not `low <= high` when it draws nothing (a space).
Box ink(Face face, unsigned glyph);
std::vector<Path> outline(Face face, unsigned glyph);

// For the painter. Owned by this module.
FT_FaceRec_* freetype_face(Face face);

}  // namespace epure::drawings
